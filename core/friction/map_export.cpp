#include "friction/map_export.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/atomic_file.h"
#include "base/exact_text.h"
#include "base/made.h"
#include "base/numbers.h"
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

/// What a header's names begin with: lower and upper case.
struct Prefix {
  std::string name, upper;
  explicit Prefix(const std::string& asked) : name(asked.empty() ? "breakaway" : asked), upper(name) {
    for (char& c : upper) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
};

std::string whatEntriesHold(const FrictionMap& map, const Prefix& prefix) {
  if (map.axis == Axis::rotary)
    return "motor torque by rotor angle, 0 at the encoder's index.\n"
           "   Entry k holds the angles from k to k + 1 times 2 pi / " +
           prefix.upper + "_MAP_BINS.";
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

/// Whether a program that uses the map wants a column: not doubts, counts and places.
bool worthTabling(const std::string& column, Axis axis) {
  return column.find("_std_") == std::string::npos && column.rfind("samples", 0) != 0 &&
         column.rfind("outlier", 0) != 0 && column != nameOn(axis, "angle_rad");
}

/// Functions on the tables: between the bins' centres by straight lines, without a library.
std::string tableFunctions(const FrictionMap& map, const Prefix& prefix) {
  const bool rotary = map.axis == Axis::rotary;
  const double first = map.bins.empty() ? 0.0 : map.bins.front().angle_rad;
  const auto count = static_cast<double>(std::max<size_t>(map.bins.size(), 1));
  const double width = rotary ? turn_rad / count : map.bins.size() > 1 ? map.bins[1].angle_rad - first : 1.0;
  const std::string bins = prefix.upper + "_MAP_BINS", at = prefix.name + "_map_at(";
  const auto on = [&](const char* name) { return prefix.name + "_map_" + nameOn(map.axis, name); };
  const std::string place = nameOn(map.axis, "angle_rad"), speed = nameOn(map.axis, "velocity_rad_per_s");
  const std::string ends =
      rotary ? "  k %= " + bins + ";\n  if (k < 0) k += " + bins + ";\n  next = k + 1 < " + bins + " ? k + 1 : 0;\n"
             : "  if (k < 0) { k = 0; part = 0.0f; }\n  if (k > " + bins + " - 1) { k = " + bins +
                   " - 1; part = 0.0f; }\n  next = k + 1 < " + bins + " ? k + 1 : k;\n";
  return "/* A table's value at a place, by a straight line between neighbours" +
         std::string(rotary ? "; any number of turns away. */\n" : ", beyond the ends as there. */\n") +
         "static inline float " + at + "const float *table, float " + place + ") {\n  float part = (" + place + " - " +
         floatLiteral(static_cast<float>(first)) + ") / " + floatLiteral(static_cast<float>(width)) +
         ";\n  long k = (long)part, next;\n  if (part < (float)k) k -= 1;\n  part -= (float)k;\n" + ends +
         "  return table[k] + part * (table[next] - table[k]);\n}\n\n"
         "/* What keeps it moving at a place and velocity, friction and position " +
         std::string(rotary ? "torque in Nm" : "force in N") + "; 0 at standstill. */\nstatic inline float " +
         on("moving_Nm") + "(float " + place + ", float " + speed + ") {\n  if (" + speed + " > 0.0f)\n    return " +
         at + on("coulomb_ccw_Nm") + ", " + place + ") + " + speed + " * " + at + on("viscous_ccw_Nm_s_per_rad") +
         ", " + place + ");\n  if (" + speed + " < 0.0f)\n    return " + speed + " * " + at +
         on("viscous_cw_Nm_s_per_rad") + ", " + place + ") - " + at + on("coulomb_cw_Nm") + ", " + place +
         ");\n  return 0.0f;\n}\n\n";
}

/// Errors: a value that no float holds, with its bin and column.
Result<std::string> headerText(const FrictionMap& map, const Prefix& prefix) {
  const std::string guard = prefix.upper + "_FRICTION_MAP_H";
  std::string out = "/* Friction map of " + commentText(map.rig) + ": " + whatEntriesHold(map, prefix) + " */\n" +
                    "#ifndef " + guard + "\n#define " + guard + "\n\n" + "#define " + prefix.upper + "_MAP_BINS " +
                    std::to_string(map.bins.size()) + "\n" + "#define " + prefix.upper + "_MAP_TOTAL_VELOCITY_" +
                    std::string(map.axis == Axis::rotary ? "RAD" : "M") + "_PER_S " +
                    exactText(map.totalVelocity_rad_per_s) + "\n\n";
  for (const MapColumn& column : mapTable(map)) {
    if (!worthTabling(column.name, map.axis)) continue;
    out += "static const float " + prefix.name + "_map_" + column.name + "[" + prefix.upper + "_MAP_BINS] = {";
    for (size_t k = 0; k < column.values.size(); ++k) {
      if (!isFloat(column.values[k]))
        return Error{"bin " + std::to_string(k + 1) + ", column " + column.name,
                     "is " + exactText(column.values[k]) + ", expected what a float of C can hold"};
      out += std::string(k == 0 ? "" : ",") + (k % 6 == 0 ? "\n  " : " ") +
             floatLiteral(static_cast<float>(column.values[k]));
    }
    out += "\n};\n\n";
  }
  return out + tableFunctions(map, prefix) + "#endif\n";
}

/// A package of constants, each a table of two columns as Modelica.Blocks.Tables.CombiTable1Ds takes it. Its period is
/// from the first place to the last, so a rotor's tables end where they begin, a turn later (Modelica Standard Library,
/// Extrapolation.Periodic).
std::string modelicaText(const FrictionMap& map, const std::string& asked) {
  const std::string package = asked.empty() ? "BreakawayFrictionMap" : asked;
  const std::string place = nameOn(map.axis, "angle_rad");
  std::string out =
      "// Friction map of " + commentText(map.rig) + ", by " + thisRun().by + ". Each table's first column is " +
      place + ",\n// the second what its name says; for Modelica.Blocks.Tables.CombiTable1Ds" +
      (map.axis == Axis::rotary ? ", with Extrapolation.Periodic" : ", with Extrapolation.HoldLastPoint") +
      ".\npackage " + package + "\n";
  const auto columns = mapTable(map);
  for (const MapColumn& column : columns) {
    if (!worthTabling(column.name, map.axis)) continue;
    const bool closed = map.axis == Axis::rotary && !column.values.empty();
    out +=
        "  constant Real " + column.name + "[" + std::to_string(column.values.size() + (closed ? 1 : 0)) + ", 2] = [";
    for (size_t k = 0; k < column.values.size(); ++k)
      out += (k == 0 ? "" : "; ") + exactText(map.bins[k].angle_rad) + ", " + exactText(column.values[k]);
    if (closed) out += "; " + exactText(map.bins[0].angle_rad + turn_rad) + ", " + exactText(column.values[0]);
    out += "];\n";
  }
  return out + "end " + package + ";\n";
}

}  // namespace

const std::vector<std::string>& mapForms() {
  static const std::vector<std::string> forms{"csv", "json", "c-header", "mat", "modelica"};
  return forms;
}

Result<void> exportMap(const FrictionMap& map, const std::string& format, const std::string& path,
                       const std::string& name) {
  if (format == "csv") return writeFile(path, csvText(map));
  if (format == "json") return writeFile(path, withMade(mapJsonText(map)));
  if (format == "c-header") {
    const auto header = headerText(map, Prefix(name));
    return header ? writeFile(path, *header) : header.error();
  }
  if (format == "mat") return writeMapMat(map, path);
  if (format == "modelica") return writeFile(path, modelicaText(map, name));
  return Error{"format " + format, "is unknown, expected csv, json, c-header, mat or modelica"};
}

Result<FrictionMap> readMap(const std::string& path) {
  const auto content = readFile(path);
  if (!content) return content.error();
  return readMapText(*content, path);
}

}  // namespace breakaway
