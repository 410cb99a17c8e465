#include "widgets/findings_list.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include "session/comparison.h"
#include "widgets/controls.h"
#include "widgets/look.h"
#include "widgets/residual_axis.h"

namespace breakaway {

namespace {

QString verdictText(Verdict verdict) {
  switch (verdict) {
    case Verdict::nothingMissing:
      return FindingsList::tr("Nothing is missing: the base model explains the recording");
    case Verdict::named:
      return FindingsList::tr("Missing physics found and named");
    case Verdict::ambiguous:
      return FindingsList::tr("Missing physics found; the data allow more than one name");
    case Verdict::outsideCatalogue:
      return FindingsList::tr("Something is missing that the catalogue has no name for");
  }
  return {};
}

/// "excess_Nm = 0.0031  [0.0029, 0.0033]": the name with its unit as it stands, the value and its 95 % interval.
QString parameterText(const Parameter& parameter) {
  QString value = QString("%1 = %2").arg(QString::fromStdString(parameter.name)).arg(parameter.value, 0, 'g', 4);
  if (parameter.low95 == parameter.high95) return value;
  return value + FindingsList::tr("  [%1, %2]").arg(parameter.low95, 0, 'g', 4).arg(parameter.high95, 0, 'g', 4);
}

QString names(const std::vector<std::string>& effects) {
  QStringList list;
  for (const std::string& effect : effects) list << effectTitle(effect);
  return list.join(", ");
}

}  // namespace

QString effectTitle(const std::string& effect) {
  return QString::fromStdString(effect).replace('_', ' ');
}

FindingsList::FindingsList(Comparison& comparison, QWidget* parent) : QScrollArea(parent), comparison_(comparison) {
  setObjectName("findingsList");
  setAccessibleName(tr("Findings"));
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &FindingsList::rebuild);
  rebuild();
}

void FindingsList::rebuild() {
  auto* content = new QWidget;
  auto* column = columnIn(content, 4, {0, 0, 8, 0});
  if (const auto& diagnosis = comparison_.diagnosis()) {
    addVerdict(*column);
    int rank = 0;
    for (const Finding& finding : diagnosis->findings) addFinding(*column, finding, ++rank);
    addPlaces(*column);
    if (!diagnosis->nextSentence.empty()) {
      column->addWidget(caption(content, tr("Next experiment")));
      addText(*column, QString::fromStdString(diagnosis->nextSentence), "nextExperiment");
    }
    for (const std::string& remark : diagnosis->remarks) addText(*column, QString::fromStdString(remark));
  } else {
    addText(*column, tr("Diagnose says where the recording departs from what its bench file declares, which physics "
                        "was left out, how big it "
                        "is, and how much better the simulation gets on data that was held out."));
  }
  column->addStretch(1);
  setWidget(content);
}

void FindingsList::addVerdict(QVBoxLayout& column) {
  auto* verdict = new QLabel(verdictText(comparison_.diagnosis()->verdict), column.parentWidget());
  verdict->setObjectName("verdict");
  verdict->setWordWrap(true);
  verdict->setFont(sized(font(), 1.08, true));
  column.addWidget(verdict);
}

void FindingsList::addFinding(QVBoxLayout& column, const Finding& finding, int rank) {
  const QString title = tr("%1. %2: %3 % of the excess, p = %4")
                            .arg(rank)
                            .arg(effectTitle(finding.effect))
                            .arg(100.0 * finding.share, 0, 'f', 0)
                            .arg(finding.pValue, 0, 'g', 2);
  auto* box = new QCheckBox(title, column.parentWidget());
  box->setObjectName("finding_" + QString::fromStdString(finding.effect));
  box->setChecked(comparison_.includes(finding.effect));
  box->setFont(sized(font(), 1.0, true));
  box->setToolTip(tr("Untick to see the fit without it (Return)"));
  connect(box, &QCheckBox::toggled, &comparison_,
          [this, effect = finding.effect](bool on) { comparison_.include(effect, on); });
  column.addWidget(box);
  QString text = QString::fromStdString(finding.sentence);
  if (!finding.ambiguousWith.empty()) text += tr(" Could also be: %1.").arg(names(finding.ambiguousWith));
  for (const Parameter& parameter : finding.parameters) text += "\n" + parameterText(parameter);
  addText(column, text);
}

void FindingsList::addPlaces(QVBoxLayout& column) {
  const auto& places = comparison_.diagnosis()->where;
  if (places.empty()) return;
  column.addWidget(caption(column.parentWidget(), tr("Where")));
  for (const Place& place : places) {
    const QString axis = QString::fromStdString(place.axis);
    QString text = QString::fromStdString(place.sentence).toHtmlEscaped();
    if (residualAxes().contains(axis)) text += QString(" <a href='%1'>%2</a>").arg(axis, tr("Show"));
    auto* sentence = explanation(column.parentWidget(), text);
    sentence->setObjectName("place_" + axis);
    sentence->setTextFormat(Qt::RichText);
    sentence->setTextInteractionFlags(Qt::TextBrowserInteraction);
    sentence->setFocusPolicy(Qt::StrongFocus);
    connect(sentence, &QLabel::linkActivated, this, &FindingsList::axisChosen);
    column.addWidget(sentence);
  }
}

void FindingsList::addText(QVBoxLayout& column, const QString& text, const char* objectName) {
  column.addWidget(explanation(column.parentWidget(), text, objectName));
}

}  // namespace breakaway
