#include "report/term_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "diagnose/catalogue.h"
#include "diagnose/fit/inverse_fit.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/simulator.h"

namespace breakaway {

namespace {

constexpr int points = 400;
constexpr double turn = 2.0 * std::numbers::pi;

/// What a term is drawn for: the effect, its parameter sets (the fitted one first, then each end of each interval) and
/// what the recordings saw.
struct Drawn {
  const Effect& effect;
  std::vector<std::vector<double>> sets;
  Physics physics;
  Excitation seen;
  const Track& track;
};
using Value = std::function<double(const std::vector<double>& parameters, double at)>;

/// The fitted curve with the extremes that the intervals allow.
Curve curveOf(const Drawn& drawn, const std::vector<double>& x, const Value& value, const std::string& label = {},
              int colour = 0) {
  Curve curve{.label = label, .x = x, .y = {}, .colour = colour};
  for (const double at : x) {
    const double middle = value(drawn.sets.front(), at);
    double low = middle, high = middle;
    for (const auto& set : drawn.sets) {
      low = std::min(low, value(set, at));
      high = std::max(high, value(set, at));
    }
    curve.y.push_back(middle);
    curve.low.push_back(low);
    curve.high.push_back(high);
  }
  return curve;
}

std::vector<double> between(double from, double to) {
  std::vector<double> x;
  for (int k = 0; k <= points; ++k) x.push_back(from + (to - from) * k / points);
  return x;
}

bool rotary(const Drawn& drawn) {
  return drawn.seen.axis == Axis::rotary;
}

std::string torqueLabel(const Drawn& drawn, const std::string& what) {
  return what + (rotary(drawn) ? " torque / mNm" : " force / N");
}

double torqueScale(const Drawn& drawn) {
  return rotary(drawn) ? 1e3 : 1.0;
}

/// Moving steadily towards growing position in the middle of what was seen.
Situation typical(const Drawn& drawn) {
  Situation at;
  at.axis = drawn.seen.axis;
  at.velocity = 0.3 * drawn.seen.highSpeed;
  at.direction = 1.0;
  at.driveTorque = 0.5 * drawn.seen.peakTorque;
  at.current = 0.5 * drawn.seen.peakCurrent;
  at.input = 0.5 * drawn.seen.peakInput;
  at.supply_V = drawn.track.supplyAt(0);
  at.travel = drawn.seen.travel;
  return at;
}

/// What opposes growing position.
double opposing(const Drawn& drawn, const std::vector<double>& p, const Situation& at) {
  const Term term = drawn.effect.term(p, at);
  return torqueScale(drawn) * (term.load_Nm + at.direction * term.friction_Nm);
}

/// The whole friction curve: what the model says without the effect, and with it.
Figure overVelocity(const Drawn& drawn) {
  std::vector<double> x = between(-drawn.seen.highSpeed, 0.0);
  x.back() = -1e-6 * drawn.seen.highSpeed;
  x.push_back(std::nan(""));
  for (const double v : between(0.0, drawn.seen.highSpeed)) x.push_back(std::max(v, 1e-6 * drawn.seen.highSpeed));
  const Physics& p = drawn.physics;
  const auto base = [&](double v) { return torqueScale(drawn) * (p.viscous * v + (v > 0.0 ? 1.0 : -1.0) * p.coulomb); };
  Figure figure{.title = {},
                .xLabel = rotary(drawn) ? "velocity / rad/s" : "velocity / m/s",
                .yLabel = torqueLabel(drawn, "opposing")};
  figure.curves.push_back(curveOf(
      drawn, x,
      [&](const std::vector<double>& set, double v) {
        Situation at = typical(drawn);
        at.velocity = v;
        at.direction = v > 0.0 ? 1.0 : -1.0;
        return std::isfinite(v) ? base(v) + opposing(drawn, set, at) : std::nan("");
      },
      "friction with " + std::string(drawn.effect.name())));
  Curve plain{.label = "dry and viscous friction alone", .x = x, .y = {}, .style = Curve::Style::dashed, .colour = 6};
  for (const double v : x) plain.y.push_back(base(v));
  figure.curves.push_back(std::move(plain));
  return figure;
}

/// Around the turn, or along the travel. What is drawn is the torque, or what the encoder shows wrongly.
Figure overAngle(const Drawn& drawn) {
  const bool whole = rotary(drawn) && drawn.seen.travel >= turn;
  const double scale = rotary(drawn) ? 180.0 / std::numbers::pi : 1e3;
  const double low = whole ? 0.0 : drawn.seen.lowest, high = whole ? turn : drawn.seen.highest;
  const double probe = low + 0.137 * (high - low);
  const auto& first = drawn.sets.front();
  const bool encoder = drawn.effect.shown(first, probe) != probe;
  const auto valueAt = [&](double direction) {
    return [&drawn, scale, encoder, direction](const std::vector<double>& set, double shown) {
      const double position = shown / scale;
      if (encoder) return scale * (drawn.effect.shown(set, position) - position);
      Situation at = typical(drawn);
      at.position = position;
      at.direction = direction;
      at.velocity = direction * (at.velocity > 0.0 ? at.velocity : 1.0);
      return opposing(drawn, set, at);
    };
  };
  Figure figure{
      .title = {},
      .xLabel = rotary(drawn) ? "angle / °" : "position / mm",
      .yLabel = encoder ? (rotary(drawn) ? "shown − true / °" : "shown − true / mm") : torqueLabel(drawn, "opposing")};
  if (whole) figure.xRange = {0.0, 360.0};
  const std::vector<double> x = between(scale * low, scale * high);
  const Value forth = valueAt(1.0), back = valueAt(-1.0);
  bool sameBothWays = true;
  for (const double at : x) {
    const double a = forth(first, at), b = back(first, at);
    sameBothWays = sameBothWays && std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b));
  }
  figure.curves.push_back(curveOf(drawn, x, forth,
                                  sameBothWays    ? "both ways"
                                  : rotary(drawn) ? "counter-clockwise"
                                                  : "towards growing position"));
  if (!sameBothWays)
    figure.curves.push_back(curveOf(drawn, x, back, rotary(drawn) ? "clockwise" : "towards falling position", 1));
  return figure;
}

/// Over what the motor gives: lost voltage where the term loses voltage, else torque.
Figure overCurrent(const Drawn& drawn) {
  const bool amperes = drawn.seen.peakCurrent > 0.0;
  const double end = amperes ? drawn.seen.peakCurrent : drawn.seen.peakTorque;
  const bool volts = drawn.effect.losesVoltage();
  const Value value = [&](const std::vector<double>& set, double x) {
    Situation at = typical(drawn);
    at.current = amperes ? x : 0.0;
    at.driveTorque = amperes ? x * drawn.physics.torqueConstant : x;
    at.input = x / end * drawn.seen.peakInput;
    return volts ? drawn.effect.term(set, at).voltage_V : opposing(drawn, set, at);
  };
  Figure figure{.title = {},
                .xLabel = amperes ? "current / A" : torqueLabel(drawn, "motor"),
                .yLabel = volts ? "lost voltage / V" : torqueLabel(drawn, "opposing")};
  figure.curves.push_back(curveOf(drawn, between(-end, end), value));
  if (!amperes) {
    for (double& x : figure.curves.back().x) x *= torqueScale(drawn);
  }
  return figure;
}

/// Hidden states along the recording, one sample per point.
std::vector<double> courseOf(const Drawn& drawn, const std::vector<double>& set, std::vector<double>& time) {
  std::vector<double> out;
  std::array<double, 8> memory{};
  const Track& track = drawn.track;
  const size_t every = std::max<size_t>(1, track.rows() / points), own = drawn.effect.memory();
  const Physics& p = drawn.physics;
  std::vector<double> input = track.input;
  const bool shapes = drawn.effect.shapesInput(track.drive);
  if (shapes) drawn.effect.shapeInput(set, track.time, input);
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
      out.push_back(shapes                        ? input[k] - track.input[k]
                    : drawn.effect.losesVoltage() ? term.voltage_V
                                                  : torqueScale(drawn) * (term.load_Nm + term.friction_Nm));
    }
    if (own == 0 || k + 1 == track.rows()) continue;
    const std::array<double, 8> before = memory;
    at.memory = std::span(before).first(own);
    drawn.effect.remember(set, at, track.time[k + 1] - track.time[k], std::span(memory).first(own));
  }
  return out;
}

Figure overTime(const Drawn& drawn) {
  const bool shapes = drawn.effect.shapesInput(drawn.track.drive);
  Figure figure{.title = {},
                .xLabel = "time / s",
                .yLabel = shapes                        ? "acting − commanded drive"
                          : drawn.effect.losesVoltage() ? "lost voltage at half the peak current / V"
                                                        : torqueLabel(drawn, "opposing")};
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
  if (drawn.effect.frictionStiffness(p) > 0.0) {
    const double friction = std::max(drawn.physics.coulomb, 1e-12);
    const double reach = 6.0 * friction / drawn.effect.frictionStiffness(p);
    figure.xLabel = "travel since reversal / " + unit;
    figure.yLabel = torqueLabel(drawn, "friction");
    figure.curves.push_back(curveOf(
        drawn, between(0.0, scale * reach),
        [&](const std::vector<double>& set, double x) {
          // From fully the other way: dζ/dθ = (K/F)(1 − ζ), ζ(0) = −1.
          return torqueScale(drawn) * friction *
                 (1.0 - 2.0 * std::exp(-drawn.effect.frictionStiffness(set) * x / scale / friction));
        },
        "with " + std::string(drawn.effect.name())));
    figure.curves.push_back({.label = "rigid friction",
                             .x = {0.0, scale * reach},
                             .y = {torqueScale(drawn) * friction, torqueScale(drawn) * friction},
                             .style = Curve::Style::dashed,
                             .colour = 6});
    return figure;
  }
  // Load inertia, gap, stiffness: torque over the twist between motor and load.
  const double reach = 1.5 * p[1];
  figure.xLabel = "motor − load / " + unit;
  figure.yLabel = torqueLabel(drawn, "transmitted");
  figure.curves.push_back(
      curveOf(drawn, between(-scale * reach, scale * reach), [&](const std::vector<double>& set, double x) {
        const double beyond = std::abs(x / scale) - 0.5 * set[1];
        return beyond > 0.0 ? torqueScale(drawn) * (x > 0.0 ? 1.0 : -1.0) * set[2] * beyond : 0.0;
      }));
  figure.highlights.push_back({-0.5 * scale * p[1], 0.5 * scale * p[1], "play"});
  return figure;
}

/// How much stronger or weaker the axis answers than without the effect; for delays, how much later.
Figure overFrequency(const Drawn& drawn) {
  std::vector<double> x;
  const double highest = drawn.seen.step_s > 0.0 ? 0.5 / drawn.seen.step_s : 500.0;
  for (int k = 0; k <= points; ++k) x.push_back(std::exp(std::log(1.0) + std::log(highest) * k / points));
  Figure figure{.title = {}, .xLabel = "frequency / Hz", .yLabel = {}};
  figure.logX = true;
  if (drawn.effect.detachedInertia(drawn.sets.front()) > 0.0) {
    figure.yLabel = "answer to torque, two masses to one";
    figure.logY = true;
    figure.curves.push_back(curveOf(drawn, x, [&](const std::vector<double>& set, double hertz) {
      using Complex = std::complex<double>;
      const Complex s(0.0, turn * hertz);
      const double whole = drawn.physics.inertia;
      // J_load, ω_a and ζ; G = (s² + 2ζω_a s + ω_a²) J/(J_m s² + J (2ζω_a s + ω_a²)).
      const Complex spring = 2.0 * set[2] * set[1] * s + set[1] * set[1];
      return std::abs((s * s + spring) * whole / ((whole - set[0]) * s * s + whole * spring));
    }));
    return figure;
  }
  figure.yLabel = "phase that the delay takes / °";
  figure.curves.push_back(
      curveOf(drawn, x, [&](const std::vector<double>& set, double hertz) { return -360.0 * hertz * set[0]; }));
  return figure;
}

}  // namespace

std::vector<NamedFigure> termFigures(const Diagnosis& d, const std::vector<Track>& tracks) {
  std::vector<NamedFigure> figures;
  if (tracks.empty()) return figures;
  const Excitation seen = excitationOf(tracks, d.model);
  for (const Finding& finding : d.findings) {
    const Effect* effect = findEffect(finding.effect);
    if (effect == nullptr || finding.parameters.empty()) continue;
    Drawn drawn{*effect, {{}}, physicsOf(d.model), seen, tracks.front()};
    for (const Parameter& one : finding.parameters) drawn.sets.front().push_back(one.value);
    for (size_t k = 0; k < finding.parameters.size(); ++k) {
      for (const double end : {finding.parameters[k].low95, finding.parameters[k].high95}) {
        drawn.sets.push_back(drawn.sets.front());
        drawn.sets.back()[k] = end;
      }
    }
    const std::string_view over = effect->drawnOver();
    const auto draw = over == "velocity"    ? overVelocity
                      : over == "angle"     ? overAngle
                      : over == "current"   ? overCurrent
                      : over == "time"      ? overTime
                      : over == "travel"    ? overTravel
                      : over == "frequency" ? overFrequency
                                            : nullptr;
    if (draw == nullptr) continue;
    Figure figure = draw(drawn);
    figure.title = finding.effect + ": what it adds";
    figures.push_back({"term_" + finding.effect,
                       "The band is what remains when each parameter moves within its 95 % interval.", figure});
  }
  return figures;
}

}  // namespace breakaway
