#include "experiment/profile.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "export/gains.h"
#include "firmware_link/transport/open_board.h"

namespace breakaway::cli {

namespace {

using Json = nlohmann::ordered_json;

struct ProfileLine {
  std::string action, file, tuning;
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

Answer answerOf(const std::vector<RestoredRow>& rows) {
  std::string words;
  Json json{{"restored", Json::array()}};
  for (const RestoredRow& row : rows) {
    words +=
        row.name + ": " +
        (row.same ? row.accepted + " accepted\n" : row.wanted + " asked for, the board took " + row.accepted + "\n");
    json["restored"].push_back({{"name", row.name}, {"wanted", row.wanted}, {"accepted", row.accepted}});
  }
  return {words, asText(json)};
}

Result<Answer> restore(Drive& board, const Profile& profile, const ProfileLine& line) {
  const auto rows = restoreProfile(board, profile, line.options);
  if (rows) return answerOf(*rows);
  const bool other = rows.error().place == "profile";
  return other ? Error{line.file, rows.error().fact + ", with --any-board"} : rows.error();
}

/// Gains, observer and bandwidths of a tuning; the board's limits stay.
Result<Answer> restoreTuning(Drive& board, const TunedGains& gains) {
  using Settings = ControllerSettings;
  const std::pair<double Settings::*, double> tuned[] = {
      {&Settings::velocity_kp_A_s_per_rad, gains.velocityKp_A_s_per_rad},
      {&Settings::velocity_ki_A_per_rad, gains.velocityKi_A_per_rad},
      {&Settings::velocity_kd_A_s2_per_rad, gains.velocityKd_A_s2_per_rad},
      {&Settings::position_kp_A_per_rad, gains.positionKp_A_per_rad},
      {&Settings::position_ki_A_per_rad_s, gains.positionKi_A_per_rad_s},
      {&Settings::position_kd_A_s_per_rad, gains.positionKd_A_s_per_rad},
      {&Settings::observer_cutoff_rad_per_s, gains.cutoff_rad_per_s},
      {&Settings::nominal_inertia_kg_m2, gains.inertia_kg_m2},
      {&Settings::nominal_torque_constant_Nm_per_A, gains.torqueConstant_Nm_per_A},
      {&Settings::velocity_bandwidth_rad_per_s, gains.speedFilter_rad_per_s},
      {&Settings::current_bandwidth_rad_per_s, gains.currentBandwidth_rad_per_s}};
  Profile profile{board.identity().device, board.identity().firmware, board.settings(), {}};
  RestoreOptions options;
  for (const auto& [setting, value] : tuned) {
    profile.settings.*setting = value;
    for (const ProfileParameter& one : profileParameters()) {
      if (one.value == setting) options.only.emplace_back(one.name);
    }
  }
  const auto rows = restoreProfile(board, profile, options);
  return rows ? Result<Answer>(answerOf(*rows)) : Result<Answer>(rows.error());
}

Result<void> checkFiles(const ProfileLine& line) {
  if (line.file.empty() && line.tuning.empty()) return Error{"--profile", "is missing; restore also takes --tuning"};
  if (line.tuning.empty()) return {};
  if (line.action != "restore") return Error{"--tuning", "goes with restore only"};
  if (!line.file.empty() || !line.options.only.empty() || line.options.index_rad)
    return Error{"--tuning", "takes the place of --profile, --only and --index-rad"};
  return {};
}

Result<Answer> runProfile(const ProfileLine& line) {
  std::optional<Profile> profile;
  std::optional<TunedGains> gains;
  if (auto good = checkFiles(line); !good) return good.error();
  if (line.action == "save") {
    if (auto good = checkOutput(line.file); !good) return good.error();
  } else if (!line.tuning.empty()) {
    auto read = readTuning(line.tuning);
    if (!read) return read.error();
    gains = std::move(*read);
  } else {  // before the board is asked anything
    auto read = readProfile(line.file);
    if (!read) return read.error();
    profile = std::move(*read);
  }
  auto board = openBoard(line.board);
  if (!board) return board.error();
  if ((*board)->identity().axis != Axis::rotary)
    return Error{"board " + line.board.uri, "moves a linear axis, expected a rotor: profiles are of a rotor's board"};
  if (line.action == "save") return save(**board, line);
  if (gains) return restoreTuning(**board, *gains);
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
  command->add_option("--profile", line->file, "the profile, NAME.profile.json: written by save, else read");
  command->add_option("--tuning", line->tuning,
                      "in place of a profile, restore the gains, observer and bandwidths of tune's tuning.json; the "
                      "board's limits stay");
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
      "velocity_kp_A_s_per_rad\n"
      "  breakaway profile restore --board serial:ttyACM0 --tuning t/tuning.json");
  command->callback([line, &chosen] { chosen = [line] { return runProfile(*line); }; });
}

}  // namespace breakaway::cli
