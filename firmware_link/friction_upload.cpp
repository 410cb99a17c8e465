#include "firmware_link/friction_upload.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/numbers.h"

namespace breakaway {

namespace {

using Curve = std::vector<float>;

/// In the wire's order; without static friction the last two are missing.
Result<std::vector<Curve>> curvesOf(const FrictionCompensation& friction, std::size_t mostBins, bool withStatic) {
  const std::string place = "friction compensation";
  const std::size_t bins = friction.coulomb_Nm[0].size();
  if (friction.span_rad != 0.0) return Error{place, message("is of a linear axis, the board knows rotors only")};
  if (bins > mostBins) {
    return Error{place, message("has {} bins, the board holds at most {}", bins, mostBins)};
  }
  bool finite = std::isfinite(friction.indexAngle_rad + friction.blend_rad_per_s + friction.cutoff_rad_per_s) &&
                friction.blend_rad_per_s >= 0.0 && friction.cutoff_rad_per_s >= 0.0 &&
                std::isfinite(friction.stribeck_rad_per_s) && friction.stribeck_rad_per_s >= 0.0;
  std::vector<const std::vector<double>*> sources{&friction.coulomb_Nm[0], &friction.coulomb_Nm[1],
                                                  &friction.viscous_Nm_s_per_rad[0], &friction.viscous_Nm_s_per_rad[1]};
  if (withStatic) sources.insert(sources.end(), {&friction.static_Nm[0], &friction.static_Nm[1]});
  std::vector<Curve> curves;
  for (const auto* values : sources) {
    if (values->size() != bins) return Error{place, message("has not as many bins each way")};
    Curve& curve = curves.emplace_back();
    for (const double value : *values) {
      curve.push_back(static_cast<float>(value));
      finite = finite && std::isfinite(curve.back());
    }
  }
  if (!finite) return Error{place, message("holds a value that is negative or not finite")};
  return curves;
}

wire::FrictionChunk chunkOf(const Curve& curve, std::size_t which, std::size_t first) {
  wire::FrictionChunk chunk;
  chunk.curve = static_cast<wire::FrictionCurve>(which);
  chunk.first = static_cast<std::uint16_t>(first);
  chunk.count = static_cast<std::uint8_t>(std::min(wire::FrictionChunk::mostValues, curve.size() - first));
  std::copy_n(curve.begin() + static_cast<std::ptrdiff_t>(first), chunk.count, chunk.value);
  return chunk;
}

void addTo(wire::Crc32c& sum, float value) {
  std::array<std::uint8_t, 4> bytes;
  wire::Writer out{bytes};
  out(value);
  sum.add(bytes);
}

Result<void> upload(BoardLink& link, const Curve& curve, std::size_t which) {
  for (std::size_t first = 0; first < curve.size(); first += wire::FrictionChunk::mostValues) {
    const wire::FrictionChunk chunk = chunkOf(curve, which, first);
    if (auto written = link.ask<wire::FrictionChunk>(wire::Type::writeFriction, chunk); !written)
      return written.error();
    const auto back = link.ask<wire::FrictionChunk>(wire::Type::readFriction, chunk);
    if (!back) return back.error();
    if (!std::equal(chunk.value, chunk.value + chunk.count, back->value))
      return Error{link.place(), message("holds another friction table than was written")};
  }
  return {};
}

}  // namespace

Result<void> uploadFriction(BoardLink& link, const FrictionCompensation& friction, const FrictionRoom& room) {
  const bool withStatic = room.holdsStatic && !(friction.static_Nm[0].empty() && friction.static_Nm[1].empty());
  const auto curves = curvesOf(friction, room.mostBins, withStatic);
  if (!curves) return curves.error();
  wire::Crc32c sum;
  for (std::size_t k = 0; k < curves->size(); ++k) {
    if (auto written = upload(link, (*curves)[k], k); !written) return written;
    for (const float value : (*curves)[k]) addTo(sum, value);
  }
  wire::FrictionUse use;
  use.bins = static_cast<std::uint16_t>((*curves)[0].size());
  use.checksum = sum.value();
  use.index_rad =
      static_cast<float>(friction.indexAngle_rad - turn_rad * std::floor(friction.indexAngle_rad / turn_rad));
  use.blend_rad_per_s = static_cast<float>(friction.blend_rad_per_s);
  use.cutoff_rad_per_s = static_cast<float>(friction.cutoff_rad_per_s);
  if (!withStatic) {
    const auto used = link.ask<wire::FrictionUse>(wire::Type::useFriction, use);
    return used ? Result<void>{} : used.error();
  }
  const wire::StaticFrictionUse whole{use, static_cast<float>(friction.stribeck_rad_per_s)};
  const auto used = link.ask<wire::StaticFrictionUse>(wire::Type::useStatic, whole);
  return used ? Result<void>{} : used.error();
}

namespace {

/// Appends the board's curve to `values` and to the sum.
Result<void> download(BoardLink& link, std::size_t which, std::size_t bins, std::vector<double>& values,
                      wire::Crc32c& sum) {
  while (values.size() < bins) {
    wire::FrictionChunk wanted;
    wanted.curve = static_cast<wire::FrictionCurve>(which);
    wanted.first = static_cast<std::uint16_t>(values.size());
    wanted.count = static_cast<std::uint8_t>(std::min(wire::FrictionChunk::mostValues, bins - values.size()));
    const auto chunk = link.ask<wire::FrictionChunk>(wire::Type::readFriction, wanted);
    if (!chunk) return chunk.error();
    if (chunk->count != wanted.count)
      return Error{link.place(), message("answered with another part of the friction table")};
    for (std::size_t n = 0; n < chunk->count; ++n) {
      addTo(sum, chunk->value[n]);
      values.push_back(static_cast<double>(chunk->value[n]));
    }
  }
  return {};
}

}  // namespace

Result<FrictionCompensation> downloadFriction(BoardLink& link, bool holdsStatic) {
  auto use = link.ask<wire::FrictionUse>(wire::Type::frictionUsed);
  if (!use) return use.error();
  FrictionCompensation friction;
  if (holdsStatic) {
    const auto whole = link.ask<wire::StaticFrictionUse>(wire::Type::staticUsed);
    if (!whole) return whole.error();
    friction.stribeck_rad_per_s = static_cast<double>(whole->stribeck_rad_per_s);
    if (whole->stribeck_rad_per_s > 0.0f) use = whole->table;
  }
  friction.indexAngle_rad = static_cast<double>(use->index_rad);
  friction.blend_rad_per_s = static_cast<double>(use->blend_rad_per_s);
  friction.cutoff_rad_per_s = static_cast<double>(use->cutoff_rad_per_s);
  if (use->bins == 0) return friction;
  std::vector<std::vector<double>*> places{&friction.coulomb_Nm[0], &friction.coulomb_Nm[1],
                                           &friction.viscous_Nm_s_per_rad[0], &friction.viscous_Nm_s_per_rad[1]};
  if (friction.stribeck_rad_per_s > 0.0) places.insert(places.end(), {&friction.static_Nm[0], &friction.static_Nm[1]});
  wire::Crc32c sum;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (auto read = download(link, k, use->bins, *places[k], sum); !read) return read.error();
  }
  if (sum.value() != use->checksum)
    return Error{link.place(),
                 message("is being given another friction table; the one in use can't be read meanwhile")};
  return friction;
}

}  // namespace breakaway
