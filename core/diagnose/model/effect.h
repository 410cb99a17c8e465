// The seam of the catalogue: everything Breakaway knows about one effect stands in one file behind this interface.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "diagnose/model/elastic_friction.h"
#include "diagnose/model/excitation.h"
#include "diagnose/model/hidden_state.h"
#include "diagnose/model/input_part.h"
#include "diagnose/model/load_part.h"
#include "diagnose/model/once_part.h"
#include "diagnose/model/sensor_parts.h"
#include "diagnose/model/situation.h"
#include "diagnose/model/written.h"
#include "motor/bench.h"
#include "motor/maneuver.h"

namespace breakaway {

/// One parameter of an effect: public name with its unit, and the range in which it makes sense.
struct ParameterSpec {
  std::string name;
  double lower;
  double upper;
  bool held = false;          ///< chosen by the search and then kept, such as an order
  bool freeInTheEnd = false;  ///< but fitted with the last refinement
  double doubt =
      0.01;  ///< relative standard deviation that least squares can't know: no rig keeps to a model more closely
  bool absentAtZero = false;  ///< not fitted while it is 0
  bool amongSpeeds = false;   ///< a speed at which something changes: it lies well within those that were run
};

/// A candidate for the search: parameters at a typical size, one set per amplitude that enters linearly (a wave has
/// two: cosine and sine). All sets share the nonlinear parameters.
using Shape = std::vector<std::vector<double>>;

/// What tells an effect from another that shows along the same axis.
struct Tell {
  std::string_view beside;  ///< the other effect's name
  Message sign;             ///< what this one does then, for "what … is this effect"
};

/// What every effect has stands here; what only some have are parts, null for all others.
class Effect {
 public:
  virtual ~Effect() = default;

  /// The name that files and people know it by.
  virtual std::string_view name() const = 0;
  /// The formula in the notation of resources/help/notation.md, and where it comes from.
  virtual std::string_view formula() const = 0;
  virtual std::string_view source() const = 0;
  virtual std::vector<ParameterSpec> parameters(Axis axis) const = 0;

  // What it does in a simulation; `p` is in the order of parameters(), here and everywhere.

  virtual Term term(std::span<const double> /*p*/, const Situation&) const { return {}; }
  /// Whether term() loses voltage.
  virtual bool losesVoltage() const { return false; }
  /// The longest step at which term() and hidden state stay accurate.
  virtual double longestStep_s(std::span<const double> /*p*/) const { return 2e-3; }
  /// Whether it grows while the axis stands still, so that motion alone hardly shows it.
  virtual bool growsAtRest() const { return false; }
  /// Whether several of it may be there at once: waves of different orders, both ends of a travel.
  virtual bool mayRepeat(const Excitation&) const { return false; }

  // Its parts.

  virtual const HiddenState* hidden() const { return nullptr; }
  virtual const LoadPart* load() const { return nullptr; }  ///< whoever has it has hidden(), too
  virtual const ElasticFriction* elastic() const { return nullptr; }
  virtual const InputPart* input(DriveInput) const { return nullptr; }  ///< by what drives
  virtual const EncoderPart* encoder() const { return nullptr; }
  virtual const CurrentSensorPart* currentSensor() const { return nullptr; }
  virtual const OncePart* once() const { return nullptr; }
  bool happensOnce() const { return once() != nullptr; }
  /// Whether it is a torque at every instant and nothing else, so that an inverse model can hold it.
  bool isTorqueAlone(DriveInput drive) const {
    return hidden() == nullptr && !losesVoltage() && input(drive) == nullptr && elastic() == nullptr &&
           encoder() == nullptr;
  }

  // What other programs get.

  /// The same as term() and the parts, for programs that are written out.
  virtual Written written(std::span<const double> /*p*/, Axis) const { return {.lacking = "it is not written down"}; }
  /// What a joint of a robot simulator holds of it: of most effects nothing. LoadPart says the rest.
  virtual std::optional<JointShare> joint(std::span<const double> /*p*/) const { return {}; }

  // What the search asks.

  /// Candidate shapes; empty when the data can't show the effect at all.
  virtual std::vector<Shape> shapes(const Excitation& seen) const = 0;
  /// Parameters at which it is tried in the place of what it looks like, whatever the regression says of it.
  virtual std::vector<std::vector<double>> asRival(const Excitation&) const { return {}; }
  /// Parameters at `amplitude` times the sets of a shape. Without its own: the first parameter is multiplied.
  virtual std::vector<double> scaled(const Shape& shape, std::span<const double> amplitude) const {
    std::vector<double> p = shape.front();
    p.front() *= amplitude.front();
    return p;
  }
  /// Whether these parameters make sense: a searched amplitude of the wrong sign doesn't.
  virtual bool plausible(std::span<const double>, const Excitation&) const { return true; }
  /// Other held parameters worth a fit of their own once the effect is in.
  virtual std::vector<std::vector<double>> variants(std::span<const double>, const Excitation&) const { return {}; }
  /// Further terms of the same effect that are likely beside one, where mayRepeat() doesn't have all tried.
  virtual std::vector<std::vector<double>> besides(std::span<const double>, const Excitation&) const { return {}; }

  // What people read.

  /// What is missing, where it shows and how big it is, in a technician's words, with what to look at.
  virtual Message sentence(std::span<const double> p, const Excitation& seen) const = 0;
  /// What further terms of the same effect, smaller ones, add to that sentence: theirs, unless there is a shorter way.
  virtual Message furtherSentence(std::span<const double> /*largest*/, std::span<const std::vector<double>> further,
                                  const Excitation& seen) const {
    Message text;
    for (const std::vector<double>& p : further) text = text + " " + sentence(p, seen);
    return text;
  }
  /// Effects that look the same on poor data.
  virtual std::vector<std::string_view> lookAlikes() const = 0;
  /// Inseparable twin: one and the same thing for a recording; empty for most.
  virtual std::string_view twin() const { return {}; }
  /// What tells it from others that show along the same axis; each of the two has its own side of it.
  virtual std::vector<Tell> tells() const { return {}; }
  /// The experiment that makes the effect visible, with speeds and amplitudes within what was seen.
  virtual Message neededExcitation(const Excitation& seen) const = 0;
  /// The same as a motion that a board can follow; empty where it takes hands: a load, a cooled motor, a drive's own
  /// recording.
  virtual Maneuver neededManeuver(const Excitation&) const { return {}; }
  /// The axis over which the report draws the term: velocity, angle, time, current, travel, frequency; empty: no curve.
  virtual std::string_view drawnOver() const { return {}; }
};

}  // namespace breakaway
