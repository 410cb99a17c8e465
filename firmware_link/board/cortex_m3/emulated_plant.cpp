#include "firmware_link/board/cortex_m3/emulated_plant.h"

#include "base/numbers.h"
#include "firmware_link/board/cortex_m3/gaussian_table.h"

namespace breakaway {

namespace {

constexpr int fractionBits = 36;
constexpr std::int64_t turn_q36 = std::int64_t{1} << fractionBits;
constexpr float perRad_q36 = static_cast<float>(static_cast<double>(turn_q36) / turn_rad);
constexpr auto sameStand_q36 = static_cast<std::int64_t>(1e-4f * perRad_q36);
constexpr int mostEvents = 8;

/// A substep's way; fits 31 bits up to 3900 rad/s, and converting to 64 bits would go through double precision.
std::int64_t way_q36(float way_rad) {
  return static_cast<std::int32_t>(way_rad * perRad_q36);
}

/// 1 − e^−x for 0 ≤ x ≤ 0.1 within 1e-7.
float fallen(float x) {
  return x * (1.0f - x * (0.5f - x * (1.0f / 6.0f - x * (1.0f / 24.0f))));
}

}  // namespace

EmulatedPlant::EmulatedPlant(const EmulatedRig& rig, std::uint32_t seed)
    : rig_(rig),
      inverseInductance_(1.0f / rig.inductance_H),
      inverseResistance_(1.0f / rig.resistance_ohm),
      inverseInertia_(1.0f / rig.inertia_kg_m2),
      inverseTorqueConstant_(1.0f / rig.torqueConstant_Nm_per_A),
      inverseStribeck_(1.0f / rig.stribeckVelocity_rad_per_s),
      rate_per_s_(rig.resistance_ohm / rig.inductance_H),
      noise_(seed),
      angle_q36_(rig.start_q36),
      rest_q36_(rig.start_q36 - turn_q36) {
  comeToRest();
}

EmulatedPlant::Local EmulatedPlant::localAt(std::int64_t angle_q36, int way) const {
  const auto fraction = static_cast<std::uint32_t>((angle_q36 & (turn_q36 - 1)) >> (fractionBits - 32));
  const int shift = 32 - rig_.cellBits;
  const float part = static_cast<float>(fraction & ((1u << shift) - 1u)) / static_cast<float>(1u << shift);
  const EmulatedCell *a = rig_.cells + (fraction >> shift), *b = a + 1;
  const auto mix = [part](float low, float high) { return low + part * (high - low); };
  return {mix(a->static_Nm[way], b->static_Nm[way]), mix(a->coulomb_Nm[way], b->coulomb_Nm[way]),
          mix(a->viscous_Nm_s_per_rad[way], b->viscous_Nm_s_per_rad[way]), mix(a->position_Nm, b->position_Nm)};
}

void EmulatedPlant::comeToRest() {
  velocity_ = acceleration_ = 0.0f;
  moving_ = false;
  // Asperities that have hardly moved hold as before: a slip that short is the same standstill.
  const std::int64_t moved = angle_q36_ - rest_q36_;
  if (moved < sameStand_q36 && moved > -sameStand_q36) return;
  rest_q36_ = angle_q36_;
  for (float& factor : scatter_) {
    factor = 1.0f + rig_.scatterRms * noise_.normal();
    if (factor < 0.0f) factor = 0.0f;
  }
}

/// The current is an exponential; where it passes the breakaway level is taken from its slope at the step's middle.
float EmulatedPlant::stand(float duration_s) {
  const float start = current_A();
  const float change = open_ ? -start : (target_A_ - start) * fallen(rate_per_s_ * duration_s);
  const float end = start + change;
  const Local here[2] = {localAt(angle_q36_, 0), localAt(angle_q36_, 1)};
  const float free = here[1].position_Nm;
  for (int way = 0; way < 2; ++way) {
    const float limit = here[way].static_Nm * scatter_[way];
    if (signOfWay<float>(way) * (rig_.torqueConstant_Nm_per_A * end + free) <= limit) continue;
    const float level = (signOfWay<float>(way) * limit - free) * inverseTorqueConstant_;  // current at which it lets go
    float part = 0.0f;
    if (signOfWay<float>(way) * (level - start) > 0.0f && change != 0.0f) part = (level - start) / change;
    if (part > 1.0f) part = 1.0f;
    current_ = start + part * change;
    moving_ = true;
    way_ = way;
    return part * duration_s;
  }
  current_ = end;
  return duration_s;
}

/// A stretch shorter than a substep: the exponential's series, whose argument is below a tenth.
EmulatedMotion EmulatedPlant::motionOver(float t) const {
  if (t == rig_.substep_s) return open_ ? rig_.opened[way_] : rig_.closed[way_];
  const float a = open_ ? 0.0f : -rate_per_s_,
              b = open_ ? 0.0f : -rig_.backEmfConstant_V_s_per_rad * inverseInductance_;
  const float c = open_ ? 0.0f : rig_.torqueConstant_Nm_per_A * inverseInertia_;
  const float A[2][2] = {{a * t, b * t}, {c * t, -rig_.viscousMean_Nm_s_per_rad[way_] * inverseInertia_ * t}};
  EmulatedMotion motion{};
  float term[2][2] = {{1.0f, 0.0f}, {0.0f, 1.0f}};  // (At)^k/k!
  float inverse = 1.0f;
  for (int k = 1; k <= 5; ++k) {
    inverse = 1.0f / static_cast<float>(k);
    float next[2][2];
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        motion.gamma[i][j] += term[i][j] * inverse * t;
        next[i][j] = (term[i][0] * A[0][j] + term[i][1] * A[1][j]) * inverse;
        motion.change[i][j] += next[i][j];
      }
    }
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) term[i][j] = next[i][j];
    }
  }
  return motion;
}

float EmulatedPlant::slide(float duration_s) {
  const float sign = signOfWay<float>(way_), half = 0.5f * duration_s;
  float middle = velocity_ + half * acceleration_;  // mid-step speed, for what changes slowly
  if (middle * sign < 0.0f) middle = 0.0f;
  const Local here = localAt(angle_q36_ + way_q36(half * velocity_), way_);
  const float excess =
      (here.static_Nm * scatter_[way_] - here.coulomb_Nm) * gaussianFall(middle * sign * inverseStribeck_);
  float torque = here.position_Nm - sign * (here.coulomb_Nm + excess);
  torque -= (here.viscous - rig_.viscousMean_Nm_s_per_rad[way_]) * middle;
  const float drive = open_ ? 0.0f : perInductance_, push = torque * inverseInertia_;
  const float i0 = current_A(), w0 = velocity_;
  const auto speedChange = [&](const EmulatedMotion& m) {
    return m.change[1][0] * i0 + m.change[1][1] * w0 + m.gamma[1][0] * drive + m.gamma[1][1] * push;
  };
  float used = duration_s;
  EmulatedMotion motion = motionOver(used);
  float w1 = w0 + speedChange(motion);
  const bool rests = w1 * sign <= 0.0f;
  if (rests && w0 * sign > 0.0f) {
    used = duration_s * w0 / (w0 - w1);
    motion = motionOver(used);
    w1 = 0.0f;
  }
  current_ =
      i0 + motion.change[0][0] * i0 + motion.change[0][1] * w0 + motion.gamma[0][0] * drive + motion.gamma[0][1] * push;
  angle_q36_ += way_q36(0.5f * (w0 + (rests ? 0.0f : w1)) * used);
  if (!rests) {
    acceleration_ = (w1 - w0) / used;
    velocity_ = w1;
    return used;
  }
  if (w0 == 0.0f) {  // let go and held again at once: the same standstill goes on
    velocity_ = acceleration_ = 0.0f;
    moving_ = false;
    return used;
  }
  comeToRest();
  return used;
}

void EmulatedPlant::advance() {
  for (int k = 0; k < rig_.substeps; ++k) {
    float left = rig_.substep_s;
    // Rest and breakaway can follow each other within a step; what eight events leave over is less than a step.
    for (int events = 0; events < mostEvents && left > 0.0f; ++events) left -= moving_ ? slide(left) : stand(left);
  }
}

}  // namespace breakaway
