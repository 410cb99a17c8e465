// Pictures of terms that have a course: over time, over travel since reversal, over frequency.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/numbers.h"
#include "report/drawn_term.h"

namespace breakaway {

namespace {

constexpr size_t curvePoints = 400;

/// Hidden states along the recording, one sample per point.
std::vector<double> courseOf(const Drawn& drawn, const std::vector<double>& set, std::vector<double>& time) {
  std::vector<double> out;
  std::array<double, 8> memory{};
  const Track& track = drawn.track;
  const size_t every = std::max<size_t>(1, track.rows() / curvePoints);
  const HiddenState* hidden = drawn.effect.hidden();
  const size_t own = hidden != nullptr ? hidden->size() : 0;
  const Physics& p = drawn.physics;
  std::vector<double> input = track.input;
  const InputPart* acting = drawn.effect.input(track.drive);
  if (acting != nullptr) acting->shape(set, track.time, input);
  time.clear();
  for (size_t k = 0; k < track.rows(); ++k) {
    Situation at = typical(drawn);
    at.time_s = track.time[k];
    at.position = track.position[k];
    if (!track.motion.velocity.empty()) at.velocity = track.motion.velocity[k];
    at.input = track.input[k];
    const double volts = track.connected[k] != 0 ? track.input[k] : 0.0;
    if (p.electrical) at.current = track.connected[k] != 0 ? (volts - p.backEmf * at.velocity) / p.resistance : 0.0;
    at.direction = 1.0;
    at.memory = std::span(memory).first(own);
    if (k % every == 0) {
      Situation steady = at;
      steady.current = 0.5 * drawn.seen.peakCurrent;  // so that the picture shows the course, not the motion
      const Term term = drawn.effect.term(set, steady);
      time.push_back(track.origin_s + track.time[k]);
      out.push_back(acting != nullptr             ? input[k] - track.input[k]
                    : drawn.effect.losesVoltage() ? term.voltage_V
                                                  : torqueScale(drawn) * (term.load_Nm + term.friction_Nm));
    }
    if (hidden == nullptr || k + 1 == track.rows()) continue;
    const std::array<double, 8> before = memory;
    at.memory = std::span(before).first(own);
    hidden->remember(set, at, track.time[k + 1] - track.time[k], std::span(memory).first(own));
  }
  return out;
}

}  // namespace

Figure overTime(const Drawn& drawn) {
  const bool shapes = drawn.effect.input(drawn.track.drive) != nullptr;
  Figure figure{.title = {},
                .xLabel = message("time / s"),
                .yLabel = shapes                        ? message("acting − commanded drive")
                          : drawn.effect.losesVoltage() ? message("lost voltage at half the peak current / V")
                                                        : torqueLabel(drawn, TorqueLabel::opposing)};
  Curve curve{.label = {}, .x = {}, .y = {}, .colour = 0};
  for (const auto& set : drawn.sets) {
    const std::vector<double> course = courseOf(drawn, set, curve.x);
    if (curve.y.empty()) curve.y = curve.low = curve.high = course;
    for (size_t k = 0; k < course.size(); ++k) {
      curve.low[k] = std::min(curve.low[k], course[k]);
      curve.high[k] = std::max(curve.high[k], course[k]);
    }
  }
  figure.curves.push_back(std::move(curve));
  return figure;
}

/// Friction that builds up after a reversal, or a dead zone over the twist.
Figure overTravel(const Drawn& drawn) {
  const double scale = rotary(drawn) ? 180.0 / std::numbers::pi : 1e3;
  const std::string unit = rotary(drawn) ? "°" : "mm";
  Figure figure;
  const std::vector<double>& p = drawn.sets.front();
  if (const ElasticFriction* elastic = drawn.effect.elastic()) {
    const double friction = std::max(drawn.physics.coulomb, 1e-12);
    const double reach = 6.0 * friction / elastic->stiffness(p);
    figure.xLabel = message("travel since reversal / {}", unit);
    figure.yLabel = torqueLabel(drawn, TorqueLabel::friction);
    figure.curves.push_back(curveOf(
        drawn, between(0.0, scale * reach),
        [&](const std::vector<double>& set, double x) {
          // From fully the other way: dζ/dθ = (K/F)(1 − ζ), ζ(0) = −1.
          return torqueScale(drawn) * friction *
                 (1.0 - 2.0 * std::exp(-elastic->stiffness(set) * x / scale / friction));
        },
        message("with {}", nameOfEffect(std::string(drawn.effect.name())))));
    figure.curves.push_back({.label = message("rigid friction"),
                             .x = {0.0, scale * reach},
                             .y = {torqueScale(drawn) * friction, torqueScale(drawn) * friction},
                             .style = Curve::Style::dashed,
                             .colour = 6});
    return figure;
  }
  // Torque over the twist between motor and load.
  const LoadPart& load = *drawn.effect.load();
  const double play = load.loadOf(p).play(), reach = 1.5 * play;
  figure.xLabel = message("motor − load / {}", unit);
  figure.yLabel = torqueLabel(drawn, TorqueLabel::transmitted);
  figure.curves.push_back(
      curveOf(drawn, between(-scale * reach, scale * reach), [&](const std::vector<double>& set, double x) {
        const TwoMass at = load.loadOf(set);
        const double beyond = std::abs(x / scale) - at.halfGap;
        return beyond > 0.0 ? torqueScale(drawn) * (x > 0.0 ? 1.0 : -1.0) * at.stiffness() * beyond : 0.0;
      }));
  figure.highlights.push_back({-0.5 * scale * play, 0.5 * scale * play, message("play")});
  return figure;
}

/// How late the effect makes a channel, s.
double lateness(const Drawn& drawn, const std::vector<double>& set) {
  if (const CurrentSensorPart* sensor = drawn.effect.currentSensor()) return sensor->lag_s(set);
  const InputPart* acting = drawn.effect.input(drawn.track.drive);
  return acting != nullptr ? acting->delay_s(set) : 0.0;
}

/// How much stronger or weaker the axis answers than without the effect; for delays, how much later.
Figure overFrequency(const Drawn& drawn) {
  std::vector<double> x;
  const double highest = drawn.seen.step_s > 0.0 ? 0.5 / drawn.seen.step_s : 500.0;
  for (const double part : between(0.0, std::log(highest))) x.push_back(std::exp(part));
  Figure figure{.title = {}, .xLabel = message("frequency / Hz"), .yLabel = {}};
  figure.logX = true;
  if (const LoadPart* load = drawn.effect.load()) {
    figure.yLabel = message("answer to torque, two masses to one");
    figure.logY = true;
    figure.curves.push_back(curveOf(drawn, x, [&](const std::vector<double>& set, double hertz) {
      using Complex = std::complex<double>;
      const Complex s(0.0, turn_rad * hertz);
      const double whole = drawn.physics.inertia;
      const TwoMass at = load->loadOf(set);
      // G = (s² + 2ζω_a s + ω_a²) J/(J_m s² + J (2ζω_a s + ω_a²)).
      const Complex spring = 2.0 * at.dampingRatio * at.frequency * s + at.frequency * at.frequency;
      return std::abs((s * s + spring) * whole / ((whole - at.inertia) * s * s + whole * spring));
    }));
    return figure;
  }
  figure.yLabel = message("phase that the delay takes / °");
  figure.curves.push_back(curveOf(
      drawn, x, [&](const std::vector<double>& set, double hertz) { return -360.0 * hertz * lateness(drawn, set); }));
  return figure;
}

}  // namespace breakaway
