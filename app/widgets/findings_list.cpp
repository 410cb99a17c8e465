#include "widgets/findings_list.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "session/comparison.h"
#include "session/language.h"
#include "widgets/controls.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/parameter_words.h"
#include "widgets/residual_axis.h"
#include "widgets/rival_bars.h"

namespace breakaway {

namespace {

QLabel* wrapped(QLabel* label) {
  label->setWordWrap(true);
  return label;
}

QLabel* heading(QWidget* parent, const QString& text) {
  auto* label = new QLabel(text, parent);
  label->setFont(typed(Type::body, true));
  return label;
}

QString names(const std::vector<std::string>& effects) {
  QStringList list;
  for (const std::string& effect : effects) list << effectTitle(effect);
  return list.join(", ");
}

}  // namespace

QString effectTitle(const std::string& effect) {
  return nameInLanguage(effect);
}

FindingsList::FindingsList(Comparison& comparison, QWidget* parent) : QWidget(parent), comparison_(comparison) {
  setObjectName("findingsList");
  setAccessibleName(tr("Findings"));
  setToolTip(tr("What is missing, the most important first; untick one to see the fit without it"));
  columnIn(this);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &FindingsList::rebuild);
  connect(&comparison_, &Comparison::evidenceChanged, this, &FindingsList::showLinks);
  rebuild();
}

void FindingsList::rebuild() {
  if (content_ != nullptr) {
    layout()->removeWidget(content_);
    content_->hide();
    content_->deleteLater();  // one of its boxes may have asked
  }
  content_ = new QWidget(this);
  layout()->addWidget(content_);
  auto* column = columnIn(content_, 8);
  links_.clear();
  if (const auto& diagnosis = comparison_.diagnosis()) {
    for (const Finding& finding : diagnosis->findings) addFinding(*column, finding);
    if (diagnosis->findings.empty() && !diagnosis->misread)
      addText(*column, tr("No effect of the catalogue is missing."));
    addPlaces(*column);
    if (!diagnosis->nextSentence.empty()) {
      column->addWidget(heading(content_, tr("Next experiment")));
      addText(*column, inLanguage(diagnosis->nextSentence), "nextExperiment");
    }
    for (const Message& remark : diagnosis->remarks) addText(*column, inLanguage(remark));
  } else {
    addText(*column, tr("Diagnose says where the recording departs from what its bench file declares, which physics "
                        "was left out, how big it "
                        "is, and how much better the simulation gets on data that was held out."));
  }
  content_->show();
  showLinks();
}

/// To the evidence of each finding that has some.
void FindingsList::showLinks() {
  for (const auto& [effect, link] : links_)
    link->setVisible(std::any_of(comparison_.evidences().begin(), comparison_.evidences().end(),
                                 [name = effect](const Evidence& one) { return one.effect == name; }));
}

void FindingsList::addFinding(QVBoxLayout& column, const Finding& finding) {
  QWidget* parent = column.parentWidget();
  auto* box = new QCheckBox(effectTitle(finding.effect), parent);
  box->setObjectName("finding_" + QString::fromStdString(finding.effect));
  box->setAccessibleName(effectTitle(finding.effect));
  box->setChecked(comparison_.includes(finding.effect));
  box->setFont(typed(Type::body, true));
  box->setToolTip(tr("Untick to see the fit without it (Return)"));
  connect(box, &QCheckBox::toggled, &comparison_,
          [this, effect = finding.effect](bool on) { comparison_.include(effect, on); });
  column.addWidget(box);
  column.addWidget(wrapped(caption(parent, tr("%1 % of what the base model leaves; chance would do so in %2 % of cases")
                                               .arg(100.0 * finding.share, 0, 'f', 0)
                                               .arg(numberText(100.0 * finding.pValue, 2)))));
  addText(column, inLanguage(finding.sentence));
  auto* link = new QLabel(
      QString("<a href='%1'>%2</a>").arg(QString::fromStdString(finding.effect), tr("Its evidence")), parent);
  link->setObjectName("evidence_" + QString::fromStdString(finding.effect));
  link->setToolTip(tr("The residual over this finding's own axis, before and after"));
  link->setTextInteractionFlags(Qt::TextBrowserInteraction);
  link->setFocusPolicy(Qt::StrongFocus);
  connect(link, &QLabel::linkActivated, this, &FindingsList::evidenceChosen);
  column.addWidget(link);
  links_.emplace_back(finding.effect, link);
  for (const Parameter& parameter : finding.parameters)
    column.addWidget(wrapped(caption(parent, wordsOf(parameter).line())));
  if (!finding.ambiguousWith.empty()) addText(column, tr("Could also be: %1.").arg(names(finding.ambiguousWith)));
  addRivals(column, finding);
}

/// Why it won, or why it can't be told from others.
void FindingsList::addRivals(QVBoxLayout& column, const Finding& finding) {
  QWidget* parent = column.parentWidget();
  if (!finding.rivals.empty()) {
    column.addWidget(wrapped(caption(parent, tr("Error on unseen data with others in its place, lines 95 %"))));
    column.addWidget(new RivalBars(*comparison_.diagnosis(), finding, parent));
  }
  column.addWidget(wrapped(caption(parent, inLanguage(rivalSentence(finding)))));
}

void FindingsList::addPlaces(QVBoxLayout& column) {
  const auto& places = comparison_.diagnosis()->where;
  if (places.empty()) return;
  column.addWidget(heading(column.parentWidget(), tr("Where")));
  for (const Place& place : places) {
    const QString axis = QString::fromStdString(place.axis);
    QString text = inLanguage(place.sentence).toHtmlEscaped();
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
