#include "widgets/run_words.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <iterator>
#include <string_view>

#include "session/language.h"
#include "widgets/parameter_words.h"

namespace breakaway {

namespace {

constexpr NameInWords verdictWords[] = {
    {"nothing_missing", QT_TRANSLATE_NOOP("RunWords", "nothing missing")},
    {"named", QT_TRANSLATE_NOOP("RunWords", "named")},
    {"ambiguous", QT_TRANSLATE_NOOP("RunWords", "ambiguous")},
    {"outside_catalogue", QT_TRANSLATE_NOOP("RunWords", "something without a name")},
    {"undecided", QT_TRANSLATE_NOOP("RunWords", "too little to tell")}};

// What a person compares first; the first two that a run has are told.
constexpr NameInWords headlines[] = {{"static_average_Nm", QT_TRANSLATE_NOOP("RunWords", "static")},
                                     {"static_average_N", QT_TRANSLATE_NOOP("RunWords", "static")},
                                     {"coulomb_average_Nm", QT_TRANSLATE_NOOP("RunWords", "Coulomb")},
                                     {"coulomb_average_N", QT_TRANSLATE_NOOP("RunWords", "Coulomb")},
                                     {"torque_constant_Nm_per_A", QT_TRANSLATE_NOOP("RunWords", "Kt")},
                                     {"resistance_ohm", QT_TRANSLATE_NOOP("RunWords", "R")},
                                     {"inertia_kg_m2", QT_TRANSLATE_NOOP("RunWords", "J")}};
constexpr int mostHeadlines = 2;

// With and without an N for each Nm: of either axis.
constexpr std::string_view lookedFor[] = {"static_average",   "coulomb_average", "viscous_average",
                                          "torque_constant",  "force_constant",  "resistance",
                                          "inductance",       "inertia",         "mass",
                                          "coulomb",          "viscous",         "dead_zone",
                                          "stribeck_velocity"};

size_t rankOf(const RunValue& value) {
  const auto* found = std::find_if(std::begin(lookedFor), std::end(lookedFor),
                                   [&value](std::string_view one) { return value.name.starts_with(one); });
  return static_cast<size_t>(found - std::begin(lookedFor));
}

/// "static 20.1 mNm"
QString headlineOf(const QString& name, const RunValue& value) {
  const ParameterWords words = wordsOf(Parameter{value.name, value.value, value.low, value.high});
  return QString("%1 %2 %3").arg(name, words.value, words.unit).trimmed();
}

/// How long a recording is, as its run's file says it in English.
QString recordingInWords(const QString& kept) {
  static const QRegularExpression form(
      R"(^([\d.]+) s, (\d+) samples(?:, (\d+) lost)?(?:, (\d+) bytes damaged)?(?:; ended by: (.*))?$)");
  const QRegularExpressionMatch found = form.match(kept);
  if (!found.hasMatch()) return kept;
  QString words = runWords(QT_TRANSLATE_NOOP("RunWords", "%1 s, %2 samples")).arg(found.captured(1), found.captured(2));
  if (!found.captured(3).isEmpty())
    words += ", " + runWords(QT_TRANSLATE_NOOP("RunWords", "%1 lost")).arg(found.captured(3));
  if (!found.captured(4).isEmpty())
    words += ", " + runWords(QT_TRANSLATE_NOOP("RunWords", "%1 bytes damaged")).arg(found.captured(4));
  if (!found.captured(5).isEmpty())
    words += "; " + runWords(QT_TRANSLATE_NOOP("RunWords", "ended by: %1"))
                        .arg(inLanguage(Message(found.captured(5).toStdString())));
  return words;
}

}  // namespace

QString resultInWords(const ProjectRun& run) {
  if (run.state == RunState::recording) return runWords(QT_TRANSLATE_NOOP("RunWords", "being recorded"));
  QStringList parts;
  if (!run.verdict.empty()) {
    parts << (run.kind == "recording" ? recordingInWords(QString::fromStdString(run.verdict))
                                      : inWords(verdictWords, run.verdict));
  } else {
    for (const NameInWords& one : headlines) {
      const RunValue* value = run.value(std::string(one.name));
      if (value != nullptr && parts.size() < mostHeadlines) parts << headlineOf(runWords(one.words), *value);
    }
  }
  return parts.join(", ");
}

std::vector<RunValue> byImportance(const ProjectRun& run) {
  std::vector<RunValue> values = run.values;
  std::stable_sort(values.begin(), values.end(),
                   [](const RunValue& one, const RunValue& other) { return rankOf(one) < rankOf(other); });
  return values;
}

}  // namespace breakaway
