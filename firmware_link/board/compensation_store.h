// What the host wrote of friction and bridge, checked before it takes effect, and given back. Freestanding, no heap.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "control/duty_table.h"
#include "control/friction_table.h"
#include "firmware_link/wire/crc32c.h"
#include "firmware_link/wire/messages.h"

namespace breakaway::board {

/// A friction table is written in parts and isn't used until its checksum fits; a bridge's curve comes as a whole.
template <typename Scalar>
class CompensationStore {
 public:
  using Table = FrictionTable<Scalar>;

  wire::Code write(const wire::FrictionChunk& chunk) {
    Scalar* values = part(chunk);
    if (values == nullptr) return wire::Code::noSuch;
    for (std::size_t k = 0; k < chunk.count; ++k) {
      if (!finite(chunk.value[k])) return wire::Code::notAValue;
    }
    for (std::size_t k = 0; k < chunk.count; ++k) values[k] = static_cast<Scalar>(chunk.value[k]);
    return wire::Code::ok;
  }

  wire::Code read(wire::FrictionChunk& chunk) {
    const Scalar* values = part(chunk);
    if (values == nullptr) return wire::Code::noSuch;
    for (std::size_t k = 0; k < chunk.count; ++k) chunk.value[k] = static_cast<float>(values[k]);
    return wire::Code::ok;
  }

  /// Without static friction.
  wire::Code use(const wire::FrictionUse& wanted) {
    if (const wire::Code code = judge(wanted); code != wire::Code::ok) return code;
    if (sums(wanted.bins, wire::movingCurves).moving != wanted.checksum) return wire::Code::notAValue;
    take({wanted, 0.0f}, wanted.checksum);
    return wire::Code::ok;
  }
  wire::Code use(const wire::StaticFrictionUse& wanted) {
    if (!finite(wanted.stribeck_rad_per_s) || wanted.stribeck_rad_per_s < 0.0f) return wire::Code::notAValue;
    if (const wire::Code code = judge(wanted.table); code != wire::Code::ok) return code;
    const Sums here = sums(wanted.table.bins, wire::frictionCurves);
    if (here.all != wanted.table.checksum) return wire::Code::notAValue;
    take(wanted, here.moving);
    return wire::Code::ok;
  }

  wire::Code use(const wire::BridgeCurve& wanted) {
    DutyTable<Scalar> table;
    for (std::size_t k = 0; k < wanted.count; ++k) {
      const auto [input, output] = wanted.point[k];
      const bool rises = k == 0 ? input >= 0.0f && output == 0.0f
                                : input > wanted.point[k - 1].input && output > wanted.point[k - 1].output;
      if (!rises || !finite(input) || !finite(output)) return wire::Code::notAValue;
      table.input[k] = static_cast<Scalar>(input);
      table.output[k] = static_cast<Scalar>(output);
    }
    table.points = wanted.count;
    bridge_ = table;
    bridgeUsed_ = wanted;
    return wire::Code::ok;
  }

  const Table& friction() const { return written_; }
  const DutyTable<Scalar>& bridge() const { return bridge_; }
  const wire::FrictionUse& used() const { return used_; }
  const wire::StaticFrictionUse& staticUsed() const { return staticUsed_; }
  const wire::BridgeCurve& bridgeUsed() const { return bridgeUsed_; }

 private:
  static_assert(wire::BridgeCurve::mostPoints == DutyTable<Scalar>::mostPoints);
  static bool finite(float value) { return value - value == 0.0f; }

  Scalar* curve(std::size_t which) {
    if (which >= wire::frictionCurves) return nullptr;
    if (which >= 4) return written_.static_Nm[which - 4];
    return which < 2 ? written_.coulomb_Nm[which] : written_.viscous_Nm_s_per_rad[which - 2];
  }
  /// Where the chunk's values stand; null: there is no such place.
  Scalar* part(const wire::FrictionChunk& chunk) {
    Scalar* values = curve(static_cast<std::size_t>(chunk.curve));
    if (values == nullptr || std::size_t(chunk.first) + chunk.count > Table::mostBins) return nullptr;
    return values + chunk.first;
  }

  static wire::Code judge(const wire::FrictionUse& use) {
    if (use.bins > Table::mostBins) return wire::Code::noSuch;
    const bool fine = finite(use.index_rad) && finite(use.blend_rad_per_s) && finite(use.cutoff_rad_per_s) &&
                      use.blend_rad_per_s >= 0.0f && use.cutoff_rad_per_s >= 0.0f;
    return fine ? wire::Code::ok : wire::Code::notAValue;
  }

  void take(const wire::StaticFrictionUse& use, std::uint32_t movingSum) {
    written_.bins = use.table.bins;
    written_.index_rad = static_cast<Scalar>(use.table.index_rad);
    written_.blend_rad_per_s = static_cast<Scalar>(use.table.blend_rad_per_s);
    written_.stribeck_rad_per_s = static_cast<Scalar>(use.stribeck_rad_per_s);
    staticUsed_ = use;
    used_ = use.table;
    used_.checksum = movingSum;
  }

  struct Sums {
    std::uint32_t moving, all;  ///< over the curves of a rotor that turns, and over all that were asked for
  };
  Sums sums(std::size_t bins, std::size_t curves) {
    wire::Crc32c crc;
    Sums here{};
    for (std::size_t k = 0; k < curves; ++k) {
      const Scalar* values = curve(k);
      for (std::size_t bin = 0; bin < bins; ++bin) {
        const auto word = std::bit_cast<std::uint32_t>(static_cast<float>(values[bin]));
        for (unsigned shift = 0; shift < 32; shift += 8) crc.add(static_cast<std::uint8_t>(word >> shift));
      }
      if (k + 1 == wire::movingCurves) here.moving = crc.value();
    }
    here.all = crc.value();
    return here;
  }

  Table written_;
  wire::FrictionUse used_;
  wire::StaticFrictionUse staticUsed_;
  wire::BridgeCurve bridgeUsed_;
  DutyTable<Scalar> bridge_;
};

}  // namespace breakaway::board
