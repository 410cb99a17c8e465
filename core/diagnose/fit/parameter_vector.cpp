#include "diagnose/fit/parameter_vector.h"

#include <algorithm>
#include <cmath>

#include "diagnose/effects/catalogue.h"

namespace breakaway {

namespace {

constexpr double delaySize_s = 1e-3, mostDelay_s = 0.2, mostEarly_s = 0.02;  ///< of a servo's law
constexpr double farthest = 7.0;                                             ///< of the logarithm of a base parameter

bool endsWith(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// How late, in rows, the drive is read beside an effect that moves it.
std::optional<double> lateBesides(const Model& model) {
  for (const EffectTerm& term : model.effects) {
    const InputPart* input = findEffect(term.effect)->input(model.input);
    if (const auto rows = input != nullptr ? input->otherwiseLate_rows() : std::nullopt) return rows;
  }
  return std::nullopt;
}

/// Beside an effect that is a constant load the bias would be the same once more.
bool hasConstantLoad(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(), [](const EffectTerm& term) {
    const auto joint = findEffect(term.effect)->joint(valuesOf(term));
    return joint && joint->constantLoad != 0.0;
  });
}

}  // namespace

double typicalSize(const std::string& name, double torqueSize, double speedSize) {
  if (endsWith(name, "_Nm_s_per_rad") || endsWith(name, "_N_s_per_m")) return torqueSize / speedSize;
  if (endsWith(name, "_Nm") || endsWith(name, "_N")) return torqueSize;
  if (endsWith(name, "_rad_per_s") || endsWith(name, "_m_per_s")) return speedSize;
  return 1.0;
}

bool Freedom::holds(const std::string& name) const {
  return std::find(held.begin(), held.end(), name) != held.end();
}

ParameterVector::ParameterVector(const Model& model, const Freedom& freedom, double torqueSize, double speedSize,
                                 bool last)
    : model_(model) {
  const MotorNames& names = motorNames(model.axis);
  const auto kt = model.baseValue(names.torqueConstant), ke = model.baseValue(names.backEmfConstant);
  if (kt && ke && !freedom.holds(names.torqueConstant) && !freedom.holds(names.backEmfConstant)) emfRatio_ = *ke / *kt;
  const std::string lawsDamping = model.servo ? servoNames(model.input, model.axis).kd : "";
  for (size_t k = 0; k < model_.base.size(); ++k) {
    const Parameter& one = model_.base[k];
    if (freedom.holds(one.name) || (emfRatio_ > 0.0 && one.name == names.backEmfConstant)) continue;
    Slot slot{one.name, 0, k};
    if (one.name == driveLateName) {
      if (const auto rows = lateBesides(model)) {
        const double late_s = *rows * freedom.row_s;
        model_.base[k] = {driveLateName, late_s, late_s, late_s};
        continue;
      }
      slot.scale = freedom.mostLate_s - freedom.leastLate_s;
      slot.lower = freedom.leastLate_s / slot.scale;
      slot.upper = freedom.mostLate_s / slot.scale;
      slot.bounded = true;
    } else if (one.name == biasName(model.axis)) {
      if (hasConstantLoad(model)) {
        model_.base[k] = {one.name, 0.0, 0.0, 0.0};
        continue;
      }
      slot.scale = std::max(freedom.mostBias, 1e-300);
      slot.lower = -1.0;
      slot.upper = 1.0;
    } else if (one.name == servoDelayName) {
      slot.scale = delaySize_s;
      slot.lower = -mostEarly_s / delaySize_s;
      slot.upper = mostDelay_s / delaySize_s;
    } else if (one.name == names.viscous || one.name == names.coulomb || one.name == lawsDamping) {
      slot.scale = std::max(typicalSize(one.name, torqueSize, speedSize), 1e-300);
      slot.lower = 0.0;
    } else if (one.name == "down_angle_rad") {
      slot.scale = 1.0;
    } else {
      slot.logarithmic = true;
      slot.lower = std::log(one.value) - farthest;
      slot.upper = std::log(one.value) + farthest;
      if (one.name == names.inductance) {
        slot.lower = std::max(slot.lower, std::log(freedom.leastInductance_H));
        slot.upper = std::min(slot.upper, std::log(freedom.mostInductance_H));
      }
    }
    slots_.push_back(slot);
  }
  for (size_t e = 0; e < model_.effects.size(); ++e) {
    const Effect* effect = findEffect(model_.effects[e].effect);
    const auto specs = effect->parameters(model_.axis);
    for (size_t k = 0; k < specs.size(); ++k) {
      if (specs[k].held && !(last && specs[k].freeInTheEnd)) continue;
      if (k == 0 && freedom.heldSize == e) continue;
      Slot slot{specs[k].name, e + 1, k};
      const double value = model_.effects[e].parameters[k].value;
      if (specs[k].absentAtZero && value == 0.0) continue;
      if (specs[k].lower > 0.0 && value > 0.0) {
        slot.logarithmic = true;
        slot.bounded = specs[k].freeInTheEnd;
        slot.lower = std::max(std::log(specs[k].lower), std::log(value) - 4.0);
        slot.upper = std::min(std::log(specs[k].upper), std::log(value) + 4.0);
        if (specs[k].amongSpeeds) {
          slot.lower = std::log(0.002 * speedSize);
          slot.upper = std::log(0.5 * speedSize);
        }
      } else {
        slot.scale = value != 0.0 ? std::abs(value) : typicalSize(specs[k].name, torqueSize, speedSize);
        slot.scale = std::max(slot.scale, 1e-300);
        // No torque that an effect adds can exceed the drive's peak: the axis could not have moved against it.
        const bool torque = endsWith(specs[k].name, "_Nm") || endsWith(specs[k].name, "_N");
        const double lower = torque ? std::max(-1.2 * torqueSize, specs[k].lower) : specs[k].lower;
        const double upper = torque ? std::min(1.2 * torqueSize, specs[k].upper) : specs[k].upper;
        slot.lower = lower / slot.scale;
        slot.upper = upper / slot.scale;
        slot.bounded = specs[k].lower == 0.0;
      }
      slots_.push_back(slot);
    }
  }
}

Parameter& ParameterVector::parameter(Model& model, const Slot& slot) {
  return slot.effect == 0 ? model.base[slot.index] : model.effects[slot.effect - 1].parameters[slot.index];
}

std::optional<Eigen::Index> ParameterVector::sizeOf(size_t effect) const {
  const auto slot = std::find_if(slots_.begin(), slots_.end(),
                                 [effect](const Slot& one) { return one.effect == effect + 1 && one.index == 0; });
  if (slot == slots_.end()) return std::nullopt;
  return slot - slots_.begin();
}

Eigen::VectorXd ParameterVector::start() const {
  Eigen::VectorXd x(size());
  Model model = model_;
  for (Eigen::Index k = 0; k < size(); ++k) {
    const Slot& slot = slots_[static_cast<size_t>(k)];
    const double value = parameter(model, slot).value;
    x[k] = std::clamp(slot.logarithmic ? std::log(value) : value / slot.scale, slot.lower, slot.upper);
  }
  return x;
}

Model ParameterVector::at(const Eigen::VectorXd& x) const {
  return withIntervals(x, Eigen::MatrixXd(), 0.0);
}

/// An effect's shape that may only lie between two bounds, such as an exponent, is known at least as well as these
/// tell: as one reading, evenly likely between them, that comes in beside the data. A covariance knows nothing of
/// bounds, and a shape that may be any would leave the size beside it unknown, too, for shapes that there can't be.
Eigen::MatrixXd ParameterVector::withinBounds(Eigen::MatrixXd covariance) const {
  for (Eigen::Index k = 0; k < covariance.rows(); ++k) {
    const Slot& slot = slots_[static_cast<size_t>(k)];
    if (!slot.bounded || slot.effect == 0) continue;
    const double range = slot.upper - slot.lower;
    const Eigen::VectorXd along = covariance.col(k);
    covariance -= along * along.transpose() / (covariance(k, k) + range * range / 12.0);
  }
  return covariance;
}

Model ParameterVector::withIntervals(const Eigen::VectorXd& x, const Eigen::MatrixXd& covarianceOfData,
                                     double errors) const {
  Model model = model_;
  const Eigen::MatrixXd covariance = withinBounds(covarianceOfData);
  const auto place = [](Parameter& one, double value, double low, double high) {
    one.value = value;
    one.low95 = low;
    one.high95 = high;
  };
  for (Eigen::Index k = 0; k < size(); ++k) {
    const Slot& slot = slots_[static_cast<size_t>(k)];
    const double half = covariance.size() > 0 ? errors * std::sqrt(std::max(0.0, covariance(k, k))) : 0.0;
    if (slot.logarithmic) {
      const double low = x[k] - std::min(half, 7.0), high = x[k] + std::min(half, 7.0);
      place(parameter(model, slot), std::exp(x[k]), std::exp(slot.bounded ? std::max(low, slot.lower) : low),
            std::exp(slot.bounded ? std::min(high, slot.upper) : high));
    } else {
      const double low = slot.bounded ? std::max(x[k] - half, slot.lower) : x[k] - half;
      const double high = slot.bounded ? std::min(x[k] + half, slot.upper) : x[k] + half;
      place(parameter(model, slot), x[k] * slot.scale, low * slot.scale, high * slot.scale);
    }
  }
  if (emfRatio_ > 0.0) {
    const MotorNames& names = motorNames(model.axis);
    const auto find = [&model](const char* name) {
      return std::find_if(model.base.begin(), model.base.end(),
                          [name](const Parameter& one) { return one.name == name; });
    };
    const auto kt = find(names.torqueConstant), ke = find(names.backEmfConstant);
    place(*ke, kt->value * emfRatio_, kt->low95 * emfRatio_, kt->high95 * emfRatio_);
  }
  return model;
}

}  // namespace breakaway
