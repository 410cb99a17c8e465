// What models err by, as bars with their intervals: before and after, and with others in a finding's place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/catalogue.h"
#include "base/marked_text.h"
#include "diagnose/diagnosis.h"

namespace breakaway {

/// Of the base model and of the one with the findings, in every picture.
inline constexpr int beforeColour = 1, afterColour = 0;
inline constexpr MessageText<0> beforeLabel = marked("base model"), afterLabel = marked("with what was missing");

/// What people read a size in.
struct Shown {
  double scale;
  const char* unit;
};
/// Positions: degrees or millimetres.
Shown shownIn(Axis axis);
/// What is left of torque or force.
Shown leftIn(Axis axis);
/// The channel that a fit is scored in.
Shown scoredIn(const Diagnosis& diagnosis);

/// One model's RMSE.
struct ErrorBar {
  enum class Of { base, found, rival, floor };
  Of of = Of::base;
  Message name;
  double error = 0.0;  ///< SI
  std::optional<Interval> interval = {};
  const RivalScore* rival = nullptr;  ///< whose it is, in the finding
};

/// On held-out data: all findings, each other effect that was fitted in this one's place, the least error first, the
/// base model, and a perfect model's, on this rig.
std::vector<ErrorBar> rivalBars(const Diagnosis& diagnosis, const Finding& finding);
/// In one sentence: which of them held-out data can't tell from the finding, or how much worse the nearest is, or that
/// none was fitted.
Message rivalSentence(const Finding& finding);

/// The same as a picture: one SVG document.
std::string rivalsSvg(const Diagnosis& diagnosis, const Finding& finding, const Catalogue& language = {});
/// The error before, after, and what a perfect model would show, as bars: one SVG document.
std::string gainSvg(const Diagnosis& diagnosis, const Catalogue& language = {});

}  // namespace breakaway
