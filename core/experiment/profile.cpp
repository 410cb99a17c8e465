#include "experiment/profile.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/json_object.h"

namespace breakaway {

namespace {

using Settings = ControllerSettings;
constexpr std::array<ProfileParameter, 13> parameters{
    {{"velocity_kp_A_s_per_rad", &Settings::velocity_kp_A_s_per_rad},
     {"velocity_ki_A_per_rad", &Settings::velocity_ki_A_per_rad},
     {"velocity_kd_A_s2_per_rad", &Settings::velocity_kd_A_s2_per_rad},
     {"position_kp_A_per_rad", &Settings::position_kp_A_per_rad},
     {"position_ki_A_per_rad_s", &Settings::position_ki_A_per_rad_s},
     {"position_kd_A_s_per_rad", &Settings::position_kd_A_s_per_rad},
     {"observer_cutoff_rad_per_s", &Settings::observer_cutoff_rad_per_s},
     {"nominal_inertia_kg_m2", &Settings::nominal_inertia_kg_m2},
     {"nominal_torque_constant_Nm_per_A", &Settings::nominal_torque_constant_Nm_per_A},
     {"current_limit_A", &Settings::current_limit_A},
     {"velocity_limit_rad_per_s", &Settings::velocity_limit_rad_per_s},
     {"velocity_bandwidth_rad_per_s", &Settings::velocity_bandwidth_rad_per_s},
     {"current_bandwidth_rad_per_s", &Settings::current_bandwidth_rad_per_s}}};

std::string numberText(double value) {
  return fmt::format("{:.9g}", value);
}

/// Whether `settings` say nothing of it.
bool isUnsaid(const Settings& settings, double Settings::*value) {
  return mayBeUnsaid(value) && !(settings.*value > 0.0);
}

std::string valueText(const Settings& settings, double Settings::*value) {
  return isUnsaid(settings, value) ? "not said" : numberText(settings.*value);
}

bool alike(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) { return sameSetting(x, y); });
}

bool alike(const FrictionCompensation& a, const FrictionCompensation& b) {
  for (size_t way = 0; way < 2; ++way) {
    if (!alike(a.coulomb_Nm[way], b.coulomb_Nm[way]) ||
        !alike(a.viscous_Nm_s_per_rad[way], b.viscous_Nm_s_per_rad[way]))
      return false;
  }
  return sameSetting(a.blend_rad_per_s, b.blend_rad_per_s) && sameSetting(a.cutoff_rad_per_s, b.cutoff_rad_per_s);
}

std::string frictionText(const std::optional<FrictionCompensation>& friction) {
  if (!friction) return "not taken";
  const auto& coulomb = friction->coulomb_Nm;
  if (coulomb[0].empty()) return "none";
  double sum = 0.0;
  for (const auto& way : coulomb) {
    for (const double one : way) sum += one;
  }
  return fmt::format("{} bins, {:.4g} Nm on average", coulomb[0].size(),
                     sum / static_cast<double>(coulomb[0].size() + coulomb[1].size()));
}

bool sameFriction(const std::optional<FrictionCompensation>& a, const std::optional<FrictionCompensation>& b) {
  const auto empty = [](const auto& one) { return !one || one->coulomb_Nm[0].empty(); };
  return (empty(a) && empty(b)) || (a && b && alike(*a, *b));
}

}  // namespace

std::span<const ProfileParameter> profileParameters() {
  return parameters;
}

bool mayBeUnsaid(double ControllerSettings::*setting) {
  return setting == &Settings::velocity_bandwidth_rad_per_s || setting == &Settings::current_bandwidth_rad_per_s;
}

bool sameSetting(double a, double b) {
  return std::abs(a - b) <= 2e-7 * std::max(std::abs(a), std::abs(b));
}

Result<void> checkSettings(const ControllerSettings& settings) {
  const auto good = [&](const ProfileParameter& one) {
    return std::isfinite(settings.*one.value) && settings.*one.value >= 0.0;
  };
  if (std::all_of(parameters.begin(), parameters.end(), good)) return {};
  return Error{"settings", message("hold a value that is negative or not finite")};
}

Result<Profile> profileOf(Drive& board) {
  Profile profile{board.identity().device, board.identity().firmware, board.settings(), {}};
  if (!board.identity().can.compensates) return profile;
  auto friction = board.compensation();
  if (!friction) return friction.error();
  profile.friction = std::move(*friction);
  return profile;
}

std::vector<ProfileRow> compareProfiles(const Profile& here, const Profile& there) {
  std::vector<ProfileRow> rows;
  for (const auto& [name, value] : parameters) {
    const Settings &a = here.settings, &b = there.settings;
    const bool unsaid = isUnsaid(a, value) || isUnsaid(b, value);
    rows.push_back({name, valueText(a, value), valueText(b, value), unsaid || sameSetting(a.*value, b.*value)});
  }
  rows.push_back({frictionTableName, frictionText(here.friction), frictionText(there.friction),
                  sameFriction(here.friction, there.friction)});
  return rows;
}

namespace {

Result<void> knownNames(const std::vector<std::string>& only) {
  std::vector<std::string> names;
  names.reserve(parameters.size() + 1);
  for (const auto& one : parameters) names.emplace_back(one.name);
  names.emplace_back(frictionTableName);
  for (const std::string& name : only) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const auto near = nearestName(name, names);
    return Error{"--only", "\"" + name + "\" is no parameter" +
                               (near ? ", did you mean " + *near + "?" : "; compare lists their names")};
  }
  return {};
}

}  // namespace

Result<std::vector<RestoredRow>> restoreProfile(Drive& board, const Profile& profile, const RestoreOptions& options) {
  if (auto known = knownNames(options.only); !known) return known.error();
  if (!options.anyBoard && profile.device != board.identity().device) {
    return Error{"profile", message("was saved from {}, but this is {}; say so if it shall be restored all the same",
                                    profile.device, board.identity().device)};
  }
  const auto chosen = [&options](const char* name) {
    return options.only.empty() || std::find(options.only.begin(), options.only.end(), name) != options.only.end();
  };
  auto before = profileOf(board);
  if (!before) return before.error();
  const bool named = !options.only.empty() && chosen(frictionTableName);
  std::optional<FrictionCompensation> friction;
  if (chosen(frictionTableName) && !sameFriction(before->friction, profile.friction)) friction = profile.friction;
  if (named && profile.friction && !board.identity().can.compensates)
    return Error{"board", message("takes no friction table")};
  if (friction && !board.identity().can.compensates) friction.reset();
  if (friction && friction->coulomb_Nm[0].size() > 1) {
    if (!options.index_rad) {
      return Error{frictionTableName, message("belongs to angles from the index, which the board counts anew after "
                                              "each power-up; home first and give the index, or leave the table out")};
    }
    friction->indexAngle_rad = *options.index_rad;
  }
  ControllerSettings wanted = before->settings;
  for (const auto& [name, value] : parameters) {
    if (chosen(name) && !isUnsaid(profile.settings, value)) wanted.*value = profile.settings.*value;
  }
  const auto accepted = board.configure(wanted);
  if (!accepted) return accepted.error();
  if (friction) {
    if (auto done = board.compensate(*friction); !done) {
      const auto back = board.configure(before->settings);
      return back ? done.error() : back.error();
    }
  }
  std::vector<RestoredRow> rows;
  for (const auto& [name, value] : parameters) {
    if (!chosen(name) || isUnsaid(profile.settings, value)) continue;
    rows.push_back(
        {name, numberText(wanted.*value), valueText(*accepted, value), sameSetting(wanted.*value, (*accepted).*value)});
  }
  if (chosen(frictionTableName)) {
    const auto after = profileOf(board);
    if (!after) return after.error();
    rows.push_back({frictionTableName, frictionText(profile.friction), frictionText(after->friction),
                    sameFriction(profile.friction, after->friction)});
  }
  return rows;
}

}  // namespace breakaway
