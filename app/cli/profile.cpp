#include "experiment/profile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "cli/command.h"
#include "firmware_link/transport/open_board.h"

namespace breakaway::cli {

namespace {

struct ProfileLine {
  std::string action, file;
  BoardRequest board;
  RestoreOptions options;
};

Result<void> save(Drive& board, const ProfileLine& line) {
  const auto profile = profileOf(board);
  if (!profile) return profile.error();
  if (auto written = writeProfile(*profile, line.file); !written) return written;
  std::printf("%s: what %s is set to\n", line.file.c_str(), profile->device.c_str());
  return {};
}

Result<void> compare(Drive& board, const Profile& profile) {
  const auto here = profileOf(board);
  if (!here) return here.error();
  if (here->device != profile.device || here->firmware != profile.firmware) {
    std::printf("saved from %s (%s), compared with %s (%s)\n", profile.device.c_str(), profile.firmware.c_str(),
                here->device.c_str(), here->firmware.c_str());
  }
  const auto rows = compareProfiles(*here, profile);
  const auto differing = std::count_if(rows.begin(), rows.end(), [](const ProfileRow& row) { return !row.same; });
  if (differing == 0) std::printf("nothing differs\n");
  for (const ProfileRow& row : rows) {
    if (!row.same)
      std::printf("%s: %s on the board, %s in the profile\n", row.name.c_str(), row.here.c_str(), row.there.c_str());
  }
  return {};
}

Result<void> restore(Drive& board, const Profile& profile, const ProfileLine& line) {
  const auto rows = restoreProfile(board, profile, line.options);
  if (!rows) {
    const bool other = rows.error().place == "profile";
    return other ? Error{line.file, rows.error().fact + ", with --any-board"} : rows.error();
  }
  for (const RestoredRow& row : *rows) {
    if (row.same) {
      std::printf("%s: %s accepted\n", row.name.c_str(), row.accepted.c_str());
    } else {
      std::printf("%s: %s asked for, the board took %s\n", row.name.c_str(), row.wanted.c_str(), row.accepted.c_str());
    }
  }
  return {};
}

Result<void> runProfile(const ProfileLine& line) {
  std::optional<Profile> profile;
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
  command->callback([line, &chosen] { chosen = [line] { return runProfile(*line); }; });
}

}  // namespace breakaway::cli
