#include "identify/encoder_disc.h"

#include <cmath>

#include "base/numbers.h"
#include "identify/encoder_swing.h"
#include "identify/inertia_share.h"
#include "identify/velocity_friction.h"
#include "identify/way_runs.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr int rounds = 8;  // each leaves about D of the error
constexpr double mostOff_rad = 0.3;
constexpr double leastSettled = 0.02;  // of D, that the last round may still add
constexpr double settledEnough = 1e-4;
constexpr double mostLeft = 0.5;  // of a round's step, that the next one may still take

}  // namespace

double EncoderDisc::angleOf(double shown_rad) const {
  double angle = shown_rad;
  for (int k = 0; k < 8; ++k) angle = shown_rad + off_rad.real() - (off_rad * std::polar(1.0, angle)).real();
  return angle;
}

double EncoderDisc::gainAt(double angle_rad) const {
  return 1.0 / (1.0 - (off_rad * std::polar(1.0, angle_rad)).imag());
}

/// Shown over ± x around θ: 2x − 2·sin x·Im(D·e^{jθ}).
double EncoderDisc::speedOf(double shown_rad_per_s, double angle_rad, double halfSpan_s) const {
  if (!(halfSpan_s > 0.0)) return shown_rad_per_s * gainAt(angle_rad);
  const double shown_rad = shown_rad_per_s * halfSpan_s, swing = (off_rad * std::polar(1.0, angle_rad)).imag();
  double half_rad = shown_rad;
  for (int k = 0; k < 8; ++k) half_rad = shown_rad + swing * std::sin(half_rad);
  return half_rad / halfSpan_s;
}

EncoderDisc fitDisc(const std::vector<VelocityRun>& runs, const VelocityFrictionOptions& given) {
  VelocityFrictionOptions options = given;
  options.disc = {};
  if (!(options.inertia_kg_m2 > 0.0)) return {};
  double first_rad = 0.0, before_rad = 0.0;
  for (int round = 0; round < rounds; ++round) {
    auto ways = wayRunsOf(runs, options);
    if (!ways) return {};
    for (WayRuns& way : *ways) leaveOutStribeck(way);
    widenBySwing(*ways, options.inertia_kg_m2, options.disc);
    freeOfInertia(*ways, options.inertia_kg_m2, options.inertiaError_kg_m2);
    const auto swing = swingOf(*ways);
    if (!swing || (round == 0 && !swing->clear())) return {};
    const Complex further = swing->wave / options.inertia_kg_m2;
    if (round == 0) first_rad = std::abs(further);
    // A disc that is one is left with the less of a wave, the nearer it is to the truth.
    if (round > 0 && std::abs(further) > mostLeft * before_rad) return {{}, 0.0, first_rad};
    before_rad = std::abs(further);
    options.disc.off_rad += further;
    options.disc.variance_rad2 = swing->variance / (options.inertia_kg_m2 * options.inertia_kg_m2);
    const bool settled = std::abs(further) < leastSettled * std::abs(options.disc.off_rad);
    if (std::abs(options.disc.off_rad) > mostOff_rad || (round + 1 == rounds && !settled))
      return {{}, 0.0, std::abs(options.disc.off_rad)};
    if (std::abs(further) < settledEnough * std::abs(options.disc.off_rad)) break;
  }
  // As clear in the end as it was at first sight.
  if (!EncoderSwing{options.disc.off_rad, options.disc.variance_rad2, {}}.clear()) return {{}, 0.0, first_rad};
  return options.disc;
}

void placeBy(const EncoderDisc& disc, std::span<BreakawayEvent> events) {
  if (!disc.known()) return;
  for (BreakawayEvent& event : events) {
    const double angle = disc.angleOf(event.angle_rad);
    event.angle_rad = angle - turn_rad * std::floor(angle / turn_rad);
  }
}

}  // namespace breakaway
