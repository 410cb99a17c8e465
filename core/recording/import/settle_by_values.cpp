// What columns are that no name told: how fast it moves, and what drives it, by the values themselves.
#include <algorithm>
#include <cmath>

#include "recording/import/drive_evidence.h"
#include "recording/import/name_by_unit.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settling.h"

namespace breakaway {

bool Settling::isUnknown(size_t c) const {
  const ColumnName& name = choices_[c].name;
  return isFree(c) && (!name.unknownWord.empty() || name.saysNothing);
}

bool Settling::isFree(size_t c) const {
  return fates_[c].kind == ColumnFate::Kind::kept && !choices_[c].byMap && !choices_[c].byTool &&
         !table_.columns[c].fault && !table_.columns[c].clock;
}

void Settling::takeSpeedByValues() {
  const auto angle = columnOf("angle_rad");
  if (!angle || columnOf("velocity_rad_per_s") || columnOf("position_m") || columnOf("velocity_m_per_s")) return;
  constexpr double agrees = 0.98, within = 1.1;  // rows may be far apart for how fast it changes
  size_t best = fates_.size();
  double bestCorrelation = agrees, bestScale = 1.0;
  std::string bestUnit;
  for (size_t c = 0; c < fates_.size(); ++c) {
    const NameParts parts = partsOfName(fates_[c].from, table_.columns[c].unit);
    const bool told = parts.unit != nullptr && parts.unit->kind == UnitKind::angularVelocity;
    if (!(isUnknown(c) || (isFree(c) && choices_[c].name.nameless)) || (parts.unit != nullptr && !told) ||
        parts.unknownUnit || isMultiplied(fates_[c].from))
      continue;
    const auto motion = compareMotion(time_.time_s, values(*angle), values(c), time_.pauses);
    if (!motion || !(motion->correlation > bestCorrelation) || variesAlike(values(*angle), values(c)) < agrees)
      continue;
    for (const char* unit : {"rad/s", "deg/s", "rpm", "rev/s"}) {
      const double scale = told ? parts.unit->scale * parts.factor : unitNamed(unit)->scale;
      if (std::abs(std::log(motion->factor / (scale * gear("velocity_rad_per_s")))) > std::log(within)) continue;
      best = c;
      bestCorrelation = motion->correlation;
      bestScale = scale;
      bestUnit = told ? parts.unitText : unit;
    }
  }
  if (best == fates_.size()) return;
  ColumnFate& fate = fates_[best];
  fate.kind = ColumnFate::Kind::used;
  fate.to = "velocity_rad_per_s";
  fate.unit = bestUnit;
  fate.scale = bestScale;
  fate.offset = 0.0;
  fate.guessed = true;
  fate.why = message("{} moves as it says", fates_[*angle].from);
  fate.doubt = fate.why;
  choices_[best].name.needs = UnitNeeds::nothing;
}

void Settling::takeDrivesByValues() {
  constexpr double enough = 0.3;  // noise reaches 0.1
  const auto speed = columnOf("velocity_rad_per_s");
  const auto angle = columnOf("angle_rad");
  if ((!speed && !angle) || time_.time_s.size() < 3) return;
  std::vector<double> moved = speed ? values(*speed) : changesOf(values(*angle));
  if (!speed) {
    for (size_t k = 1; k < moved.size(); ++k) moved[k] /= time_.time_s[k] - time_.time_s[k - 1];
    moved.front() = moved[1];
  }
  for (const UnitKind kind : {UnitKind::current, UnitKind::torque, UnitKind::voltage}) {
    const std::string to = contractName(kind, false);
    if (columnOf(to)) continue;
    size_t found = fates_.size(), count = 0;
    for (size_t c = 0; c < fates_.size(); ++c) {
      if (!isUnknown(c)) continue;
      const NameParts parts = partsOfName(fates_[c].from, table_.columns[c].unit);
      const bool member = parts.unitText.size() == 1 && fates_[c].from.ends_with("." + parts.unitText);  // "inertia.a"
      if (parts.unit == nullptr || parts.unit->kind != kind || member || isMultiplied(fates_[c].from)) continue;
      const auto isOf = [&parts](const auto& words) { return firstIn(parts.words, words) != nullptr; };
      const bool another = isOf(otherThings) || isOf(loadWords) || isOf(supplyWords) || isOf(referenceWords) ||
                           isOf(drivenWords) || !notTheMotors(kind, parts.words, false).empty();
      constexpr double manyCounts = 60.0;  // a converter's
      if (areWhole(values(c)) && largest(values(c)) > manyCounts) continue;
      if (another || drivenBy(time_.time_s, moved, values(c), time_.pauses) < enough) continue;
      found = c;
      ++count;
    }
    if (count != 1) continue;
    const NameParts parts = partsOfName(fates_[found].from, table_.columns[found].unit);
    ColumnFate& fate = fates_[found];
    fate.kind = ColumnFate::Kind::used;
    fate.to = to;
    fate.unit = parts.unitText;
    fate.scale = parts.unit->scale * parts.factor;
    fate.offset = parts.unit->offset;
    fate.guessed = true;
    fate.why = message("by its unit, and it goes with acceleration and friction as what drives a motor does");
    fate.doubt = fate.why;
  }
}

}  // namespace breakaway
