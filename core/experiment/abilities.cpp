#include "experiment/abilities.h"

namespace breakaway {

namespace {

Message joined(const Message& first, const Message& second) {
  return first.empty() || second.empty() ? first + second : first + "; " + second;
}

Message toHoming(const Identity& board) {
  return board.hasIndex ? Message() : message("the board reports no index: homing needs one");
}

Message toGains(const Identity& board) {
  return board.can.takesGains ? Message() : message("the board keeps its own gains: set them with its maker's tool");
}

Message toIdentification(const Identity& board) {
  Message why;
  if (!board.can.everyTick) {
    why = message("the board is asked {:.0f} times a second: the winding test needs a sample of every control tick",
                  board.loopRate_Hz);
  }
  if (!board.can.zeroesSensor)
    why = joined(
        why, message("the board zeroes its current sensor by itself: identification and sweeps need it zeroed anew"));
  return why;
}

}  // namespace

Message obstacleTo(Task task, const Identity& board) {
  const bool linear = board.axis == Axis::linear;
  switch (task) {
    case Task::homing:
      // Without an index a linear axis counts from its lower end; on the way there its motor is identified.
      return linear ? toIdentification(board) : toHoming(board);
    case Task::identification:
      return toIdentification(board);
    case Task::sweep:
      return joined(linear ? Message() : toHoming(board), toIdentification(board));
    case Task::tuning:
      return toGains(board);
    case Task::compensation:
      return board.can.compensates ? Message() : message("the board takes no friction table");
    case Task::commissioning:
      return joined(linear ? toIdentification(board) : obstacleTo(Task::sweep, board), toGains(board));
  }
  return {};
}

}  // namespace breakaway
