#include "plant/physics.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

double sumOf(const std::vector<Harmonic>& harmonics, double angle_rad) {
  double sum = 0.0;
  for (const Harmonic& one : harmonics) sum += one.at(angle_rad);
  return sum;
}

void addTo(std::array<FrictionCurve, 2>& curves, double difference) {
  curves[0].added -= 0.5 * difference;
  curves[1].added += 0.5 * difference;
}

void modulate(std::array<FrictionCurve, 2>& curves, const Harmonic& wave) {
  for (FrictionCurve& curve : curves) curve.factors.push_back(wave);
}

}  // namespace

double Harmonic::at(double angle_rad) const {
  return amplitude * std::cos(order * angle_rad - phase_rad);
}

double FrictionCurve::at(double angle_rad) const {
  double value = mean * (1.0 + sumOf(harmonics, angle_rad)) + added;
  for (const Harmonic& one : factors) value *= 1.0 + one.at(angle_rad);
  return value;
}

AngleTorques torquesAt(const PlantPhysics& physics, double angle_rad) {
  AngleTorques torques;
  for (size_t way = 0; way < 2; ++way) {
    const double fresh = std::max(0.0, physics.holding[way].at(angle_rad));
    torques.static_Nm[way] = fresh * (1.0 + physics.rest.share) + physics.rest.excess;
    torques.coulomb_Nm[way] = std::max(0.0, physics.coulomb[way].at(angle_rad));
    torques.viscous_Nm_s_per_rad[way] = std::max(0.0, physics.viscous[way].at(angle_rad));
  }
  torques.position_Nm = sumOf(physics.position, angle_rad) + physics.load;
  torques.ripple = 1.0 + sumOf(physics.ripple, angle_rad);
  return torques;
}

int highestOrder(const PlantPhysics& physics) {
  double order = 1.0;
  const auto take = [&order](const std::vector<Harmonic>& harmonics) {
    for (const Harmonic& one : harmonics) order = std::max(order, std::abs(one.order));
  };
  for (const auto* curves : {&physics.holding, &physics.coulomb, &physics.viscous}) {
    for (const FrictionCurve& curve : *curves) take(curve.harmonics), take(curve.factors);
  }
  take(physics.position);
  take(physics.ripple);
  return static_cast<int>(std::ceil(order));
}

void addCoulombAsymmetry(PlantPhysics& physics, double difference) {
  addTo(physics.coulomb, difference);
  addTo(physics.holding, difference);
}

void addViscousAsymmetry(PlantPhysics& physics, double difference) {
  addTo(physics.viscous, difference);
}

void addStribeckExcess(PlantPhysics& physics, double excess) {
  for (FrictionCurve& curve : physics.holding) curve.added += excess;
}

void addFrictionOverAngle(PlantPhysics& physics, const Harmonic& wave) {
  modulate(physics.coulomb, wave);
  modulate(physics.holding, wave);
}

void addViscousOverAngle(PlantPhysics& physics, const Harmonic& wave) {
  modulate(physics.viscous, wave);
}

}  // namespace breakaway
