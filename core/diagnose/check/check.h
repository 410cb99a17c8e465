// What recordings are good for, before any diagnosis: channels, scales, and what their excitation can show.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/check/channel_quality.h"
#include "diagnose/check/sight.h"
#include "diagnose/fit/scale_check.h"

namespace breakaway {

struct Check {
  Axis axis = Axis::rotary;
  std::optional<Misreading> misread;  ///< what follows is of the recordings with that put right
  std::vector<Message> remarks;
  std::vector<ChannelQuality> channels;
  std::vector<std::string> channelWords;
  Model base;                  ///< fitted to all that a diagnosis would learn from
  double error = 0.0;          ///< of the base model over windows, rad or m (rad/s or m/s of speed alone)
  double floor = 0.0;          ///< the same of a perfect model
  TorqueNoise wander;          ///< what the base model leaves, taken for a torque that wanders
  std::vector<Sight> effects;  ///< in the catalogue's order
  std::string next;            ///< the experiment that would show most of what these can't; empty: they show all
};

/// Errors: as prepare()'s.
Result<Check> check(const Bench& bench, const std::vector<Recording>& recordings);

/// Some lines of plain text: scales, channels, then a table of the effects.
std::string inWords(const Check& check);
/// One line for a page: how many effects show, and from which size friction and cogging do.
std::string inShort(const Check& check);
/// `breakaway.check/1`, indented, without a line end.
std::string checkJson(const Check& check);

}  // namespace breakaway
