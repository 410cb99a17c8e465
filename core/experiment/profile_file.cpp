#include <array>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/json_object.h"
#include "base/made.h"
#include "experiment/profile.h"

namespace breakaway {

namespace {

constexpr const char* schema = "breakaway.profile/1";
constexpr std::array<const char*, 2> coulombNames{"coulomb_cw_Nm", "coulomb_ccw_Nm"};
constexpr std::array<const char*, 2> viscousNames{"viscous_cw_Nm_s_per_rad", "viscous_ccw_Nm_s_per_rad"};

FrictionCompensation readFriction(JsonObject object) {
  FrictionCompensation friction;
  friction.indexAngle_rad = object.number("index_angle_rad");
  friction.blend_rad_per_s = object.number("blend_rad_per_s", Allowed::nonNegative);
  friction.cutoff_rad_per_s = object.number("cutoff_rad_per_s", Allowed::nonNegative);
  for (size_t way = 0; way < 2; ++way) {
    friction.coulomb_Nm[way] = object.numbersIn(coulombNames[way]);
    friction.viscous_Nm_s_per_rad[way] = object.numbersIn(viscousNames[way]);
  }
  const size_t bins = friction.coulomb_Nm[0].size();
  for (size_t way = 0; way < 2; ++way) {
    const auto check = [&](const char* name, size_t count) {
      if (count != bins)
        object.fault(name, "has " + std::to_string(count) + " numbers, expected " + std::to_string(bins) + " as in " +
                               coulombNames[0]);
    };
    check(coulombNames[way], friction.coulomb_Nm[way].size());
    check(viscousNames[way], friction.viscous_Nm_s_per_rad[way].size());
  }
  return friction;
}

Result<Profile> readProfile(JsonObject root) {
  Profile profile;
  const std::string found = root.text("schema");
  if (found != schema) root.fault("schema", "is \"" + found + "\", expected \"" + schema + "\"");
  profile.device = root.text("device");
  profile.firmware = root.text("firmware");
  JsonObject values = root.object("parameters");
  for (const auto& [name, value] : profileParameters()) {
    profile.settings.*value = mayBeUnsaid(value) ? values.optionalNumber(name, Allowed::positive).value_or(0.0)
                                                 : values.number(name, Allowed::nonNegative);
  }
  if (root.has(frictionTableName)) profile.friction = readFriction(root.object(frictionTableName));
  if (const auto done = root.finish(); !done) return done.error();
  return profile;
}

}  // namespace

Result<Profile> readProfile(const std::string& path) {
  auto root = JsonObject::fromFile(path);
  if (!root) return root.error();
  return readProfile(std::move(*root));
}

Result<Profile> readProfileText(const std::string& text, const std::string& place) {
  auto root = JsonObject::fromText(text, place);
  if (!root) return root.error();
  return readProfile(std::move(*root));
}

std::string profileText(const Profile& profile) {
  using Json = nlohmann::ordered_json;
  Json json{{"schema", schema}, {"device", profile.device}, {"firmware", profile.firmware}};
  json["parameters"] = Json::object();
  for (const auto& [name, value] : profileParameters()) {
    if (!mayBeUnsaid(value) || profile.settings.*value > 0.0) json["parameters"][name] = profile.settings.*value;
  }
  if (profile.friction) {
    const FrictionCompensation& friction = *profile.friction;
    Json& table = json[frictionTableName] = Json{{"index_angle_rad", friction.indexAngle_rad},
                                                 {"blend_rad_per_s", friction.blend_rad_per_s},
                                                 {"cutoff_rad_per_s", friction.cutoff_rad_per_s}};
    for (size_t way = 0; way < 2; ++way) {
      table[coulombNames[way]] = friction.coulomb_Nm[way];
      table[viscousNames[way]] = friction.viscous_Nm_s_per_rad[way];
    }
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<void> writeProfile(const Profile& profile, const std::string& path) {
  return writeFile(path, withMade(profileText(profile)));
}

}  // namespace breakaway
