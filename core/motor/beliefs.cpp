#include "motor/beliefs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/marked_text.h"

namespace breakaway {

namespace {

constexpr double standardErrors = 3.0;  // of the measured value, at which a difference isn't its noise
constexpr double perDegree = 180.0 / std::numbers::pi, perRpm = 30.0 / std::numbers::pi;
constexpr double exactly = 1.001;

struct Mistake {
  double ratio;  ///< believed over measured
  MessageText<0> words;
};

/// Whatever constant hangs on the angle.
constexpr Mistake ofAngle[] = {
    {perDegree, marked("as with degrees for radians")},
    {1.0 / perDegree, marked("as with degrees for radians")},
    {4.0, marked("as with four edges counted for one line of the encoder")},
    {0.25, marked("as with four edges counted for one line of the encoder")},
    {2.0, marked("as with two edges counted for one line of the encoder, or pole pairs for poles")},
    {0.5, marked("as with two edges counted for one line of the encoder, or pole pairs for poles")},
    {std::numbers::sqrt3, marked("as between two leads for one phase")},
    {1.0 / std::numbers::sqrt3, marked("as for one phase between two leads")},
};

constexpr Mistake ofTorqueConstant[] = {{1e3, marked("as in mNm/A")},         {1e-3, marked("as with mA for A")},
                                        {100.0, marked("as in Ncm/A")},       {10.197, marked("as in kg cm/A")},
                                        {141.6, marked("as in oz in/A")},     {0.10197, marked("as in kg m/A")},
                                        {0.73756, marked("as in lb ft/A")},   {perRpm, marked("as with rpm for rad/s")},
                                        {1.0 / perRpm, marked("as in V/rpm")}};
constexpr Mistake ofForceConstant[] = {
    {1e3, marked("as in mN/A")}, {1e-3, marked("as in kN/A, or with mA for A")}, {0.10197, marked("as in kg/A")}};
constexpr Mistake ofBackEmf[] = {{1e3, marked("as in mV s/rad")},
                                 {1e-3, marked("as with V per 1000")},
                                 {1.0 / perRpm, marked("as in rpm for rad/s: V/rpm")},
                                 {perRpm, marked("as with rpm for rad/s")},
                                 {1e3 / perRpm, marked("as in V per 1000 rpm")}};
constexpr Mistake ofResistance[] = {{1e3, marked("as in milliohms")},
                                    {2.0, marked("as between two leads for one phase")},
                                    {0.5, marked("as for one phase between two leads")},
                                    {1e-3, marked("as in kilohms")}};
constexpr Mistake ofInductance[] = {
    {1e3, marked("as in mH")}, {1e6, marked("as in uH")}, {2.0, marked("as between two leads for one phase")}};
constexpr Mistake ofInertia[] = {{1e7, marked("as in g cm2")},        {1e6, marked("as in kg mm2")},
                                 {1e4, marked("as in kg cm2")},       {1e3, marked("as in g m2")},
                                 {1e-3, marked("as in t m2")},        {9.80665, marked("as in kgf m s2 or by a gear")},
                                 {141612.0, marked("as in oz in s2")}};
constexpr Mistake ofMass[] = {{1e3, marked("as in g")}, {1e-3, marked("as in t")}, {2.2046, marked("as in lb")}};
constexpr Mistake ofCounts[] = {{4.0, marked("as with edges for lines")},
                                {0.25, marked("as with lines for edges")},
                                {2.0, marked("as with the edges of both channels for those of one")},
                                {0.5, marked("as with the edges of one channel for those of both")},
                                {1e3, marked("as per m for per mm")},
                                {1e-3, marked("as per mm for per m")}};
constexpr Mistake ofSupply[] = {{1e3, marked("as in mV")},
                                {2.0, marked("as with another supply, or another divider")},
                                {0.5, marked("as with another supply, or another divider")}};

// Columns of a recording, recorded over true.
constexpr Mistake ofAngleColumn[] = {
    {perDegree, marked("as in degrees")},
    {0.5 / std::numbers::pi, marked("as in turns")},
    {4.0, marked("as with the encoder's lines taken for its counts, four edges a line")},
    {0.25, marked("as with the encoder's edges taken for its lines, four a line")},
    {2.0, marked("as with two edges counted for one line of the encoder")},
    {0.5, marked("as with one edge counted where two were declared")},
    {perRpm, marked("as from a speed in rpm")},
    {1e3, marked("as in mrad")}};
constexpr Mistake ofPositionColumn[] = {
    {1e3, marked("as in mm")},
    {100.0, marked("as in cm")},
    {1e6, marked("as in um")},
    {39.37, marked("as in inches")},
    {4.0, marked("as with the encoder's lines taken for its counts, four edges a line")},
    {0.25, marked("as with the encoder's edges taken for its lines, four a line")},
    {2.0, marked("as with two edges counted for one line of the encoder")},
    {0.5, marked("as with one edge counted where two were declared")}};
constexpr Mistake ofCurrentColumn[] = {{1e3, marked("as in mA")}, {1e-3, marked("as in kA")}};
constexpr Mistake ofVoltageColumn[] = {{1e3, marked("as in mV")}, {1e-3, marked("as in kV")}};
constexpr Mistake ofTorqueColumn[] = {{1e3, marked("as in mNm")},
                                      {100.0, marked("as in Ncm")},
                                      {10.197, marked("as in kg cm")},
                                      {141.6, marked("as in oz in")},
                                      {1e-3, marked("as in kNm")}};
constexpr Mistake ofForceColumn[] = {
    {1e3, marked("as in mN")}, {0.10197, marked("as in kg")}, {1e-3, marked("as in kN")}};

template <size_t N>
void append(const Mistake (&more)[N], std::vector<Mistake>& all) {
  all.insert(all.end(), std::begin(more), std::end(more));
}

std::vector<Mistake> mistakesOf(BeliefOf of, Axis axis) {
  const bool linear = axis == Axis::linear;
  std::vector<Mistake> all;
  switch (of) {
    case BeliefOf::counts:
      append(ofCounts, all);
      break;
    case BeliefOf::supply:
      append(ofSupply, all);
      break;
    case BeliefOf::torqueConstant:
      if (linear) append(ofForceConstant, all);
      if (!linear) append(ofTorqueConstant, all);
      append(ofAngle, all);
      break;
    case BeliefOf::backEmfConstant:
      append(ofBackEmf, all);
      append(ofAngle, all);
      break;
    case BeliefOf::resistance:
      append(ofResistance, all);
      break;
    case BeliefOf::inductance:
      append(ofInductance, all);
      break;
    case BeliefOf::inertia:
      if (linear) append(ofMass, all);
      if (!linear) append(ofInertia, all);
      append(ofAngle, all);
      break;
  }
  return all;
}

std::vector<Mistake> mistakesOf(ScaledColumn column, Axis axis) {
  const bool linear = axis == Axis::linear;
  std::vector<Mistake> all;
  switch (column) {
    case ScaledColumn::angle:
      if (linear) append(ofPositionColumn, all);
      if (!linear) append(ofAngleColumn, all);
      break;
    case ScaledColumn::current:
      append(ofCurrentColumn, all);
      break;
    case ScaledColumn::voltage:
      append(ofVoltageColumn, all);
      break;
    case ScaledColumn::torque:
      if (linear) append(ofForceColumn, all);
      if (!linear) append(ofTorqueColumn, all);
      break;
  }
  return all;
}

Message unitOf(BeliefOf of, Axis axis) {
  const bool linear = axis == Axis::linear;
  switch (of) {
    case BeliefOf::counts:
      return linear ? message("counts per m") : message("counts per turn");
    case BeliefOf::supply:
      return Message("V");
    case BeliefOf::torqueConstant:
      return Message(linear ? "N/A" : "Nm/A");
    case BeliefOf::backEmfConstant:
      return Message(linear ? "V s/m" : "V s/rad");
    case BeliefOf::resistance:
      return Message("ohm");
    case BeliefOf::inductance:
      return Message("H");
    case BeliefOf::inertia:
      return Message(linear ? "kg" : "kg m2");
  }
  return {};
}

double apart(double ratio, double from) {
  return std::abs(std::log(ratio / from));
}

/// The mistake that a ratio looks like; nullptr when none is near.
const Mistake* nearestOf(const std::vector<Mistake>& mistakes, double ratio, double doubt) {
  const auto nearest = std::min_element(mistakes.begin(), mistakes.end(), [ratio](const Mistake& a, const Mistake& b) {
    return apart(ratio, a.ratio) < apart(ratio, b.ratio);
  });
  return nearest != mistakes.end() && apart(ratio, nearest->ratio) < doubt ? &*nearest : nullptr;
}

double relativeError(const Estimate& of) {
  return of.value != 0.0 ? std::abs(of.standardError / of.value) : 0.0;
}

}  // namespace

double honestFactor(BeliefOf of, bool trusted) {
  constexpr double stated = 1.4, wired = 3.0, loaded = 8.0;
  switch (of) {
    case BeliefOf::counts:
      return exactly;
    case BeliefOf::supply:
    case BeliefOf::torqueConstant:
    case BeliefOf::backEmfConstant:
      return stated;
    case BeliefOf::resistance:
    case BeliefOf::inductance:
      return trusted ? stated : wired;
    case BeliefOf::inertia:
      return trusted ? stated : loaded;
  }
  return stated;
}

double ratioOf(const Belief& belief) {
  return belief.believed / belief.measured.value;
}

namespace {

/// `error`: of the ratio, relative; two of them are chance.
Message suggestionWithin(BeliefOf of, Axis axis, double ratio, double error) {
  constexpr double chance = 2.0;
  if (!(ratio > 0.0)) return message("the sign is wrong");
  const auto mistakes = mistakesOf(of, axis);
  const Mistake* nearest = nearestOf(mistakes, ratio, std::max(nearMistake, chance * error));
  return nearest != nullptr ? message(nearest->words) : Message();
}

}  // namespace

Message suggestionOf(BeliefOf of, Axis axis, double ratio) {
  return suggestionWithin(of, axis, ratio, 0.0);
}

std::optional<ScaleMistake> scaleMistakeOf(ScaledColumn column, Axis axis, double ratio, double doubt) {
  if (!(ratio > 0.0) || !std::isfinite(ratio)) return {};
  const auto mistakes = mistakesOf(column, axis);
  const Mistake* nearest = nearestOf(mistakes, ratio, doubt);
  if (nearest == nullptr) return {};
  return ScaleMistake{nearest->ratio, message(nearest->words)};
}

std::optional<Message> contradictionOf(const Belief& belief, Axis axis) {
  const double ratio = ratioOf(belief);
  const bool positive = ratio > 0.0 && std::isfinite(ratio);
  if (positive && apart(ratio, 1.0) <= std::log(honestFactor(belief.of, belief.trusted)) +
                                           standardErrors * relativeError(belief.measured))
    return {};
  const Message hint = suggestionWithin(belief.of, axis, ratio, relativeError(belief.measured));
  return message("{} {} is {:.5g}, {} {:.5g} {}: the first is {:.4g} times as much{}", belief.source, belief.name,
                 belief.believed, belief.from, belief.measured.value, unitOf(belief.of, axis), ratio,
                 hint.empty() ? hint : ", " + hint);
}

std::optional<Error> selfContradictionOf(const Bench& bench) {
  const MotorNames& names = motorNames(bench.axis);
  const MotorBelief& motor = bench.motor;
  if (motor.torqueConstant && motor.backEmfConstant) {
    const Belief constants{BeliefOf::torqueConstant, {},   "",
                           *motor.torqueConstant,    true, {*motor.backEmfConstant, 0.0}};
    if (const double ratio = ratioOf(constants); apart(ratio, 1.0) > std::log(honestFactor(constants.of, true))) {
      const Message hint = suggestionOf(constants.of, bench.axis, ratio);
      return Error{
          names.torqueConstant,
          message("is {:.5g}, but {} is {:.5g}: the first is {:.4g} times as much{}; in SI they are the same quantity",
                  *motor.torqueConstant, names.backEmfConstant, *motor.backEmfConstant, ratio,
                  hint.empty() ? hint : ", " + hint)};
    }
  }
  const std::optional<double> K = motor.torqueConstant ? motor.torqueConstant : motor.backEmfConstant;
  if (!K || !motor.inertia || !motor.resistance_ohm) return {};
  constexpr double least_s = 1e-5, most_s = 100.0;
  const double time_s = *motor.inertia * *motor.resistance_ohm / (*K * *K);
  if (time_s >= least_s && time_s <= most_s) return {};
  return Error{
      names.inertia,
      message("is {:.5g}: with {} {:.5g} and {} {:.5g} the motor's time constant would be {:.3g} s, expected 1e-5 to "
              "100 s; check the units{}",
              *motor.inertia, names.resistance, *motor.resistance_ohm, names.torqueConstant, *K, time_s,
              bench.axis == Axis::linear ? "" : " (1 g cm2 is 1e-7 kg m2)")};
}

}  // namespace breakaway
