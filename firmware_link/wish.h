// What a board is wished to do, said again until it says that it has it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "experiment/drive.h"
#include "experiment/leg.h"
#include "firmware_link/board_link.h"

namespace breakaway {

class Wish {
 public:
  /// What goes with it besides.
  struct Terms {
    bool watched;         ///< a procedure runs
    std::uint16_t latch;  ///< of the board's faults, as the host knows it
    double count_rad;     ///< the angle of one count
  };

  /// Holds until the next wish. What the board has already is not sent again.
  void want(const Command& command);
  void want(const Leg& leg);
  /// Somebody's own decision: the only one that a board takes after a stop.
  void begin(const Command& command);
  /// The board's windings are open already: nothing is to be said.
  void rest();
  void sendAnew();

  const Command& command() const { return command_; }
  const std::optional<Leg>& leg() const { return leg_; }
  bool oddLeg() const { return (legNumber_ & 1u) != 0; }
  /// Counts what was wished for.
  std::size_t changes() const { return changes_; }

  /// Puts it among what goes out next, if the board has not said that it has it and has had time to.
  void prepare(BoardLink& link, const Terms& terms);
  static bool isAnswered(const wire::Frame& frame);
  /// Takes the board's answer. Returns why it refuses for good, if that is what it says.
  std::optional<wire::Code> answered(const wire::Frame& frame);

 private:
  std::uint16_t send(BoardLink& link, const Terms& terms) const;

  Command command_;
  std::optional<Leg> leg_;  ///< in place of it
  std::uint8_t legNumber_ = 0;
  std::size_t changes_ = 0;
  bool fresh_ = false, acknowledged_ = true;
  std::uint16_t sequence_ = 0;
  BoardLink::Clock::time_point sent_;
};

}  // namespace breakaway
