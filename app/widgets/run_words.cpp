#include "widgets/run_words.h"

#include <QStringList>

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

/// "static 20.1 mNm"
QString headlineOf(const QString& name, const RunValue& value) {
  const ParameterWords words = wordsOf(Parameter{value.name, value.value, value.low, value.high});
  return QString("%1 %2 %3").arg(name, words.value, words.unit).trimmed();
}

}  // namespace

QString resultInWords(const ProjectRun& run) {
  if (run.state == RunState::recording) return runText(QT_TRANSLATE_NOOP("RunWords", "being recorded"));
  QStringList parts;
  if (!run.verdict.empty()) {
    parts << inWords(verdictWords, run.verdict);
  } else {
    for (const NameInWords& one : headlines) {
      const RunValue* value = run.value(std::string(one.name));
      if (value != nullptr && parts.size() < mostHeadlines) parts << headlineOf(runText(one.words), *value);
    }
  }
  return parts.join(", ");
}

}  // namespace breakaway
