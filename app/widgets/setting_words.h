// A board's settings in words: the one table of their titles, units and meanings.
#pragma once

#include <QString>

#include "experiment/identity.h"
#include "experiment/setting_range.h"

namespace breakaway {

struct SettingWords {
  QString title;       ///< "Velocity Kp"
  QString unit;        ///< "A s/rad"
  double scale = 1.0;  ///< shown = scale · SI
  QString meaning;     ///< one sentence

  QString titleWithUnit() const { return title + " (" + unit + ")"; }
  /// "0 to 12 A", "0 and more, in A": what the board lets it be.
  QString rangeText(const SettingRange& range) const;
};

SettingWords settingWords(double ControllerSettings::*setting, Axis axis);

}  // namespace breakaway
