#include "experiment/profile.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "firmware_link/transport/open_board.h"

namespace breakaway::cli {

namespace {

using Json = nlohmann::ordered_json;

struct ProfileLine {
  std::string action, file;
  BoardRequest board;
  RestoreOptions options;
};

Result<Answer> save(Drive& board, const ProfileLine& line) {
  const auto profile = profileOf(board);
  if (!profile) return profile.error();
  if (auto written = writeProfile(*profile, line.file); !written) return written.error();
  const Json json{{"profile", line.file}, {"device", profile->device}};
  return Answer{line.file + ": what " + profile->device + " is set to\n", asText(json)};
}

Result<Answer> compare(Drive& board, const Profile& profile) {
  const auto here = profileOf(board);
  if (!here) return here.error();
  std::string words;
  if (here->device != profile.device || here->firmware != profile.firmware) {
    words = "saved from " + profile.device + " (" + profile.firmware + "), compared with " + here->device + " (" +
            here->firmware + ")\n";
  }
  Json json{{"saved_from", profile.device}, {"compared_with", here->device}, {"differing", Json::array()}};
  for (const ProfileRow& row : compareProfiles(*here, profile)) {
    if (row.same) continue;
    words += row.name + ": " + row.here + " on the board, " + row.there + " in the profile\n";
    json["differing"].push_back({{"name", row.name}, {"here", row.here}, {"there", row.there}});
  }
  if (json["differing"].empty()) words += "nothing differs\n";
  return Answer{words, asText(json)};
}

Result<Answer> restore(Drive& board, const Profile& profile, const ProfileLine& line) {
  const auto rows = restoreProfile(board, profile, line.options);
  if (!rows) {
    const bool other = rows.error().place == "profile";
    return other ? Error{line.file, rows.error().fact + ", with --any-board"} : rows.error();
  }
  std::string words;
  Json json{{"restored", Json::array()}};
  for (const RestoredRow& row : *rows) {
    words +=
        row.name + ": " +
        (row.same ? row.accepted + " accepted\n" : row.wanted + " asked for, the board took " + row.accepted + "\n");
    json["restored"].push_back({{"name", row.name}, {"wanted", row.wanted}, {"accepted", row.accepted}});
  }
  return Answer{words, asText(json)};
}

Result<Answer> runProfile(const ProfileLine& line) {
  std::optional<Profile> profile;
  if (line.action == "save") {
    if (auto good = checkOutput(line.file); !good) return good.error();
  }
  if (line.action != "save") {  // before the board is asked anything
    auto read = readProfile(line.file);
    if (!read) return read.error();
    profile = std::move(*read);
  }
  auto board = openBoard(line.board);
  if (!board) return board.error();
  if ((*board)->identity().axis != Axis::rotary)
    return Error{"board " + line.board.uri, "moves a linear axis, expected a rotor: profiles are of a rotor's board"};
  if (line.action == "save") return save(**board, line);
  return line.action == "compare" ? compare(**board, *profile) : restore(**board, *profile, line);
}

}  // namespace

void addProfile(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<ProfileLine>();
  auto* command = app.add_subcommand("profile", "Save what a board is set to, compare it with a file, or give it back");
  command->add_option("action", line->action, "save, compare or restore")
      ->required()
      ->check(CLI::IsMember({"save", "compare", "restore"}));
  command->add_option("--board", line->board.uri, "as for commission")->required();
  command->add_option("--profile", line->file, "the profile, NAME.profile.json: written by save, else read")
      ->required();
  command
      ->add_option("--only", line->options.only,
                   "restore these parameters alone, by their names in the file, with commas between them")
      ->delimiter(',');
  command->add_option("--index-rad", line->options.index_rad,
                      "where the board counts the encoder's index now, from homing; a friction table of several bins "
                      "needs it");
  command->add_flag("--any-board", line->options.anyBoard, "restore a profile that was saved from another board, too");
  command->footer(
      "Examples:\n"
      "  breakaway profile save --board serial:ttyACM0 --profile before.profile.json\n"
      "  breakaway profile restore --board serial:ttyACM0 --profile before.profile.json --only "
      "velocity_kp_A_s_per_rad");
  command->callback([line, &chosen] { chosen = [line] { return runProfile(*line); }; });
}

}  // namespace breakaway::cli
