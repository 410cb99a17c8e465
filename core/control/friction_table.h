// Friction around the rotor as a controller knows it. Freestanding; the board runs it too.
#pragma once

#include <cstdint>

#include "control/magnitude.h"
#include "control/turn.h"

namespace breakaway {

/// Whole motor torques per way and angle bin, linear in between. One bin is an average. Positive in the way's
/// direction, index 0 falling angle (cw), 1 growing angle (ccw).
template <typename Scalar>
struct FrictionTable {
  static constexpr int mostBins = 256;

  int bins = 0;                         ///< 0: no friction is known
  Scalar index_rad = 0;                 ///< angle of the index as the encoder counts it
  Scalar perRad = turnsPerRad<Scalar>;  ///< one over what the bins cover from there: a turn, or a travel
  Scalar blend_rad_per_s =
      0;  ///< up to this speed the Coulomb torque grows in proportion, so that noise can't shake it
  Scalar stribeck_rad_per_s = 0;  ///< speed over which friction falls from static to Coulomb; 0: static isn't known
  Scalar coulomb_Nm[2][mostBins] = {};
  Scalar viscous_Nm_s_per_rad[2][mostBins] = {};
  Scalar static_Nm[2][mostBins] = {};  ///< that starts motion from standstill
};

/// What the motor must give to take friction and position torque off the shaft, in Nm towards growing angle:
/// ½(C_ccw − C_cw) + s·½(C_ccw + C_cw) + B·ω, s the way within ±1. What a tick would divide or subtract of the table is
/// computed when the table comes.
template <typename Scalar>
class FrictionFeedForward {
 public:
  void take(const FrictionTable<Scalar>& table) {
    begin(table);
    prepare(FrictionTable<Scalar>::mostBins);
  }

  /// The same in parts, for a board that has ticks to keep: no friction is known until prepare() has gone through all
  /// bins. The table stays as it is meanwhile.
  void begin(const FrictionTable<Scalar>& table) {
    bins_ = 0;
    coming_ = table.bins > 0 ? &table : nullptr;
    prepared_ = 0;
    blend_rad_per_s_ = table.blend_rad_per_s;
    perBlend_ = table.blend_rad_per_s > Scalar(0) ? Scalar(1) / table.blend_rad_per_s : Scalar(0);
    fallen_rad_per_s_ = Scalar(2) * table.stribeck_rad_per_s;
    perFall_ = table.stribeck_rad_per_s > Scalar(0) ? Scalar(0.5) / table.stribeck_rad_per_s : Scalar(0);
  }
  bool prepares() const { return coming_ != nullptr; }
  void prepare(int mostBins) {
    if (coming_ == nullptr) return;
    const int bins = coming_->bins, end = bins - prepared_ < mostBins ? bins : prepared_ + mostBins;
    for (; prepared_ < end; ++prepared_) prepareBin(*coming_, prepared_);
    if (prepared_ < bins) return;
    for (auto& curve : nodes_) slope(curve, bins - 1, 0);
    bins_ = static_cast<std::uint32_t>(bins);
    perRad_ = coming_->perRad;
    start_ = turnOf(coming_->index_rad, perRad_) + 0x80000000u / bins_;
    coming_ = nullptr;
  }

  bool known() const { return bins_ > 0; }
  Scalar blend_rad_per_s() const { return blend_rad_per_s_; }

  /// Where the rotor stands in the table.
  struct Place {
    std::uint32_t bin;
    Scalar part;  ///< of the way to the next bin, 0 to 2^24
  };
  /// An angle as a part of what the bins cover.
  Turn turnAt(Scalar angle_rad) const { return turnOf(angle_rad, perRad_); }
  Place placeOf(Turn turn) const {
    const std::uint64_t place = std::uint64_t(turn - start_) * bins_;
    return {static_cast<std::uint32_t>(place >> 32),
            static_cast<Scalar>(static_cast<std::int32_t>(static_cast<std::uint32_t>(place) >> 8))};
  }

  /// `intent`, within ±1, is the way that the rotor is to go: while it stands that decides instead of its speed, and as
  /// far as it does, friction is the static one on the rotor's way from standstill: C + (S − C)·|intent|·fallen(ω).
  /// Without intent nothing is pushed from rest.
  Scalar torque_Nm(const Place& place, Scalar velocity_rad_per_s, Scalar intent = Scalar(0)) const {
    if (bins_ == 0) return Scalar(0);
    Scalar way = wayOf(velocity_rad_per_s);
    if (!isZero(intent)) way += (Scalar(1) - magnitude(way)) * intent;
    return dryTorque_Nm(place, way, risingPart(velocity_rad_per_s, intent)) +
           viscous(place, velocity_rad_per_s) * velocity_rad_per_s;
  }

  /// The same for a rotor that is to turn at the target and has come to `velocity_rad_per_s` so far: friction of the
  /// target's speed, whatever the measured speed's noise, but static as long as the rotor is slow.
  Scalar movingTorque_Nm(const Place& place, Scalar target_rad_per_s, Scalar velocity_rad_per_s) const {
    if (bins_ == 0) return Scalar(0);
    const Scalar way = wayOf(target_rad_per_s);
    return dryTorque_Nm(place, way, risingPart(velocity_rad_per_s, way)) +
           viscous(place, target_rad_per_s) * target_rad_per_s;
  }

  /// Coulomb friction, the mean of both ways.
  Scalar friction_Nm(const Place& place) const { return at(nodes_[coulombTorque], place); }

 private:
  enum Curve { positionTorque, coulombTorque, positionRise, coulombRise, viscousCw, viscousCcw, curves };
  struct Node {
    Scalar value = 0, slope = 0;
  };
  static constexpr Scalar perPart = Scalar(1) / Scalar(1 << 24);

  void prepareBin(const FrictionTable<Scalar>& table, int k) {
    const auto half = [k](const Scalar(&ways)[2][FrictionTable<Scalar>::mostBins], Scalar sign) {
      return Scalar(0.5) * (ways[1][k] + sign * ways[0][k]);
    };
    const Scalar position = half(table.coulomb_Nm, Scalar(-1)), coulomb = half(table.coulomb_Nm, Scalar(1));
    nodes_[positionTorque][k].value = position;
    nodes_[coulombTorque][k].value = coulomb;
    nodes_[positionRise][k].value = half(table.static_Nm, Scalar(-1)) - position;
    nodes_[coulombRise][k].value = half(table.static_Nm, Scalar(1)) - coulomb;
    nodes_[viscousCw][k].value = table.viscous_Nm_s_per_rad[0][k];
    nodes_[viscousCcw][k].value = table.viscous_Nm_s_per_rad[1][k];
    if (k == 0) return;
    for (auto& curve : nodes_) slope(curve, k - 1, k);
  }
  static void slope(Node* curve, int from, int to) {
    curve[from].slope = (curve[to].value - curve[from].value) * perPart;
  }

  /// How much of the step from Coulomb to static friction is there: exp(−x²), x the speed over the Stribeck speed, as
  /// (1 − x²/4)⁴, which no board needs a library for; it ends at x = 2 and errs by 0.08 at most. None while the rotor
  /// still turns the other way.
  Scalar risingPart(Scalar velocity_rad_per_s, Scalar intent) const {
    if (isZero(perFall_) || isZero(intent)) return Scalar(0);
    const bool against = isNegative(velocity_rad_per_s) != isNegative(intent);
    if (exceeds(velocity_rad_per_s, against ? blend_rad_per_s_ : fallen_rad_per_s_)) return Scalar(0);
    const Scalar x = velocity_rad_per_s * perFall_, y = Scalar(1) - x * x, square = y * y;
    return isPositive(y) ? magnitude(intent) * (square * square) : Scalar(0);
  }

  Scalar dryTorque_Nm(const Place& place, Scalar way, Scalar rising) const {
    Scalar position = at(nodes_[positionTorque], place), coulomb = at(nodes_[coulombTorque], place);
    if (!isZero(rising)) {
      position += rising * at(nodes_[positionRise], place);
      coulomb += rising * at(nodes_[coulombRise], place);
    }
    return position + way * coulomb;
  }

  Scalar viscous(const Place& place, Scalar velocity_rad_per_s) const {
    return at(nodes_[isNegative(velocity_rad_per_s) ? viscousCw : viscousCcw], place);
  }

  Scalar wayOf(Scalar velocity_rad_per_s) const {
    if (exceeds(blend_rad_per_s_, velocity_rad_per_s)) return velocity_rad_per_s * perBlend_;
    return isZero(velocity_rad_per_s) ? Scalar(0) : isNegative(velocity_rad_per_s) ? Scalar(-1) : Scalar(1);
  }

  static Scalar at(const Node* curve, const Place& place) {
    const Node& node = curve[place.bin];
    return node.value + place.part * node.slope;
  }

  const FrictionTable<Scalar>* coming_ = nullptr;
  int prepared_ = 0;  ///< bins of it
  std::uint32_t bins_ = 0;
  Turn start_ = 0;  ///< the first bin's middle
  Scalar perRad_ = turnsPerRad<Scalar>;
  Scalar blend_rad_per_s_ = 0, perBlend_ = 0, fallen_rad_per_s_ = 0, perFall_ = 0;
  Node nodes_[curves][FrictionTable<Scalar>::mostBins] = {};
};

}  // namespace breakaway
