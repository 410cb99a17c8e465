#include "widgets/parameter_words.h"

#include <QCoreApplication>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "session/language.h"
#include "widgets/number_text.h"

namespace breakaway {

namespace {

struct Ending {
  const char* ending;
  const char* unit;
  double scale;
};

constexpr double degree = 180.0 / std::numbers::pi;

// The longer ones first: the first that fits is taken.
constexpr Ending endings[] = {{"_Nm_s2_per_rad2", "µNm s²/rad²", 1e6},
                              {"_N_s2_per_m2", "N s²/m²", 1.0},
                              {"_Nm_s_per_rad", "µNm s/rad", 1e6},
                              {"_N_s_per_m", "N s/m", 1.0},
                              {"_V_s_per_rad", "mV s/rad", 1e3},
                              {"_V_s_per_m", "V s/m", 1.0},
                              {"_Nm_per_rad", "mNm/°", 1e3 / degree},
                              {"_N_per_m", "N/mm", 1e-3},
                              {"_Nm_per_A", "mNm/A", 1e3},
                              {"_N_per_A", "N/A", 1.0},
                              {"_Nm_per_s", "mNm/s", 1e3},
                              {"_rad_per_s", "rad/s", 1.0},
                              {"_m_per_s", "mm/s", 1e3},
                              {"_ohm_per_A2", "Ω/A²", 1.0},
                              {"_per_Nm", "1/Nm", 1.0},
                              {"_per_A2", "1/A²", 1.0},
                              {"_per_rad", "1/rad", 1.0},
                              {"_per_m", "1/m", 1.0},
                              {"_per_A", "1/A", 1.0},
                              {"_per_N", "1/N", 1.0},
                              {"_per_s", "1/s", 1.0},
                              {"_kg_m2", "g cm²", 1e7},
                              {"_ohm", "Ω", 1.0},
                              {"_degC", "°C", 1.0},
                              {"_rad", "°", degree},
                              {"_Nm", "mNm", 1e3},
                              {"_kg", "kg", 1.0},
                              {"_Hz", "Hz", 1.0},
                              {"_ms", "ms", 1.0},
                              {"_N", "N", 1.0},
                              {"_m", "mm", 1e3},
                              {"_s", "ms", 1e3},
                              {"_A", "A", 1.0},
                              {"_V", "V", 1.0},
                              {"_H", "mH", 1e3},
                              {"_J", "J", 1.0},
                              {"_K", "K", 1.0},
                              {"_W", "W", 1.0}};

}  // namespace

QString ParameterWords::line() const {
  const QString with = unit.isEmpty() ? value : value + " " + unit;
  return interval.isEmpty() ? QString("%1: %2").arg(name, with) : QString("%1: %2 (%3)").arg(name, with, interval);
}

ParameterWords wordsOf(const Parameter& parameter) {
  QString name = QString::fromStdString(parameter.name);
  ParameterWords words;
  double scale = 1.0;
  for (const Ending& ending : endings) {
    if (!name.endsWith(QLatin1String(ending.ending))) continue;
    name.chop(static_cast<qsizetype>(qstrlen(ending.ending)));
    words.unit = QString::fromUtf8(ending.unit);
    scale = ending.scale;
    break;
  }
  // Seconds are told in seconds where they are some.
  if (words.unit == "ms" && std::abs(parameter.value) >= 1.0) {
    words.unit = QStringLiteral("s");
    scale = 1.0;
  }
  words.name = nameInLanguage(name.toStdString());
  const bool exact = parameter.low95 == parameter.high95;
  words.value = exact ? plainText(scale * parameter.value) : numberText(scale * parameter.value);
  if (!exact)
    words.interval = QCoreApplication::translate("ParameterWords", "%1 to %2")
                         .arg(numberText(scale * parameter.low95), numberText(scale * parameter.high95));
  const double half = 0.5 * std::abs(parameter.high95 - parameter.low95);
  words.estimate = estimateText({parameter.value, half / normal95}, scale, words.unit).trimmed();
  return words;
}

QString channelText(double value, const std::string& channel) {
  if (channel == "torque_Nm") return numberText(1e3 * value) + " mNm";
  if (channel == "force_N") return numberText(value) + " N";
  const bool linear = channel.ends_with("_m") || channel.ends_with("_m_per_s");
  const bool speed = channel.ends_with("_per_s");
  if (!linear) return speed ? numberText(value) + " rad/s" : numberText(degree * value) + "°";
  const bool small = value < 1e-4;
  const QString unit = small ? QStringLiteral("µm") : QStringLiteral("mm");
  return numberText(value * (small ? 1e6 : 1e3)) + " " + unit + (speed ? "/s" : "");
}

}  // namespace breakaway
