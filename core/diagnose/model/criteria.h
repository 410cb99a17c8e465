// The numbers by which a diagnosis decides: one word, one value.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace breakaway {

/// Every number on which depends what a diagnosis says: whether an effect is adopted, whether a name stands, what is a
/// place, what is any rig's own. What only says how finely or for how long something is computed stands where it is
/// used. criteriaTable() says of each what it asks and what set it.
struct Criteria {
  // Parts of a squared error, of a residual's energy or of a gain.
  double negligible = 0.005;
  double hardlyAny = 0.03;
  double little = 0.1;
  double farLess = 0.25;
  double half = 0.5;
  double clearlyLess = 0.75;
  double hardlyLess = 0.95;
  double sureGain = 0.15;

  // Errors (rms), in those of a perfect model.
  double atFloor = 1.6;
  double nearFloor = 2.0;
  double material = 2.5;
  double settled = 3.0;
  double farOff = 8.0;

  // Chance.
  double largestPValue = 0.01;
  double likeliestByChance = 0.02;
  double beyondChance = 1.2;
  double apart = 2.0;
  double farApart = 3.0;

  // What any rig has, and nobody minds.
  double soundPart = 0.05;
  double immaterial = 0.01;
  double immaterialDrive = 5e-4;
  double beyondWander = 2.0;
  double runAway = 5.0;
  double energyBack = 0.3;
  double fewestFarOff = 5.0;

  /// Whether a squared error is more than hardly, clearly or far more than another one: the words for less, turned.
  double hardlyMore() const { return 1.0 / hardlyLess; }
  double clearlyMore() const { return 1.0 / clearlyLess; }
  double farMore() const { return 1.0 / little; }
  /// A gain that leaves clearly less.
  double clearGain() const { return 1.0 - clearlyLess; }

  bool operator==(const Criteria&) const = default;
};

struct Criterion {
  std::string_view name;  ///< of the member
  double Criteria::*value;
  std::string_view of;     ///< what it is a part or a multiple of
  std::string_view asks;   ///< the inequality, in words
  std::string_view setBy;  ///< where the value comes from
};

/// All of them, in the order of the struct.
std::span<const Criterion> criteriaTable();

/// The criteria with one of them times a factor. An error names those that there are.
Result<Criteria> varied(Criteria criteria, std::string_view name, double factor);

/// The table as Markdown, as the manual's appendix holds it.
std::string criteriaMarkdown();

}  // namespace breakaway
