// A parameter's public name, which ends in its unit, as people read it: words, and a unit of a size that suits.
#pragma once

#include <QString>

#include "diagnose/model/model.h"

namespace breakaway {

struct ParameterWords {
  QString name;      ///< "Viscous", "Phase"
  QString value;     ///< "78.7"
  QString interval;  ///< "73.7 to 83.7"; empty where it was held
  QString unit;      ///< "N s/m", "°"
  QString estimate;  ///< "78.7 ± 5.0 N s/m": value, half of its interval and unit

  /// All of it in one line.
  QString line() const;
};

ParameterWords wordsOf(const Parameter& parameter);
/// "4.53 mm", "0.0124°", "1.2 rad/s": a position, angle or speed of a fit's `channel`.
QString channelText(double value, const std::string& channel);

}  // namespace breakaway
