// What the motion was to follow: its unit, and whether it was followed at all.
#include <algorithm>
#include <array>
#include <cmath>

#include "recording/import/drive_evidence.h"
#include "recording/import/name_parts.h"
#include "recording/import/names_beside.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settling.h"

namespace breakaway {

namespace {

bool namesOnlyReference(const Words& words) {
  return firstIn(words, referenceWords) != nullptr && std::all_of(words.begin(), words.end(), [](const auto& word) {
           return isIn(referenceWords, word) || isIn(decorations, word);
         });
}

}  // namespace

void Settling::takeReferencesByValues() {
  constexpr double follows = 0.75, least = 0.8, most = 1.25;  // a drive goes with the speed, too
  for (size_t c = 0; c < fates_.size(); ++c) {
    if (!isFree(c)) continue;
    const NameParts parts = partsOfName(fates_[c].from, table_.columns[c].unit);
    if (!namesOnlyReference(parts.words) || parts.unknownUnit) continue;
    std::optional<size_t> best;
    double bestScale = 1.0, bestCorrelation = follows;
    for (const char* name : {"angle_rad", "velocity_rad_per_s"}) {
      const auto measured = columnOf(name);
      const std::string reference = std::string(name).insert(std::string(name).find('_'), "_reference");
      if (!measured || columnOf(reference)) continue;
      const bool fits =
          parts.unit == nullptr || parts.unit->kind == (isAngle(name) ? UnitKind::angle : UnitKind::angularVelocity);
      if (!fits || (parts.unit != nullptr && parts.unit->needs != UnitNeeds::nothing)) continue;
      const double scale =
          parts.unit == nullptr ? fates_[*measured].scale : parts.unit->scale * parts.factor * gear(name);
      std::vector<double> shall = values(c);
      convert(shall, scale, 0.0);
      const Following one = followingOf(shall, values(*measured));
      if (one.correlation < bestCorrelation || one.slope < least || one.slope > most) continue;
      best = measured;
      bestScale = scale;
      bestCorrelation = one.correlation;
    }
    if (!best) continue;
    ColumnFate& fate = fates_[c];
    fate.kind = ColumnFate::Kind::used;
    fate.to = std::string(fates_[*best].to).insert(fates_[*best].to.find('_'), "_reference");
    fate.unit = parts.unit == nullptr ? fates_[*best].unit : parts.unitText;
    fate.scale = bestScale;
    fate.offset = 0.0;
    fate.guessed = true;
    fate.why = message("{} follows it", fates_[*best].from);
    fate.doubt = fate.why;
    convert(values(c), bestScale, 0.0);
    settled_.insert(c);
  }
}

void Settling::takeReferenceUnit(size_t c) {
  const std::string& to = fates_[c].to;
  const bool angle = to == "angle_reference_rad";
  if ((!angle && to != "velocity_reference_rad_per_s") || !fates_[c].unit.empty()) return;
  const auto measured = columnOf(angle ? "angle_rad" : "velocity_rad_per_s");
  if (!measured && !choices_[c].byMap) return speedReferenceByAngle(c);
  if (!measured) return;
  fates_[c].scale = fates_[*measured].scale / gear(to);
  fates_[c].unit = fates_[*measured].unit;
  fates_[c].why = message("in the unit of {}", fates_[*measured].from);
  constexpr double far = 4.0, near = 1.5;  // times as much
  const double goes = rangeOf(values(*measured)), shall = rangeOf(values(c));
  const auto times = [&](double scale) { return std::exp(std::abs(std::log(scale * gear(to) * shall / goes))); };
  if (!(goes > 0.0)) return;
  if (!(shall > 0.0)) {
    if (!choices_[c].byMap && staysElsewhere(c, *measured))
      keep(c, message("stays nowhere near {}", fates_[*measured].from));
    return;
  }
  if (times(fates_[c].scale) < far) {
    const bool namesake = ownerOf(fates_[c].from) == ownerOf(fates_[*measured].from);
    const bool byItself = understandName(fates_[c].from, table_.columns[c].unit).to == to;  // not by names beside it
    if (byItself && !namesake && !choices_[c].byMap && !isFollowed(c, *measured))
      keep(c, message("is called by something else than {}, which doesn't follow it", fates_[*measured].from));
    return;
  }
  for (const char* unit : angle ? std::array{"rad", "deg", "turns"} : std::array{"rad/s", "deg/s", "rpm"}) {
    if (times(unitNamed(unit)->scale) > near) continue;
    fates_[c].scale = unitNamed(unit)->scale;
    fates_[c].unit = unit;
    fates_[c].why = message("so it goes about as far as {}", fates_[*measured].from);
    return;
  }
  keep(c, message("goes neither as far as {} nor as it would in another unit", fates_[*measured].from));
}

bool Settling::staysElsewhere(size_t reference, size_t measured) {
  constexpr double far = 4.0;
  const auto& all = values(measured);
  const auto first =
      std::find_if(values(reference).begin(), values(reference).end(), [](double v) { return std::isfinite(v); });
  if (first == values(reference).end() || *first == 0.0) return false;
  const double shall = *first * fates_[reference].scale * gear(fates_[reference].to);
  if (isSpeed(fates_[measured].to)) return std::abs(std::log(std::abs(shall) / largest(all))) > std::log(far);
  const double range = rangeOf(all);
  return std::none_of(all.begin(), all.end(), [&](double v) { return std::abs(v - shall) <= range; });
}

bool Settling::isFollowed(size_t reference, size_t measured) {
  constexpr double little = 0.3;
  return followedBy(values(reference), values(measured)) > little;
}

void Settling::speedReferenceByAngle(size_t c) {
  constexpr double follows = 0.75, least = 0.6, most = 1.6;
  constexpr size_t mostSpans = 200;
  const auto angle = columnOf("angle_rad");
  if (!angle || fates_[c].to != "velocity_reference_rad_per_s") return;
  const size_t rows = values(c).size(), span = std::max<size_t>(1, rows / mostSpans);
  std::vector<double> shall, moved;
  for (size_t k = 0; k + span < rows; k += span) {
    shall.push_back(values(c)[k]);
    moved.push_back((values(*angle)[k + span] - values(*angle)[k]) / (time_.time_s[k + span] - time_.time_s[k]));
  }
  const Following one = followingOf(shall, moved);
  const std::string own = fates_[*angle].unit + "/s";
  const auto fits = [&](double scale) { return one.slope / scale > least && one.slope / scale < most; };
  const auto take = [&](double scale, const std::string& unit) {
    fates_[c].scale = scale / gear(fates_[c].to);
    fates_[c].unit = unit;
    fates_[c].why = message("{} follows it so", fates_[*angle].from);
    fates_[c].guessed = true;
  };
  if (rangeOf(shall) > 0.0 && one.correlation > follows) {
    if (!fates_[*angle].unit.empty() && fits(fates_[*angle].scale)) return take(fates_[*angle].scale, own);
    for (const char* unit : {"rad/s", "deg/s", "rpm"}) {
      if (fits(unitNamed(unit)->scale)) return take(unitNamed(unit)->scale, unit);
    }
  }
  if (largest(values(c)) > 0.0)
    keep(c, message("nothing tells its unit, and {} doesn't follow it", fates_[*angle].from));
}

}  // namespace breakaway
