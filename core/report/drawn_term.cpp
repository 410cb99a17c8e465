#include "report/drawn_term.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr int points = 400;

Message wayLabel(const Drawn& drawn, double direction) {
  if (rotary(drawn)) return direction > 0.0 ? message("counter-clockwise") : message("clockwise");
  return direction > 0.0 ? message("towards growing position") : message("towards falling position");
}

}  // namespace

Curve curveOf(const Drawn& drawn, const std::vector<double>& x, const Value& value, const Message& label, int colour) {
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

Message torqueLabel(const Drawn& drawn, TorqueLabel what) {
  const bool turns = rotary(drawn);
  switch (what) {
    case TorqueLabel::opposing:
      return turns ? message("opposing torque / mNm") : message("opposing force / N");
    case TorqueLabel::resisting:
      return turns ? message("resisting torque / mNm") : message("resisting force / N");
    case TorqueLabel::friction:
      return turns ? message("friction torque / mNm") : message("friction force / N");
    case TorqueLabel::transmitted:
      return turns ? message("transmitted torque / mNm") : message("transmitted force / N");
    case TorqueLabel::motor:
      return turns ? message("motor torque / mNm") : message("motor force / N");
    case TorqueLabel::knownLoad:
      return turns ? message("known load's torque / mNm") : message("known load's force / N");
  }
  return {};
}

double torqueScale(const Drawn& drawn) {
  return rotary(drawn) ? 1e3 : 1.0;
}

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

double opposing(const Drawn& drawn, const std::vector<double>& p, const Situation& at) {
  const size_t own = drawn.effect.parameters(drawn.seen.axis).size();
  double sum = 0.0;
  for (size_t from = 0; from + own <= p.size(); from += own) {  // wave by wave
    const Term term = drawn.effect.term(std::span(p).subspan(from, own), at);
    sum += term.load_Nm + at.direction * term.friction_Nm;
  }
  return torqueScale(drawn) * sum;
}

void addWays(Figure& figure, const Drawn& drawn, const std::vector<double>& x,
             const std::function<Value(double direction)>& value) {
  const Value forth = value(1.0), back = value(-1.0);
  const auto& first = drawn.sets.front();
  const bool alike = std::all_of(x.begin(), x.end(), [&](double at) {
    const double a = forth(first, at), b = back(first, at);
    return std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b));
  });
  figure.curves.push_back(curveOf(drawn, x, forth, alike ? message("both ways") : wayLabel(drawn, 1.0)));
  if (!alike) figure.curves.push_back(curveOf(drawn, x, back, wayLabel(drawn, -1.0), 1));
}

}  // namespace breakaway
