// What a board is set to, as a file: saved, compared, and given back in whole or in part.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "experiment/drive.h"

namespace breakaway {

/// Everything a board has been told that outlives a command, and whose board it was.
struct Profile {
  std::string device;
  std::string firmware;
  ControllerSettings settings;
  std::optional<FrictionCompensation> friction;  ///< missing where the board takes none
  bool operator==(const Profile&) const = default;
};

/// A parameter's name, in the file and for a person, and its place.
struct ProfileParameter {
  const char* name;
  double ControllerSettings::*value;
};
std::span<const ProfileParameter> profileParameters();
/// Whether boards and files may not have it, which is 0 among the settings and asks for nothing: the two bandwidths.
bool mayBeUnsaid(double ControllerSettings::*setting);
/// Error: one of them is negative or not finite.
Result<void> checkSettings(const ControllerSettings& settings);

/// Whether a board can tell them apart: it keeps single precision.
bool sameSetting(double a, double b);

/// What the friction table is called among the parameters.
constexpr const char* frictionTableName = "friction_table";

/// What the board is set to now.
Result<Profile> profileOf(Drive& board);

/// `breakaway.profile/1`. An error names the field and what was expected.
Result<Profile> readProfile(const std::string& path);
Result<Profile> readProfileText(const std::string& text, const std::string& place);
std::string profileText(const Profile& profile);
Result<void> writeProfile(const Profile& profile, const std::string& path);

/// One parameter here and there, as a person reads it.
struct ProfileRow {
  std::string name, here, there;
  bool same = false;
};
/// All parameters of both, in the profile's order, the friction table last.
std::vector<ProfileRow> compareProfiles(const Profile& here, const Profile& there);

struct RestoreOptions {
  std::vector<std::string> only;      ///< parameters to restore; empty: all
  std::optional<double> index_rad{};  ///< the encoder's index as the board counts now; a table of several bins needs it
  bool anyBoard = false;              ///< also one that the profile was not saved from
};

/// One parameter that was asked for, and what the board made of it.
struct RestoredRow {
  std::string name, wanted, accepted;
  bool same = false;
};

/// Asks the board for what `profile` holds and reads back what it accepted. Errors, with nothing written: an unknown
/// name in `only`, a profile of another board, a table whose place on the rotor isn't known, a board that refuses.
Result<std::vector<RestoredRow>> restoreProfile(Drive& board, const Profile& profile, const RestoreOptions& options);

}  // namespace breakaway
