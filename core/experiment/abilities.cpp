#include "experiment/abilities.h"

#include <fmt/core.h>

namespace breakaway {

namespace {

std::string joined(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + "; " + second;
}

std::string toHoming(const Identity& board) {
  return board.hasIndex ? "" : "the board reports no index: homing needs one";
}

std::string toIdentification(const Identity& board) {
  std::string why;
  if (!board.can.everyTick) {
    why = fmt::format("the board is asked {:.0f} times a second: the winding test needs a sample of every control tick",
                      board.loopRate_Hz);
  }
  if (!board.can.zeroesSensor)
    why = joined(why, "the board zeroes its current sensor by itself: identification and sweeps need it zeroed anew");
  return why;
}

}  // namespace

std::string obstacleTo(Task task, const Identity& board) {
  const bool linear = board.axis == Axis::linear;
  switch (task) {
    case Task::homing:
      // Without an index a linear axis counts from its lower end; on the way there its motor is identified.
      return linear ? toIdentification(board) : toHoming(board);
    case Task::identification:
      return toIdentification(board);
    case Task::sweep:
      return joined(linear ? std::string() : toHoming(board), toIdentification(board));
    case Task::tuning:
      return board.can.takesGains ? "" : "the board keeps its own gains: set them with its maker's tool";
    case Task::compensation:
      return board.can.compensates ? "" : "the board takes no friction table";
    case Task::commissioning:
      return joined(linear ? toIdentification(board) : obstacleTo(Task::sweep, board),
                    board.can.takesGains ? "" : "the board keeps its own gains: set them with its maker's tool");
  }
  return {};
}

}  // namespace breakaway
