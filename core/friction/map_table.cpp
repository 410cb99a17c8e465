#include "friction/map_table.h"

#include <algorithm>
#include <functional>

namespace breakaway {

namespace {

struct Field {
  std::string name;
  std::function<double(const MapBin&)> get;
  std::function<void(MapBin&, double)> set;  ///< empty: follows from the others
  bool required = true;
};

std::vector<Field> fields() {
  std::vector<Field> all;
  const auto add = [&all](const std::string& name, auto access, bool required = true) {
    all.push_back({name, [access](const MapBin& bin) { return static_cast<double>(access(bin)); },
                   [access](MapBin& bin, double value) {
                     auto& field = access(bin);
                     field = static_cast<std::decay_t<decltype(field)>>(value);
                   },
                   required});
  };
  add(
      "angle_rad", [](auto& bin) -> auto& { return bin.angle_rad; });
  for (size_t w = 0; w < 2; ++w) {
    const std::string way = w == 0 ? "_cw" : "_ccw";
    add(
        "static" + way + "_Nm", [w](auto& bin) -> auto& { return bin.way[w].static_Nm.value; });
    add(
        "static" + way + "_std_Nm", [w](auto& bin) -> auto& { return bin.way[w].static_Nm.standardError; });
    add(
        "coulomb" + way + "_Nm", [w](auto& bin) -> auto& { return bin.way[w].coulomb_Nm.value; });
    add(
        "coulomb" + way + "_std_Nm", [w](auto& bin) -> auto& { return bin.way[w].coulomb_Nm.standardError; });
    add(
        "viscous" + way + "_Nm_s_per_rad", [w](auto& bin) -> auto& { return bin.way[w].viscous_Nm_s_per_rad.value; });
    add(
        "viscous" + way + "_std_Nm_s_per_rad", [w](auto& bin) -> auto& {
          return bin.way[w].viscous_Nm_s_per_rad.standardError;
        });
    add(
        "total" + way + "_Nm", [w](auto& bin) -> auto& { return bin.way[w].total_Nm; });
    add(
        "samples" + way, [w](auto& bin) -> auto& { return bin.way[w].samples; });
    add(
        "outlier" + way, [w](auto& bin) -> auto& { return bin.way[w].outlier; }, false);
  }
  all.push_back({"static_friction_Nm", [](const MapBin& bin) { return bin.staticFriction_Nm(); }, {}, false});
  all.push_back({"position_torque_Nm", [](const MapBin& bin) { return bin.positionTorque_Nm(); }, {}, false});
  return all;
}

}  // namespace

std::vector<MapColumn> mapTable(const FrictionMap& map) {
  std::vector<MapColumn> columns;
  for (const Field& field : fields()) {
    MapColumn column{nameOn(map.axis, field.name), {}};
    for (const MapBin& bin : map.bins) column.values.push_back(field.get(bin));
    columns.push_back(std::move(column));
  }
  return columns;
}

std::string fillFromTable(FrictionMap& map, const std::vector<MapColumn>& columns) {
  map.bins.assign(columns.empty() ? 0 : columns.front().values.size(), {});
  for (const Field& field : fields()) {
    if (!field.set) continue;
    const auto it = std::find_if(columns.begin(), columns.end(),
                                 [&](const MapColumn& one) { return one.name == nameOn(map.axis, field.name); });
    if (it == columns.end()) {
      if (field.required) return nameOn(map.axis, field.name);
      continue;
    }
    for (size_t k = 0; k < map.bins.size(); ++k) field.set(map.bins[k], it->values[k]);
  }
  return {};
}

}  // namespace breakaway
