#include "friction/breakaway_table.h"

#include <fmt/core.h>

namespace breakaway {

std::string breakawayTable(const std::vector<BreakawayEvent>& events, Axis axis) {
  std::string text = axis == Axis::linear ? "position_m,way,pass,bin,current_A,force_N,outlier\n"
                                          : "angle_rad,way,turn,bin,current_A,torque_Nm,outlier\n";
  for (const BreakawayEvent& event : events) {
    text += fmt::format("{:.9g},{},{},{},{:.9g},{:.9g},{:d}\n", event.angle_rad, event.way == Way::cw ? "cw" : "ccw",
                        event.turn + 1, event.bin, event.current_A, event.torque_Nm, event.outlier);
  }
  return text;
}

}  // namespace breakaway
