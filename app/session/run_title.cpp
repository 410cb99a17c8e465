#include "session/run_title.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <iterator>
#include <string_view>

namespace breakaway {

namespace {

struct KindInWords {
  std::string_view name;
  const char* words;
};

constexpr KindInWords kindWords[] = {{"commission", QT_TRANSLATE_NOOP("RunWords", "Friction map")},
                                     {"map", QT_TRANSLATE_NOOP("RunWords", "Friction map")},
                                     {"identification", QT_TRANSLATE_NOOP("RunWords", "Motor")},
                                     {"diagnosis", QT_TRANSLATE_NOOP("RunWords", "Diagnosis")},
                                     {"recording", QT_TRANSLATE_NOOP("RunWords", "Recording")},
                                     {"tuning", QT_TRANSLATE_NOOP("RunWords", "Tuning")},
                                     {"batch", QT_TRANSLATE_NOOP("RunWords", "Batch")},
                                     {"files", QT_TRANSLATE_NOOP("RunWords", "Files")}};

QString titleText(const char* text) {
  return QCoreApplication::translate("RunWords", text);
}

}  // namespace

QString kindInWords(const std::string& kind) {
  const auto* found = std::find_if(std::begin(kindWords), std::end(kindWords),
                                   [&kind](const KindInWords& one) { return one.name == kind; });
  return found == std::end(kindWords) ? QString::fromStdString(kind) : titleText(found->words);
}

QString timeInWords(const ProjectRun& run) {
  const QDateTime at = QDateTime::fromString(QString::fromStdString(run.at), Qt::ISODate);
  return at.isValid() ? at.toLocalTime().toString("yyyy-MM-dd HH:mm") : QString::fromStdString(run.at);
}

QString titleOf(const ProjectRun& run) {
  const QString title =
      titleText(QT_TRANSLATE_NOOP("RunWords", "%1 of %2")).arg(kindInWords(run.kind), timeInWords(run));
  return run.name.empty() ? title : QString("%1 (%2)").arg(title, QString::fromStdString(run.name));
}

}  // namespace breakaway
