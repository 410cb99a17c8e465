#include "report/term_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/excitation_seen.h"
#include "diagnose/simulate/physics.h"
#include "report/drawn_term.h"

namespace breakaway {

/// The whole friction curve over speed: what the model says without the effect, and with it.
Figure overVelocity(const Drawn& drawn) {
  std::vector<double> x;
  for (const double part : between(1e-3, 1.0)) x.push_back(drawn.seen.highSpeed * part * part);
  const Physics& p = drawn.physics;
  const auto base = [&](double speed) { return torqueScale(drawn) * (p.viscous * speed + p.coulomb); };
  Figure figure{.title = {},
                .xLabel = rotary(drawn) ? message("speed / {}", "rad/s") : message("speed / {}", "m/s"),
                .yLabel = torqueLabel(drawn, TorqueLabel::resisting)};
  addWays(figure, drawn, x, [&](double direction) -> Value {
    return [&drawn, base, direction](const std::vector<double>& set, double speed) {
      Situation at = typical(drawn);
      at.velocity = direction * speed;
      at.direction = direction;
      return base(speed) + direction * opposing(drawn, set, at);
    };
  });
  Curve plain{
      .label = message("dry and viscous friction alone"), .x = x, .y = {}, .style = Curve::Style::dashed, .colour = 6};
  for (const double speed : x) plain.y.push_back(base(speed));
  figure.curves.push_back(std::move(plain));
  return figure;
}

/// Around the turn, or along the travel. What is drawn is the torque, or what the encoder shows wrongly.
Figure overAngle(const Drawn& drawn) {
  const bool whole = rotary(drawn) && drawn.seen.travel >= turn_rad;
  const double scale = rotary(drawn) ? 180.0 / std::numbers::pi : 1e3;
  const double low = whole ? 0.0 : drawn.seen.lowest, high = whole ? turn_rad : drawn.seen.highest;
  const double probe = low + 0.137 * (high - low);
  const auto& first = drawn.sets.front();
  const EncoderPart* encoder = drawn.effect.encoder();
  // What is friction alone is drawn as friction, the same both ways.
  Situation still = typical(drawn);
  still.position = probe;
  const Term term = drawn.effect.term(first, still);
  const bool friction = encoder == nullptr && term.load_Nm == 0.0 && term.friction_Nm != 0.0;
  const auto valueAt = [&](double direction) -> Value {
    return [&drawn, scale, encoder, friction, direction](const std::vector<double>& set, double shown) {
      const double position = shown / scale;
      if (encoder != nullptr) return scale * (encoder->shown(set, position) - position);
      Situation at = typical(drawn);
      at.position = position;
      at.direction = direction;
      at.velocity = direction * (at.velocity > 0.0 ? at.velocity : 1.0);
      return (friction ? direction : 1.0) * opposing(drawn, set, at);
    };
  };
  Figure figure{.title = {},
                .xLabel = rotary(drawn) ? message("angle / °") : message("position / mm"),
                .yLabel = encoder != nullptr
                              ? message("shown − true / {}", rotary(drawn) ? "°" : "mm")
                              : torqueLabel(drawn, friction ? TorqueLabel::resisting : TorqueLabel::opposing)};
  if (whole) figure.xRange = {0.0, 360.0};
  addWays(figure, drawn, between(scale * low, scale * high), valueAt);
  return figure;
}

/// Whether it is the declared load that counts, whatever the motor gives.
bool followsKnownLoad(const Drawn& drawn) {
  Situation at = typical(drawn);
  at.driveTorque = at.current = 0.0;
  at.knownLoad = drawn.seen.knownLoad;
  const double loaded = opposing(drawn, drawn.sets.front(), at);
  at.knownLoad = 0.0;
  return loaded != opposing(drawn, drawn.sets.front(), at);
}

/// Over what the declared load asks for.
Figure overKnownLoad(const Drawn& drawn) {
  const Value value = [&](const std::vector<double>& set, double x) {
    Situation at = typical(drawn);
    at.knownLoad = x;
    return opposing(drawn, set, at);
  };
  Figure figure{.title = {},
                .xLabel = torqueLabel(drawn, TorqueLabel::knownLoad),
                .yLabel = torqueLabel(drawn, TorqueLabel::opposing)};
  figure.curves.push_back(curveOf(drawn, between(-drawn.seen.knownLoad, drawn.seen.knownLoad), value));
  for (double& x : figure.curves.back().x) x *= torqueScale(drawn);
  return figure;
}

/// Over what the motor gives: lost voltage where the term loses voltage, else torque.
Figure overCurrent(const Drawn& drawn) {
  if (followsKnownLoad(drawn)) return overKnownLoad(drawn);
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
                .xLabel = amperes ? message("current / A") : torqueLabel(drawn, TorqueLabel::motor),
                .yLabel = volts ? message("lost voltage / V") : torqueLabel(drawn, TorqueLabel::opposing)};
  figure.curves.push_back(curveOf(drawn, between(-end, end), value));
  if (!amperes) {
    for (double& x : figure.curves.back().x) x *= torqueScale(drawn);
  }
  return figure;
}

std::vector<NamedFigure> termFigures(const Diagnosis& d, const std::vector<Track>& tracks) {
  std::vector<NamedFigure> figures;
  if (tracks.empty()) return figures;
  const Excitation seen = excitationOf(tracks, d.model);
  for (const Finding& finding : d.findings) {
    const Effect* effect = findEffect(finding.effect);
    if (effect == nullptr || finding.parameters.empty()) continue;
    Drawn drawn{*effect, {{}}, physicsOf(d.model), seen, tracks.front()};
    std::vector<double>& values = drawn.sets.front();
    for (const Parameter& one : finding.parameters) values.push_back(one.value);
    values.resize(std::max(values.size(), effect->parameters(seen.axis).size()), 0.0);  // what is absent at zero
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
    figure.title = message("{}: what it adds", nameOfEffect(finding.effect));
    figures.push_back({"term_" + finding.effect,
                       message("The band is what remains when each parameter moves within its 95 % interval."),
                       figure});
  }
  return figures;
}

}  // namespace breakaway
