#include "diagnose/fit/preparation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/numbers.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/channel_checks.h"
#include "diagnose/fit/excitation_seen.h"
#include "diagnose/fit/read_track.h"
#include "diagnose/fit/ringing_start.h"
#include "diagnose/fit/servo_start.h"
#include "diagnose/fit/start_models.h"
#include "diagnose/fit/winding_start.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/simulator.h"

namespace breakaway {

namespace {

constexpr double inductanceReach = 1.5;    ///< a factor up and down
constexpr double slowestWinding_s = 5e-3;  ///< its time constant
constexpr double slowestLoop_s = 5e-4;     ///< time constant of a current loop

/// The shortest look back that knows the velocity to a thousandth of the higher speeds; a longer one lets the model's
/// own faults in.
double restartHorizonFor(const std::vector<Track>& tracks, double highSpeed) {
  for (const double horizon : {0.02, 0.05, 0.1}) {
    const bool enough = std::all_of(tracks.begin(), tracks.end(), [=](const Track& track) {
      return restartVelocityNoise(track, horizon) <= 1e-3 * highSpeed;
    });
    if (enough) return horizon;
  }
  return 0.2;
}

bool currentSeen(const std::vector<Track>& tracks) {
  return std::all_of(tracks.begin(), tracks.end(), [](const Track& track) { return !track.current.empty(); });
}

/// Scale that no data can give: what must be held at the bench's value, besides what is trusted.
std::vector<std::string> gauge(const Bench& bench, const std::vector<Track>& tracks) {
  const MotorNames& names = motorNames(bench.axis);
  const auto trusts = [&bench](const char* name) { return bench.trusted.count(name) > 0; };
  const bool scaled = bench.pendulum.has_value() || trusts(names.inertia);
  if (bench.input == DriveInput::torque) return {};
  if (bench.input == DriveInput::current)
    return scaled || trusts(names.torqueConstant) ? std::vector<std::string>{}
                                                  : std::vector<std::string>{names.torqueConstant};
  if (currentSeen(tracks)) return {};
  // Voltage alone shows ratios: F R/Kt, J R/Kt. Ke shows together with B, and is left to the fit: held too high, no B
  // would do.
  if (scaled && trusts(names.torqueConstant)) return {};
  if (scaled) return {names.resistance};
  return {names.resistance, names.torqueConstant};
}

/// What a servo's law has to be held at besides, as it stands in the base.
std::vector<std::string> heldOfLaw(const Bench& bench, const std::vector<Track>& tracks) {
  const ServoNames& names = servoNames(bench.input, bench.axis);
  const MotorNames& motor = motorNames(bench.axis);
  const auto trusts = [&bench](const std::string& name) { return bench.trusted.count(name) > 0; };
  std::vector<std::string> held;
  for (const char* name : {names.kp, names.kd, names.limit, servoDelayName}) {
    if (trusts(std::string("controller.") + name)) held.emplace_back(name);
  }
  // Without what the reference's speed adds, the axis' own damping is the same as the law's.
  const bool speeds =
      std::all_of(tracks.begin(), tracks.end(), [](const Track& one) { return !one.referenceSpeed.empty(); });
  if (!speeds || !bench.servo->kd) held.emplace_back(names.kd);
  const bool scaled = bench.pendulum.has_value() || trusts(motor.inertia);
  if (!scaled || (bench.input != DriveInput::torque && !trusts(motor.torqueConstant))) held.emplace_back(names.kp);
  return held;
}

/// What the scale of all torques rests on, in words.
Message scaleText(const std::vector<std::string>& held, const std::string& assumedFor) {
  std::string text;
  for (const std::string& one : held) text += (text.empty() ? "" : ", ") + one;
  return assumedFor.empty() ? message("the bench's {}", text)
                            : message("the bench's {} (it doesn't say the resistance)", assumedFor);
}

/// The fits' inductance stays near what the bench says, what the current shows and what the starts have, or between.
void limitInductance(Preparation& prepared, std::optional<double> believed, std::vector<double> shown) {
  std::vector<double> known = std::move(shown);
  if (believed && *believed > 0.0) known.push_back(*believed);
  for (const Model& start : prepared.starts) {
    if (const auto one = start.baseValue(motorNames(start.axis).inductance)) known.push_back(*one);
  }
  if (known.empty()) {  // of a winding that nobody knows: what windings have
    const Physics physics = physicsOf(prepared.starts.front());
    if (physics.electrical) prepared.freedom.mostInductance_H = slowestWinding_s * physics.resistance;
    return;
  }
  const auto [least, most] = std::minmax_element(known.begin(), known.end());
  prepared.freedom.leastInductance_H = *least / inductanceReach;
  prepared.freedom.mostInductance_H = *most * inductanceReach;
}

/// When a drive of current or torque acted isn't known within what a current loop takes to follow; nor, if it was
/// measured, within a row. (How late a voltage acts is the inductance's.)
void limitLateness(Freedom& freedom, const std::vector<Track>& tracks) {
  bool measured = true;
  for (const Track& track : tracks) {
    if (track.drive != DriveInput::current && track.drive != DriveInput::torque) return;
    measured = measured && track.inputNoise > 0.0;
  }
  freedom.row_s = longestRow_s(tracks);
  freedom.leastLate_s = -slowestLoop_s;
  freedom.mostLate_s = measured ? freedom.row_s : 0.0;
}

/// A copy whose rows outside all of the windows count as disconnected, so that no inverse model sees them.
Track masked(const Track& whole, size_t index, const std::vector<const std::vector<Window>*>& sets) {
  Track track = whole;
  std::vector<char> inside(track.rows(), 0);
  for (const auto* windows : sets) {
    for (const Window& window : *windows) {
      if (window.track != index) continue;
      std::fill_n(inside.begin() + static_cast<std::ptrdiff_t>(window.first), window.last - window.first + 1, 1);
    }
  }
  for (size_t row = 0; row < track.rows(); ++row) track.connected[row] = track.connected[row] != 0 && inside[row] != 0;
  return track;
}

constexpr double largeDoubt = 0.1;   ///< beyond it, an interval is a factor up and down
constexpr double scaleDoubt = 0.10;  ///< 95 %, relative

/// Whether it is of a size that only ratios to a held value give: torques, inertias, resistances.
bool holdsScale(const std::string& name) {
  return name.find("_Nm") != std::string::npos || name.find("_N") != std::string::npos ||
         name.find("_kg") != std::string::npos || name.find("_ohm") != std::string::npos;
}

void widen(Parameter& one, double doubt95) {
  const double more = doubt95 * std::abs(one.value);
  one.low95 = one.value - std::hypot(one.value - one.low95, more);
  one.high95 = one.value + std::hypot(one.high95 - one.value, more);
}

/// Of a positive value: `doubt95` is of its logarithm.
void widenByFactor(Parameter& one, double doubt95) {
  const double least = 1e-3 * one.value;  // an interval that reaches zero ends there
  one.low95 = one.value * std::exp(-std::hypot(std::log(one.value / std::max(one.low95, least)), doubt95));
  one.high95 = one.value * std::exp(std::hypot(std::log(one.high95 / one.value), doubt95));
}

}  // namespace

std::vector<Track> heldoutTracks(const Preparation& prepared) {
  const std::vector<Window>& windows = prepared.split.heldoutScore;
  std::vector<Track> tracks;
  for (size_t k = 0; k < prepared.tracks.size(); ++k) {
    if (std::any_of(windows.begin(), windows.end(), [k](const Window& one) { return one.track == k; }))
      tracks.push_back(masked(prepared.tracks[k], k, {&windows}));
  }
  return tracks;
}

Model withDoubts(Model model, const Preparation& prepared) {
  const auto carry = [&prepared](Parameter& one, double doubt) {
    if (one.low95 == one.high95) return;  // held
    if (one.name == "phase_rad") {        // an error across the wave turns it
      one.low95 = one.value - std::hypot(one.value - one.low95, normal95 * doubt);
      one.high95 = one.value + std::hypot(one.high95 - one.value, normal95 * doubt);
      return;
    }
    const bool scaled = prepared.scaleDoubted && holdsScale(one.name) && one.name.find("constant") == std::string::npos;
    const double doubt95 = std::hypot(normal95 * doubt, scaled ? scaleDoubt : 0.0);
    if (doubt > largeDoubt && one.value > 0.0) {
      widenByFactor(one, doubt95);
    } else {
      widen(one, doubt95);
    }
  };
  for (Parameter& one : model.base) carry(one, 0.0);
  for (EffectTerm& term : model.effects) {
    const auto specs = findEffect(term.effect)->parameters(model.axis);
    for (size_t k = 0; k < specs.size(); ++k) carry(term.parameters[k], specs[k].doubt);
  }
  return model;
}

Result<Preparation> prepare(const Bench& bench, const std::vector<Recording>& recordings,
                            const std::vector<Recording>& heldout, double window_s, HeldOut part, ErrorIn errorIn,
                            const Criteria& criteria) {
  Preparation out;
  out.criteria = criteria;
  for (const auto* group : {&recordings, &heldout}) {
    for (const Recording& recording : *group) {
      auto track = readTrack(bench, recording);
      if (!track) return track.error();
      if (!out.tracks.empty() && out.tracks.front().speedAlone() != track->speedAlone())
        return Error{recording.name(), "measures another channel than " + out.tracks.front().name + ": expected " +
                                           bench.positionChannel() + " in all recordings or in none"};
      out.remarks.insert(out.remarks.end(), track->remarks.begin(), track->remarks.end());
      for (Message& remark : channelRemarks(bench, recording, *track, criteria))
        out.remarks.push_back(std::move(remark));
      out.tracks.push_back(std::move(*track));
    }
  }
  out.recordings = recordings.size();
  auto split = splitTracks(out.tracks, recordings.size(), window_s, part, errorIn);
  if (!split) return split.error();
  out.split = std::move(*split);
  for (size_t k = 0; k < out.recordings; ++k)
    out.training.push_back(masked(out.tracks[k], k, {&out.split.train, &out.split.polish}));
  const std::vector<Track>& training = out.training;
  Bench known = bench;
  std::string assumedFor;
  if (bench.electrical() && !bench.motor.resistance_ohm && !currentSeen(training)) {
    if (const auto assumed = assumedResistance(bench, training)) {
      known.motor.resistance_ohm = assumed->value_ohm;
      assumedFor = assumed->scale;
      // The inverse model's inertia is only roughly what windows make of it.
      if (assumedFor == motorNames(bench.axis).inertia) known.trusted.insert(assumedFor);
    }
  }
  if (bench.servo) {
    known.servo = startingLaw(known, training);
    const Model law = believedDrive(known);
    for (auto* tracks : {&out.tracks, &out.training}) {
      for (Track& track : *tracks) track.input = reconstructedInput(law, track);
    }
  }
  const StartingWindings windings = startingWindings(known, training);
  for (const Bench& one : windings.benches) {
    auto starts = startModels(one, training);
    if (!starts) return starts.error();
    out.starts.insert(out.starts.end(), starts->begin(), starts->end());
  }
  if (!currentSeen(training)) {
    const auto ringing = ringingStarts(out.starts.front(), training, {known.trusted.begin(), known.trusted.end()});
    out.starts.insert(out.starts.end(), ringing.begin(), ringing.end());
  }
  if (!bench.servo) limitLateness(out.freedom, out.tracks);
  out.seen = excitationOf(training, out.starts.front());
  out.seen.followsWithin_s = std::max(0.0, -out.freedom.leastLate_s);
  out.seen.immaterial = criteria.immaterial;
  out.seen.soundPart = criteria.soundPart;
  out.seen.immaterialDrive = criteria.immaterialDrive;
  if (out.seen.bothWays) out.freedom.mostBias = out.seen.immaterialTorque();
  out.freedom.held.assign(known.trusted.begin(), known.trusted.end());
  limitInductance(out, bench.motor.inductance_H, windings.shownInductance_H);
  std::vector<std::string> held = gauge(known, training);
  std::erase_if(held, [&bench](const std::string& name) { return bench.trusted.count(name) > 0; });
  out.freedom.held.insert(out.freedom.held.end(), held.begin(), held.end());
  if (bench.servo) {
    const std::vector<std::string> law = heldOfLaw(bench, training);
    out.freedom.held.insert(out.freedom.held.end(), law.begin(), law.end());
    const std::string kp = servoNames(bench.input, bench.axis).kp;
    const bool doubted = bench.trusted.count("controller." + kp) == 0;
    if (doubted && out.freedom.holds(kp)) held.push_back(kp);
  }
  out.scaleDoubted = !held.empty() || !assumedFor.empty();
  if (out.scaleDoubted) {
    out.remarks.push_back(
        message("the scale of all torques rests on {}, which these recordings can't check: trust only ratios",
                scaleText(held, assumedFor)));
  }
  for (Model& start : out.starts) start.restartHorizon_s = restartHorizonFor(out.tracks, out.seen.highSpeed);
  if (out.seen.highSpeed <= 0.0) return Error{recordings.front().name(), "never moves, so there is nothing to fit"};
  return out;
}

}  // namespace breakaway
