#include "identify/motor_identification.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "dense/dense_solve.h"
#include "identify/spin_disc.h"

namespace breakaway {

namespace {

constexpr size_t leastRows = 20;
constexpr int ownColumns = 3, positionOrders = 4;  // of the momentum balance
constexpr double windowDoubt = 1.5e-3;  // relative, of inertia: speeds at the windows' ends are means over two blocks
constexpr double modelDoubt = 7e-4;     // relative: blocks, ticks and the winding's lag

struct LeastSquares {
  Eigen::VectorXd x, error;
  double variance = 0.0;  ///< of a row, by what is left over
};

LeastSquares solve(const std::vector<Eigen::VectorXd>& rows, const std::vector<double>& right) {
  const Eigen::Index n = static_cast<Eigen::Index>(rows.size()), m = rows.front().size();
  Eigen::MatrixXd A(n, m);
  Eigen::VectorXd y(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    A.row(k) = rows[static_cast<size_t>(k)].transpose();
    y[k] = right[static_cast<size_t>(k)];
  }
  LeastSquares result;
  result.x = leastSquares(A, y);
  result.variance = (y - A * result.x).squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, n - m));
  result.error = (result.variance * inverseOf(A.transpose() * A).diagonal()).cwiseSqrt();
  return result;
}

/// The same, where the first column has errors of a known variance that don't hang on the others (W. A. Fuller,
/// Measurement Error Models, section 2.2). Where they are most of what is its own, the answer's error says so.
LeastSquares solveRounded(const std::vector<Eigen::VectorXd>& rows, const std::vector<double>& right, double variance) {
  constexpr double leastTold = 0.25;  // of the square, that a correction is made down to
  constexpr double doubt = 0.3;       // of the correction
  if (!(variance > 0.0)) return solve(rows, right);
  const LeastSquares plain = solve(rows, right);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(plain.x.size(), plain.x.size());
  Eigen::VectorXd moments = Eigen::VectorXd::Zero(plain.x.size());
  for (size_t k = 0; k < rows.size(); ++k) {
    normal += rows[k] * rows[k].transpose();
    moments += right[k] * rows[k];
  }
  const double own = 1.0 / inverseOf(normal)(0, 0), off = static_cast<double>(rows.size()) * variance;
  normal(0, 0) -= std::min(off, (1.0 - leastTold) * own);
  LeastSquares freed = plain;
  freed.x = solveSymmetric(normal, moments);
  freed.error *= freed.x[0] / plain.x[0];
  freed.error[0] = std::hypot(freed.error[0], std::max(doubt, off / own - leastTold) * (freed.x[0] - plain.x[0]));
  return freed;
}

/// Speed over each block, from its two ends; the first block has none.
std::vector<double> speeds(const std::vector<SpinBlock>& blocks) {
  std::vector<double> speed(blocks.size(), 0.0);
  for (size_t k = 1; k < blocks.size(); ++k)
    speed[k] = (blocks[k].angle_rad - blocks[k - 1].angle_rad) / blocks[k].duration_s;
  return speed;
}

Result<LeastSquares> fitBackEmf(const std::vector<SpinBlock>& blocks, const std::vector<double>& speed, double least,
                                double R) {
  std::vector<Eigen::VectorXd> rows;
  std::vector<double> right;
  for (size_t k = 1; k < blocks.size(); ++k) {
    if (std::abs(speed[k]) < least || speed[k] * blocks[k].voltage_V <= 0.0) continue;
    rows.push_back(Eigen::Vector2d(speed[k], std::copysign(1.0, blocks[k].voltage_V)));
    right.push_back(blocks[k].voltage_V - R * blocks[k].current_A);
  }
  if (rows.size() < leastRows)
    return Error{"motor", message("turns in {} blocks only, expected at least 20", rows.size())};
  return solve(rows, right);
}

/// Resistance from the spinning motor, where accelerating draws current: v = R·i + Ke·ω + V0·sgn v. The noise of the
/// blocks' currents pulls it low by less than the 1 % that is added to its error.
Estimate spinningResistance(const std::vector<SpinBlock>& blocks, const std::vector<double>& speed, double least) {
  std::vector<Eigen::VectorXd> rows;
  std::vector<double> right;
  for (size_t k = 1; k < blocks.size(); ++k) {
    if (std::abs(speed[k]) < least || speed[k] * blocks[k].voltage_V <= 0.0) continue;
    rows.push_back(Eigen::Vector3d(blocks[k].current_A, speed[k], std::copysign(1.0, blocks[k].voltage_V)));
    right.push_back(blocks[k].voltage_V);
  }
  if (rows.size() < leastRows) return {0.0, 0.0};
  const LeastSquares fit = solve(rows, right);
  return {fit.x[0], std::hypot(fit.error[0], 0.01 * fit.x[0])};
}

Estimate combined(const Estimate& a, const Estimate& b) {
  const double u = 1.0 / (a.standardError * a.standardError), v = 1.0 / (b.standardError * b.standardError);
  return {(u * a.value + v * b.value) / (u + v), 1.0 / std::sqrt(u + v)};
}

/// Without the waves of position torque that hardly act over windows, for these span turns, and without all of them
/// where the windows are few or none shows.
void keepActing(std::vector<Eigen::VectorXd>& rows, const std::vector<double>& right) {
  constexpr double acting = 0.1;  // rms over the window, of what acts all through it
  constexpr size_t enough = 6;    // rows per column
  constexpr double shows = 40.0;  // gain in χ²
  double whole = 0.0;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(rows.front().size());
  for (const Eigen::VectorXd& row : rows) whole += row[1] * row[1], squares += row.cwiseAbs2();
  std::vector<Eigen::Index> kept{0, 1, 2};
  for (Eigen::Index k = ownColumns; k + 1 < squares.size(); k += 2) {
    const bool acts = 0.5 * (squares[k] + squares[k + 1]) > acting * acting * whole;
    if (acts && rows.size() >= enough * (kept.size() + 2)) kept.insert(kept.end(), {k, k + 1});
  }
  std::vector<Eigen::VectorXd> own;
  for (Eigen::VectorXd& row : rows) {
    row = Eigen::VectorXd(row(kept));
    own.emplace_back(row.head<ownColumns>());
  }
  const auto freedom = static_cast<double>(rows.size()) - static_cast<double>(kept.size());
  const auto waves = static_cast<double>(kept.size()) - ownColumns;
  const double with = solve(rows, right).variance, without = solve(own, right).variance;
  if ((freedom + waves) * without - freedom * with < (shows + waves) * with) rows = std::move(own);
}

/// J·Δω + C·sgn ω·T + B·Δθ and what position torque of the first orders gives, an arm's weight or cogging: on an axis
/// that turns slowly it is more than what accelerates.
Result<LeastSquares> fitMomentum(const std::vector<SpinBlock>& blocks, const std::vector<double>& speed, double least,
                                 double Kt, const MotorIdentificationOptions& options) {
  std::vector<Eigen::VectorXd> rows;
  std::vector<double> right;
  const auto width = static_cast<size_t>(std::max(3.0, std::round(options.window_s / blocks.front().duration_s)));
  for (size_t k = 1; k + width + 1 < blocks.size(); k += width) {
    bool oneWay = true;
    for (size_t j = k; j <= k + width + 1; ++j)
      oneWay = oneWay && speed[j] * speed[k] > 0.0 && std::abs(speed[j]) > least;
    if (!oneWay) continue;
    double impulse = 0.0, duration = 0.0;
    for (size_t j = k + 1; j <= k + width; ++j) {
      impulse += Kt * blocks[j].current_A * blocks[j].duration_s;
      duration += blocks[j].duration_s;
    }
    // The speed at a block's end is the mean of the blocks on both sides.
    const double before = 0.5 * (speed[k] + speed[k + 1]), after = 0.5 * (speed[k + width] + speed[k + width + 1]);
    const double travel = blocks[k + width].angle_rad - blocks[k].angle_rad;
    Eigen::VectorXd row = Eigen::VectorXd::Zero(ownColumns + 2 * positionOrders);
    row.head<ownColumns>() << after - before, std::copysign(duration, travel), travel;
    for (int n = 1; n <= positionOrders; ++n) {
      std::complex<double> wave = 0.0;
      for (size_t j = k + 1; j <= k + width; ++j)
        wave += waveOver(n, blocks[j - 1].angle_rad, blocks[j].angle_rad, blocks[j].duration_s);
      row.segment<2>(ownColumns + 2 * (n - 1)) << wave.real(), wave.imag();
    }
    rows.push_back(std::move(row));
    right.push_back(impulse);
  }
  if (rows.size() < leastRows)
    return Error{"motor", message("turns one way in {} windows only, expected at least 20", rows.size())};
  keepActing(rows, right);
  // Of each window's two speeds, from two roundings over two blocks each.
  const double rounding = options.count_rad / blocks.front().duration_s;
  return solveRounded(rows, right, rounding * rounding / 12.0);
}

}  // namespace

Result<IdentifiedMotor> identifyMotor(const std::vector<SpinBlock>& blocks, const WindingLine& winding,
                                      const Estimate& timeConstant_s, const MotorIdentificationOptions& options) {
  if (blocks.size() < 2 * leastRows)
    return Error{"motor", message("has {} blocks only, expected at least 40", blocks.size())};
  const std::vector<double> speed = speeds(blocks);
  double highest = 0.0;
  for (const double one : speed) highest = std::max(highest, std::abs(one));
  const double least = 0.1 * highest;
  const Estimate spinning = spinningResistance(blocks, speed, least);
  const bool both = spinning.value > 0.0 && spinning.standardError > 0.0 && winding.resistance_ohm.standardError > 0.0;
  Estimate resistance = both ? combined(winding.resistance_ohm, spinning) : winding.resistance_ohm;
  resistance.standardError = std::hypot(resistance.standardError, 2.0 * modelDoubt * resistance.value);
  const double R = resistance.value;
  const auto emf = fitBackEmf(blocks, speed, least, R);
  if (!emf) return emf.error();
  IdentifiedMotor motor;
  // What the resistance leaves open goes into the back-EMF constant, and so does what no model of the rig is free of.
  const auto other = fitBackEmf(blocks, speed, least, R + resistance.standardError);
  const double byResistance = other ? other->x[0] - emf->x[0] : 0.0;
  motor.backEmfConstant_V_s_per_rad = {emf->x[0], std::hypot(emf->error[0], byResistance, modelDoubt * emf->x[0])};
  motor.resistance_ohm = resistance;
  motor.deadZone_V = winding.deadZone_V;
  motor.inductance_H.value = timeConstant_s.value * R;
  motor.inductance_H.standardError =
      std::hypot(timeConstant_s.standardError * R, timeConstant_s.value * resistance.standardError);
  motor.torqueConstantTrusted = options.trustedTorqueConstant_Nm_per_A.has_value();
  motor.torqueConstant_Nm_per_A = motor.torqueConstantTrusted ? Estimate{*options.trustedTorqueConstant_Nm_per_A, 0.0}
                                                              : motor.backEmfConstant_V_s_per_rad;
  const auto momentum = fitMomentum(blocks, speed, 0.25 * highest, motor.torqueConstant_Nm_per_A.value, options);
  if (!momentum) return momentum.error();
  motor.inertia_kg_m2 = {momentum->x[0], std::hypot(momentum->error[0], windowDoubt * momentum->x[0])};
  motor.rampInertia_kg_m2 = motor.inertia_kg_m2;
  motor.coulomb_Nm = {momentum->x[1], momentum->error[1]};
  motor.viscous_Nm_s_per_rad = {momentum->x[2], momentum->error[2]};
  if (!(motor.inertia_kg_m2.value > 0.0)) return Error{"motor", message("shows no inertia, expected a positive one")};
  return motor;
}

double joinInertia(IdentifiedMotor& motor, const Estimate& reversal) {
  const Estimate& ramp = motor.rampInertia_kg_m2;
  motor.reversalInertia_kg_m2 = reversal;
  if (!(reversal.standardError > 0.0) || !(ramp.standardError > 0.0)) return 0.0;
  const double apart = std::abs(ramp.value - reversal.value) / std::hypot(ramp.standardError, reversal.standardError);
  motor.inertia_kg_m2 = combined(ramp, reversal);
  motor.inertia_kg_m2.standardError *= std::max(1.0, apart);
  return apart;
}

void takeBridge(IdentifiedMotor& motor, const BridgeFit& bridge, const Estimate& timeConstant_s) {
  const double tau = timeConstant_s.value;
  motor.resistance_ohm = bridge.resistance_ohm;
  motor.inductance_H = {tau * bridge.resistance_ohm.value,
                        std::hypot(timeConstant_s.standardError * bridge.resistance_ohm.value,
                                   tau * bridge.resistance_ohm.standardError)};
  motor.dutyCurve = bridge.curve;
  if (bridge.curve.known()) motor.deadZone_V = bridge.deadZone_V;
  const double by = bridge.backEmfConstant_V_s_per_rad.value / motor.backEmfConstant_V_s_per_rad.value;
  motor.backEmfConstant_V_s_per_rad = bridge.backEmfConstant_V_s_per_rad;
  if (motor.torqueConstantTrusted) return;
  motor.torqueConstant_Nm_per_A = motor.backEmfConstant_V_s_per_rad;
  for (Estimate* one : {&motor.rampInertia_kg_m2, &motor.reversalInertia_kg_m2, &motor.inertia_kg_m2, &motor.coulomb_Nm,
                        &motor.viscous_Nm_s_per_rad}) {
    one->value *= by;
    one->standardError *= by;
  }
}

double widenByBridge(IdentifiedMotor& motor, const Estimate& any) {
  Estimate& Ke = motor.backEmfConstant_V_s_per_rad;
  Ke.standardError = std::hypot(Ke.standardError, any.standardError, any.value - Ke.value);
  if (!motor.torqueConstantTrusted) motor.torqueConstant_Nm_per_A = Ke;
  return Ke.standardError / Ke.value;
}

namespace {

double relative(const Estimate& one) {
  return one.value != 0.0 ? one.standardError / one.value : 0.0;
}

/// Of the gain that the added inertia shows; nothing where it doesn't stand out.
std::optional<Estimate> gainByAdded(const Estimate& shown, const AddedInertia& added) {
  const double seen = shown.value - added.shownOther_kg_m2.value;
  const double doubt = std::hypot(shown.standardError, added.shownOther_kg_m2.standardError);
  const double gain = seen / added.added_kg_m2.value;
  if (!(gain > 0.0) || std::abs(seen) < 5.0 * doubt) return {};
  return Estimate{gain, gain * std::hypot(doubt / seen, relative(added.added_kg_m2))};
}

/// J = D·J₂/(J₂ − J₁) of what was shown without and with D more.
Estimate inertiaByAdded(const Estimate& shown, const AddedInertia& added) {
  const double J2 = shown.value, J1 = added.shownOther_kg_m2.value, D = added.added_kg_m2.value, apart = J2 - J1;
  const double by2 = -D * J1 / (apart * apart) * shown.standardError;
  const double by1 = D * J2 / (apart * apart) * added.shownOther_kg_m2.standardError;
  return {D * J2 / apart, std::hypot(by2, by1, J2 / apart * added.added_kg_m2.standardError)};
}

}  // namespace

void setCurrentScale(IdentifiedMotor& motor, const CurrentScaleOptions& options) {
  const bool linear = options.axis == Axis::linear;
  motor.shownInertia_kg_m2 = motor.inertia_kg_m2;
  const double Kt = relative(motor.torqueConstant_Nm_per_A);
  Estimate gain{1.0, options.gainInterval / normal95};
  std::optional<Estimate> inertia;
  const auto byAdded = options.added ? gainByAdded(motor.inertia_kg_m2, *options.added) : std::nullopt;
  if (options.trustedInertia_kg_m2) {
    gain.value = motor.inertia_kg_m2.value / *options.trustedInertia_kg_m2;
    gain.standardError = gain.value * std::hypot(relative(motor.inertia_kg_m2), Kt);
    inertia = Estimate{*options.trustedInertia_kg_m2, 0.0};
    motor.gauge =
        linear ? message(
                     "The scale of all forces rests on the trusted mass: by it the current sensor shows {:.4g} ({:.4g} "
                     "to {:.4g}) of the true current.",
                     gain.value, gain.low95(), gain.high95())
               : message(
                     "The scale of all torques rests on the trusted inertia: by it the current sensor shows {:.4g} "
                     "({:.4g} to {:.4g}) of the true current.",
                     gain.value, gain.low95(), gain.high95());
  } else if (byAdded) {
    gain = {byAdded->value, byAdded->value * std::hypot(relative(*byAdded), Kt)};
    inertia = inertiaByAdded(motor.inertia_kg_m2, *options.added);
    motor.gauge =
        linear ? message(
                     "The scale of all forces rests on the known added mass: by it the current sensor shows {:.4g} "
                     "({:.4g} to {:.4g}) of the true current.",
                     gain.value, gain.low95(), gain.high95())
               : message(
                     "The scale of all torques rests on the disc of known inertia: by it the current sensor shows "
                     "{:.4g} ({:.4g} to {:.4g}) of the true current.",
                     gain.value, gain.low95(), gain.high95());
  } else {
    const Message added =
        !options.added ? Message()
        : linear       ? message("The added mass doesn't stand out of the mass's doubt and measures nothing. ")
                       : message("The added inertia doesn't stand out of the inertia's doubt and measures nothing. ");
    const double percent = 100.0 * options.gainInterval;
    motor.gauge =
        added + (linear ? message("The scale of all forces rests on the current sensor's gain, taken as right "
                                  "within ±{:.3g} %: resistance, inductance, mass and friction share that doubt, their "
                                  "ratios are free of it.",
                                  percent)
                        : message("The scale of all torques rests on the current sensor's gain, taken as right "
                                  "within ±{:.3g} %: resistance, inductance, inertia and friction share that doubt, "
                                  "their ratios are free of it.",
                                  percent));
  }
  motor.currentGain = gain;
  const double doubt = relative(gain);
  const auto scale = [doubt](Estimate& one, double by, double further) {
    one.value *= by;
    one.standardError = std::hypot(std::abs(by) * one.standardError, one.value * doubt, one.value * further);
  };
  scale(motor.resistance_ohm, gain.value, 0.0);
  scale(motor.inductance_H, gain.value, 0.0);
  for (Estimate* one : {&motor.rampInertia_kg_m2, &motor.reversalInertia_kg_m2, &motor.inertia_kg_m2, &motor.coulomb_Nm,
                        &motor.viscous_Nm_s_per_rad}) {
    scale(*one, 1.0 / gain.value, inertia ? 0.0 : Kt);
  }
  if (inertia) motor.inertia_kg_m2 = *inertia;
}

}  // namespace breakaway
