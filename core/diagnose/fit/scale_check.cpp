#include "diagnose/fit/scale_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnose/fit/inverse_regression.h"
#include "diagnose/fit/read_track.h"
#include "diagnose/fit/shown_winding.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/recorded_input.h"
#include "motor/beliefs.h"

namespace breakaway {

namespace {

constexpr double frictionDoubt = 10.0;  ///< a factor; friction is the least of what a bench knows
// Voltage alone shows back-EMF and viscous friction as one; friction that falls with speed takes off from it.
constexpr double voltageUpwards = 30.0, voltageDownwards = 4.0;  ///< factors
constexpr double clearOfHonesty = 3.0;  ///< a factor between Kt and Ke that no convention of phases makes
// Within which a factor is near a known mistake's where only the inertia, or resistance and inertia tell it.
constexpr double inertiaDoubt = 0.35, resistanceDoubt = 0.5;
constexpr double nearlyAsGood = 1.0;  ///< of the cost: another explanation is said, too

/// Whether the bench says torque and back-EMF constant, and both the same.
bool saysConstantTwice(const Bench& bench) {
  if (!bench.motor.torqueConstant || !bench.motor.backEmfConstant) return false;
  const auto own = selfContradictionOf(bench);
  return !own || own->place != motorNames(bench.axis).torqueConstant;
}

/// What may be wrong.
enum Cause { angle, current, voltage, torque, constant, resistance, inertia, causes };

/// A belief that the recordings tell, too, and how its logarithm, measured over believed, goes with that of each cause.
struct Evidence {
  std::optional<Belief> belief;     ///< none: it only helps to choose
  double ratio = 1.0;               ///< measured over believed
  double below = 0.0, above = 0.0;  ///< of its logarithm: what an honest bench and the measurement's doubt explain
  std::array<double, causes> by{};

  double logarithm() const { return std::log(ratio); }
  /// How far the logarithm is from `expected`, in what honesty explains.
  double strain(double expected) const {
    const double off = logarithm() - expected;
    return off < 0.0 ? -off / below : off / above;
  }
};

/// Least squares of the drive on acceleration, speed and direction: J/k, B/k and F/k, k the torque of one unit.
struct Mechanics {
  Estimate inertia, viscous, coulomb;
};

/// What is known of a set of recordings before any model is fitted.
class Scales {
 public:
  Scales(const Bench& bench, const std::vector<Track>& tracks, const Criteria& criteria)
      : bench_(bench),
        tracks_(tracks),
        limits_(criteria),
        names_(motorNames(bench.axis)),
        winding_(shownWinding(tracks)) {
    if (winding_ && winding_->left > limits_.half) winding_.reset();
    byCurrent_ = bench.input == DriveInput::current || winding_;
    mechanics_ = mechanicsOf(byCurrent_ ? tracksByCurrent() : tracks);
  }

  bool electrical() const { return winding_.has_value(); }
  const std::optional<ShownWinding>& winding() const { return winding_; }

  std::optional<Cause> wrongSign() const {
    if (winding_) {
      const bool r = isNegative(winding_->resistance_ohm), k = isNegative(winding_->backEmf);
      const bool surelyR = isKnown(winding_->resistance_ohm), surelyK = isKnown(winding_->backEmf);
      if (!surelyR || !surelyK) return {};
      // A channel that is turned turns its sign against both others: of three pairs, none or two disagree. One alone
      // was misread from rows that don't hold what acted between them. The third pair is told by the inertia, or else
      // by the friction.
      if (r || k) {
        const bool byInertia = mechanics_ && isKnown(mechanics_->inertia);
        const double gone = energyGone(tracksByCurrent());
        if (!byInertia && std::abs(gone) < limits_.energyBack) return {};
        if ((r != k) != (byInertia ? isNegative(mechanics_->inertia) : gone < 0.0)) return {};
      }
      if (r && !k) return currentOutlastsRows() ? std::optional(current) : std::nullopt;
      if (r) return voltage;
      if (k) return angle;
      return {};
    }
    if (!mechanics_ || energyGone(tracks_) > -limits_.energyBack) return {};
    const Estimate& f = mechanics_->coulomb;
    const Estimate& j = mechanics_->inertia;
    const bool friction = f.value + limits_.farApart * f.standardError < 0.0;
    if (!friction || j.value - limits_.farApart * j.standardError > 0.0) return {};
    return bench_.input == DriveInput::torque ? torque : bench_.input == DriveInput::current ? current : voltage;
  }

  std::vector<Evidence> evidence() const {
    std::vector<Evidence> all;
    const MotorBelief& motor = bench_.motor;
    const std::optional<double> K = motor.torqueConstant ? motor.torqueConstant : motor.backEmfConstant;
    const auto add = [&](BeliefOf of, const char* name, double believed, const Estimate& measured, const Message& from,
                         std::array<double, causes> by) -> Evidence* {
      if (!(believed > 0.0) || !(measured.value > 0.0)) return nullptr;
      const bool trusted = of != BeliefOf::inertia && bench_.trusted.contains(name);  // a load may give way or play
      Evidence one;
      one.belief = Belief{of, message("the bench's"), name, believed, trusted, measured, from};
      one.ratio = measured.value / believed;
      one.below = one.above =
          std::log(honestFactor(of, trusted)) + limits_.farApart * measured.standardError / measured.value;
      one.by = by;
      all.push_back(one);
      return &all.back();
    };
    if (winding_) {
      const Message from = message("but voltage, current and motion show a back-EMF constant of");
      if (motor.backEmfConstant)
        add(BeliefOf::backEmfConstant, names_.backEmfConstant, *motor.backEmfConstant, winding_->backEmf, from,
            {-1, 0, 1, 0, -1, 0, 0});
      else if (K)
        add(BeliefOf::torqueConstant, names_.torqueConstant, *K, winding_->backEmf, from, {-1, 0, 1, 0, -1, 0, 0});
      if (motor.resistance_ohm)
        add(BeliefOf::resistance, names_.resistance, *motor.resistance_ohm, winding_->resistance_ohm,
            message("but voltage and current show"), {0, -1, 1, 0, 0, -1, 0});
    } else if (bench_.electrical() && K && mechanics_ && isKnown(mechanics_->viscous)) {
      if (Evidence* one =
              add(BeliefOf::backEmfConstant, motor.backEmfConstant ? names_.backEmfConstant : names_.torqueConstant, *K,
                  mechanics_->viscous, message("but voltage and motion show a back-EMF constant of at most"),
                  {-1, 0, 1, 0, -1, 0, 0})) {
        one->above += std::log(voltageUpwards);
        one->below += std::log(voltageDownwards);
      }
    }
    if (!mechanics_ || !isKnown(mechanics_->inertia) || bench_.pendulum) return all;
    double unit = 0.0;  // Nm
    std::array<double, causes> byInertia{}, byFriction{};
    if (bench_.input == DriveInput::torque) {
      unit = 1.0;
      byInertia = {-1, 0, 0, 1, 0, 0, -1};
      byFriction = {0, 0, 0, 1, 0, 0, 0};
    } else if (byCurrent_ && K) {
      unit = motor.torqueConstant.value_or(*K);
      byInertia = {-1, 1, 0, 0, 1, 0, -1};
      byFriction = {0, 1, 0, 0, 1, 0, 0};
    } else if (K && motor.resistance_ohm) {
      unit = motor.torqueConstant.value_or(*K) / *motor.resistance_ohm;
      byInertia = {-1, 0, 1, 0, 1, -1, -1};
      byFriction = {0, 0, 1, 0, 1, -1, 0};
    }
    const auto scaled = [unit](const Estimate& one) { return Estimate{unit * one.value, unit * one.standardError}; };
    if (motor.inertia && unit > 0.0)
      add(BeliefOf::inertia, names_.inertia, *motor.inertia, scaled(mechanics_->inertia),
          message("but the motion shows"), byInertia);
    if (motor.coulomb && unit > 0.0 && isKnown(mechanics_->coulomb)) {
      if (Evidence* one =
              add(BeliefOf::inertia, names_.coulomb, *motor.coulomb, scaled(mechanics_->coulomb), {}, byFriction)) {
        one->belief.reset();
        one->below = one->above = std::log(frictionDoubt);
      }
    }
    return all;
  }

 private:
  static bool isNegative(const Estimate& one) { return one.value < 0.0; }
  bool isKnown(const Estimate& one) const { return std::abs(one.value) > limits_.farApart * one.standardError; }

  /// Whether a current lasts for rows after the voltage has changed: the time in which the rotor follows, J R / K², has
  /// to be longer. Else what is read in between has another sign than what acted.
  bool currentOutlastsRows() const {
    const auto byVoltage = mechanicsOf(tracks_);
    return !byVoltage || isKnown(byVoltage->inertia);
  }

  std::vector<Track> tracksByCurrent() const {
    std::vector<Track> out = tracks_;
    for (Track& track : out) {
      if (track.drive == DriveInput::current) continue;
      double last = 0.0;
      for (size_t k = 0; k < track.rows(); ++k) {
        if (std::isfinite(track.current[k])) last = track.current[k];
        track.input[k] = last;
      }
    }
    return out;
  }

  std::optional<Mechanics> mechanicsOf(const std::vector<Track>& tracks) const {
    std::vector<Column> columns{accelerationColumn, velocityColumn, directionColumn,
                                [](const InverseRows&, size_t) { return 1.0; }};
    if (bench_.pendulum) {
      columns.push_back([](const InverseRows& rows, size_t k) { return std::sin(rows.position[k]); });
      columns.push_back([](const InverseRows& rows, size_t k) { return std::cos(rows.position[k]); });
    }
    const auto got = regress(
        tracks, columns, [](const InverseRows& rows, size_t k) { return rows.input[k]; }, false);
    if (!got || std::pow(got->relativeError, 2) > limits_.half) return {};
    const auto at = [&](Eigen::Index k) {
      return Estimate{got->value[k], got->fewStretches * std::sqrt(std::max(1e-300, got->covariance(k, k)))};
    };
    // When in its row a drive acts isn't known: against a speed, that looks like an inertia.
    Mechanics out{at(0), at(1), at(2)};
    out.inertia.standardError = std::hypot(out.inertia.standardError, out.viscous.value * longestRow_s(tracks));
    return out;
  }

  /// Of all energy that the drive exchanges with the motion, the part that it gives more than it takes.
  static double energyGone(const std::vector<Track>& tracks) {
    double given = 0.0, all = 0.0;
    for (const Track& track : tracks) {
      for (size_t k = 0; k + 1 < track.rows(); ++k) {
        if (track.connected[k] == 0) continue;
        const double work = track.input[k] * (track.position[k + 1] - track.position[k]);
        given += work;
        all += std::abs(work);
      }
    }
    return all > 0.0 ? given / all : 0.0;
  }

  const Bench& bench_;
  const std::vector<Track>& tracks_;
  const Criteria& limits_;
  const MotorNames& names_;
  std::optional<ShownWinding> winding_;
  bool byCurrent_ = false;
  std::optional<Mechanics> mechanics_;
};

/// A cause at the factor that explains the evidence best.
struct Explanation {
  Cause cause = angle;
  double factor = 1.0;          ///< what stands there over what is true
  double cost = 0.0;            ///< sum of squared strains
  double doubt = inertiaDoubt;  ///< of the factor's logarithm, within which a known mistake is near
  bool enough = false;          ///< no evidence is strained beyond what is honest
};

Explanation explain(Cause cause, const std::vector<Evidence>& all) {
  double along = 0.0, squares = 0.0;
  for (const Evidence& one : all) {
    const double weight = 1.0 / (one.below * one.below);
    along += weight * one.by[cause] * one.logarithm();
    squares += weight * one.by[cause] * one.by[cause];
  }
  Explanation out{cause};
  out.enough = squares > 0.0;
  if (squares <= 0.0) return out;
  const double logarithm = along / squares;
  out.factor = std::exp(logarithm);
  for (const Evidence& one : all) {
    const double strain = one.strain(one.by[cause] * logarithm);
    out.cost += strain * strain;
    out.enough = out.enough && strain <= 1.0;
    const bool constants =
        one.belief && (one.belief->of == BeliefOf::torqueConstant || one.belief->of == BeliefOf::backEmfConstant);
    if (constants && one.by[cause] != 0.0) out.doubt = nearMistake;
  }
  return out;
}

std::string columnOf(Cause cause, const Bench& bench, const Recording& recording) {
  switch (cause) {
    case angle:
      return recording.has(bench.positionChannel()) ? bench.positionChannel() : bench.velocityChannel();
    case current:
      return "current_A";
    case voltage:
      return bench.electrical() ? recordedInput(recording, bench) : "voltage_V";
    case torque:
      return bench.inputChannel();
    default:
      return motorNames(bench.axis).torqueConstant;
  }
}

std::optional<ScaleMistake> mistakeOf(const Explanation& one, Axis axis) {
  switch (one.cause) {
    case angle:
      return scaleMistakeOf(ScaledColumn::angle, axis, one.factor, one.doubt);
    case current:
      return scaleMistakeOf(ScaledColumn::current, axis, one.factor, resistanceDoubt);
    case voltage:
      return scaleMistakeOf(ScaledColumn::voltage, axis, one.factor, resistanceDoubt);
    case torque:
      return scaleMistakeOf(ScaledColumn::torque, axis, one.factor, resistanceDoubt);
    default: {
      const Message words = suggestionOf(BeliefOf::torqueConstant, axis, one.factor);
      return words.empty() ? std::nullopt : std::optional(ScaleMistake{one.factor, words});
    }
  }
}

Message timesText(double factor) {
  return factor >= 1.0 ? message("{:.4g} times too large", factor) : message("{:.4g} times too small", 1.0 / factor);
}

Message mendedText(const std::string& what, double factor) {
  if (factor < 0.0) return message("{} turned", what);
  return factor >= 1.0 ? message("{} divided by {:.4g}", what, factor) : message("{} times {:.4g}", what, 1.0 / factor);
}

/// The evidence that doesn't fit an honest bench, in words.
Message contradictionsIn(const std::vector<Evidence>& all) {
  Message text;
  for (const Evidence& one : all) {
    if (!one.belief || one.strain(0.0) <= 1.0) continue;
    const Belief& belief = *one.belief;
    text = text + (text.empty() ? "" : "; ") +
           message("{} {} is {:.4g}, {} {:.4g}: the first is {:.3g} times as much", belief.source, belief.name,
                   belief.believed, belief.from, belief.measured.value, ratioOf(belief));
  }
  return text;
}

/// Whether Kt or Ke, trusted or said twice alike, contradicts by more than conventions of phases do.
bool isSolid(const std::vector<Evidence>& all, const Bench& bench) {
  const MotorNames& names = motorNames(bench.axis);
  const bool trusted = bench.trusted.contains(names.torqueConstant) || bench.trusted.contains(names.backEmfConstant);
  const bool twice = saysConstantTwice(bench);
  return std::any_of(all.begin(), all.end(), [&](const Evidence& one) {
    const bool constants =
        one.belief && (one.belief->of == BeliefOf::torqueConstant || one.belief->of == BeliefOf::backEmfConstant);
    return constants && (trusted || twice) && one.strain(0.0) > 1.0 &&
           std::abs(one.logarithm()) > std::log(clearOfHonesty);
  });
}

/// `electrical`: voltage and current were both recorded.
Misreading turned(Cause cause, const Bench& bench, bool electrical, const Recording& recording) {
  Misreading out;
  out.what = columnOf(cause, bench, recording);
  out.factor = -1.0;
  out.mended = mendedText(out.what, -1.0);
  if (electrical) {
    const Message others = cause == angle     ? message("voltage and current")
                           : cause == voltage ? message("current and angle")
                                              : message("voltage and angle");
    out.sentence = message("{}: {} has the other sign than {}: turn it", recording.name(), out.what, others);
  } else {
    out.sentence = message(
        "{}: {} has the other sign than the angle: as recorded, the motion would drive the motor, and friction would "
        "drive the motion; turn one of the two",
        recording.name(), out.what);
  }
  return out;
}

/// The bench's torque constant against its own back-EMF constant, unless the recordings show that it is the latter.
std::optional<Misreading> againstItself(const Bench& bench, const std::optional<ShownWinding>& winding) {
  const MotorNames& names = motorNames(bench.axis);
  const auto own = selfContradictionOf(bench);
  if (!own || own->place != names.torqueConstant) return {};
  const double kt = *bench.motor.torqueConstant, ke = *bench.motor.backEmfConstant;
  const auto apart = [](double a, double b) { return std::abs(std::log(a / b)); };
  if (winding && winding->backEmf.value > 0.0 && apart(winding->backEmf.value, kt) < apart(winding->backEmf.value, ke))
    return {};
  return Misreading{names.torqueConstant, true, kt / ke, message("the bench: {}", own->said()),
                    mendedText(names.torqueConstant, kt / ke)};
}

}  // namespace

Result<ScaleCheck> checkScales(const Bench& bench, const std::vector<Recording>& recordings, const Criteria& criteria) {
  std::vector<Track> tracks;
  for (const Recording& recording : recordings) {
    auto track = readTrack(bench, recording);
    if (!track) return track.error();
    tracks.push_back(std::move(*track));
  }
  ScaleCheck out;
  if (bench.servo) return out;  // what acted was not recorded
  const Scales scales(bench, tracks, criteria);
  if (const auto sign = scales.wrongSign()) {
    out.misread = turned(*sign, bench, scales.electrical(), recordings.front());
    return out;
  }
  if (auto own = againstItself(bench, scales.winding())) {
    out.misread = std::move(own);
    return out;
  }
  const std::vector<Evidence> all = scales.evidence();
  if (std::none_of(all.begin(), all.end(), [](const Evidence& one) { return one.belief && one.strain(0.0) > 1.0; }))
    return out;
  std::vector<Explanation> good;
  for (int k = 0; k < causes; ++k) {
    const auto cause = static_cast<Cause>(k);
    if (cause == voltage && columnOf(cause, bench, recordings.front()) == "duty") continue;
    const Explanation one = explain(cause, all);
    if (one.enough) good.push_back(one);
  }
  std::stable_sort(good.begin(), good.end(),
                   [](const Explanation& a, const Explanation& b) { return a.cost < b.cost; });
  const auto named = [&](const Explanation& one) {
    return one.cause <= constant && (mistakeOf(one, bench.axis) || isSolid(all, bench));
  };
  // Of those that explain it alike, one that is a known mistake comes first.
  const auto best = std::find_if(good.begin(), good.end(), [&](const Explanation& one) {
    return one.cost <= good.front().cost + nearlyAsGood && named(one);
  });
  if (best == good.end()) {
    for (const Evidence& one : all) {
      if (!one.belief || one.strain(0.0) <= 1.0) continue;
      if (const auto said = contradictionOf(*one.belief, bench.axis)) out.remarks.push_back(*said);
    }
    return out;
  }
  const auto mistake = mistakeOf(*best, bench.axis);
  Misreading misread;
  misread.what = columnOf(best->cause, bench, recordings.front());
  misread.ofBench = best->cause == constant;
  misread.factor = mistake ? mistake->ratio : best->factor;
  misread.mended = mendedText(misread.what, misread.factor);
  Message others;
  for (const Explanation& one : good) {
    if (one.cause == best->cause || one.cause > constant || one.cost > best->cost + nearlyAsGood) continue;
    others = others + message(", or {} is {}", columnOf(one.cause, bench, recordings.front()), timesText(one.factor));
  }
  misread.sentence =
      message("{}: {} is {}{}: {}{}", misread.ofBench ? message("the bench") : Message(recordings.front().name()),
              misread.what, timesText(misread.factor),
              mistake                ? ", " + mistake->words
              : best->cause == angle ? message(", as behind a gear of that ratio")
                                     : Message(),
              contradictionsIn(all), others);
  out.misread = misread;
  return out;
}

Recording mended(const Recording& recording, const Misreading& misread) {
  if (misread.ofBench) return recording;
  std::vector<Channel> channels = recording.channels();
  for (Channel& one : channels) {
    if (one.name != misread.what) continue;
    for (double& value : one.values) value /= misread.factor;
  }
  return *Recording::seal(recording.name(), std::move(channels), recording.notes());
}

std::vector<Recording> mended(std::vector<Recording> recordings, const std::optional<Misreading>& misread) {
  if (!misread) return recordings;
  for (Recording& one : recordings) one = mended(one, *misread);
  return recordings;
}

Bench mended(Bench bench, const Misreading& misread) {
  if (!misread.ofBench) return bench;
  const bool alike = saysConstantTwice(bench) || !bench.motor.torqueConstant;
  if (bench.motor.torqueConstant) *bench.motor.torqueConstant /= misread.factor;
  if (bench.motor.backEmfConstant && alike) *bench.motor.backEmfConstant /= misread.factor;
  return bench;
}

}  // namespace breakaway
