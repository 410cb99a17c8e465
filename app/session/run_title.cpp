#include "session/run_title.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>

namespace breakaway {

namespace {

constexpr NameInWords kindWords[] = {{"commission", QT_TRANSLATE_NOOP("RunWords", "Friction map")},
                                     {"map", QT_TRANSLATE_NOOP("RunWords", "Friction map")},
                                     {"identification", QT_TRANSLATE_NOOP("RunWords", "Motor")},
                                     {"diagnosis", QT_TRANSLATE_NOOP("RunWords", "Diagnosis")},
                                     {"recording", QT_TRANSLATE_NOOP("RunWords", "Recording")},
                                     {"tuning", QT_TRANSLATE_NOOP("RunWords", "Tuning")},
                                     {"batch", QT_TRANSLATE_NOOP("RunWords", "Batch")},
                                     {"files", QT_TRANSLATE_NOOP("RunWords", "Files")}};

}  // namespace

QString runWords(const char* text) {
  return QCoreApplication::translate("RunWords", text);
}

QString inWords(std::span<const NameInWords> list, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&name](const NameInWords& one) { return one.name == name; });
  return found == list.end() ? QString::fromStdString(name) : runWords(found->words);
}

QString kindInWords(const std::string& kind) {
  return inWords(kindWords, kind);
}

QString timeInWords(const ProjectRun& run) {
  const QDateTime at = QDateTime::fromString(QString::fromStdString(run.at), Qt::ISODate);
  return at.isValid() ? at.toLocalTime().toString("yyyy-MM-dd HH:mm") : QString::fromStdString(run.at);
}

QString titleOf(const ProjectRun& run) {
  const QString title =
      runWords(QT_TRANSLATE_NOOP("RunWords", "%1 of %2")).arg(kindInWords(run.kind), timeInWords(run));
  return run.name.empty() ? title : QString("%1 (%2)").arg(title, QString::fromStdString(run.name));
}

}  // namespace breakaway
