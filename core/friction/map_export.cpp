#include "friction/map_export.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/atomic_file.h"
#include "base/exact_text.h"
#include "base/made.h"
#include "friction/map_json.h"
#include "friction/map_mat.h"
#include "friction/map_table.h"

namespace breakaway {

namespace {

std::string csvText(const FrictionMap& map) {
  const auto columns = mapTable(map);
  std::string out;
  for (const MapColumn& column : columns) out += (out.empty() ? "" : ",") + column.name;
  out += '\n';
  for (size_t k = 0; k < map.bins.size(); ++k) {
    for (size_t c = 0; c < columns.size(); ++c) out += (c == 0 ? "" : ",") + exactText(columns[c].values[k]);
    out += '\n';
  }
  return out;
}

/// One line, no end of comment in it.
std::string commentText(std::string text) {
  for (char& c : text) {
    if (c == '*' || c == '/' || static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

std::string whatEntriesHold(const FrictionMap& map) {
  if (map.axis == Axis::rotary)
    return "motor torque by rotor angle, 0 at the encoder's index.\n"
           "   Entry k holds the angles from k to k + 1 times 2 pi / BREAKAWAY_MAP_BINS.";
  const double width_m = map.bins.size() > 1 ? map.bins[1].angle_rad - map.bins[0].angle_rad : 0.0;
  return "motor force by position, 0 at the encoder's index, or at the lower end without one.\n"
         "   Entry k holds the positions around " +
         exactText(map.bins.empty() ? 0.0 : map.bins[0].angle_rad) + " + k * " + exactText(width_m) + " m.";
}

/// The shortest text that reads back as the same float, as a literal of C.
std::string floatLiteral(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  std::string number(text.data(), end);
  if (number.find_first_of(".e") == std::string::npos) number += ".0";
  return number + "f";
}

bool isFloat(double value) {
  return std::abs(value) <= std::numeric_limits<float>::max();
}

/// Errors: a value that no float holds, with its bin and column.
Result<std::string> headerText(const FrictionMap& map) {
  std::string out = "/* Friction map of " + commentText(map.rig) + ": " + whatEntriesHold(map) + " */\n" +
                    "#ifndef BREAKAWAY_FRICTION_MAP_H\n#define BREAKAWAY_FRICTION_MAP_H\n\n" +
                    "#define BREAKAWAY_MAP_BINS " + std::to_string(map.bins.size()) + "\n" +
                    "#define BREAKAWAY_MAP_TOTAL_VELOCITY_" + std::string(map.axis == Axis::rotary ? "RAD" : "M") +
                    "_PER_S " + exactText(map.totalVelocity_rad_per_s) + "\n\n";
  for (const MapColumn& column : mapTable(map)) {
    const bool wanted = column.name.find("_std_") == std::string::npos && column.name.rfind("samples", 0) != 0 &&
                        column.name.rfind("outlier", 0) != 0 && column.name != nameOn(map.axis, "angle_rad");
    if (!wanted) continue;
    out += "static const float breakaway_map_" + column.name + "[BREAKAWAY_MAP_BINS] = {";
    for (size_t k = 0; k < column.values.size(); ++k) {
      if (!isFloat(column.values[k]))
        return Error{"bin " + std::to_string(k + 1) + ", column " + column.name,
                     "is " + exactText(column.values[k]) + ", expected what a float of C can hold"};
      out += std::string(k == 0 ? "" : ",") + (k % 6 == 0 ? "\n  " : " ") +
             floatLiteral(static_cast<float>(column.values[k]));
    }
    out += "\n};\n\n";
  }
  return out + "#endif\n";
}

}  // namespace

Result<void> exportMap(const FrictionMap& map, const std::string& format, const std::string& path) {
  if (format == "csv") return writeFile(path, csvText(map));
  if (format == "json") return writeFile(path, withMade(mapJsonText(map)));
  if (format == "c-header") {
    const auto header = headerText(map);
    return header ? writeFile(path, *header) : header.error();
  }
  if (format == "mat") return writeMapMat(map, path);
  return Error{"format " + format, "is unknown, expected csv, json, c-header or mat"};
}

Result<FrictionMap> readMap(const std::string& path) {
  const auto content = readFile(path);
  if (!content) return content.error();
  return readMapText(*content, path);
}

}  // namespace breakaway
