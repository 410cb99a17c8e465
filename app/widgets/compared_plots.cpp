#include "widgets/compared_plots.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "session/comparison.h"
#include "widgets/controls.h"
#include "widgets/evidence_plot.h"
#include "widgets/residual_plots.h"

namespace breakaway {

namespace {

constexpr int shortestAxis = 14, widestAxis_px = 280;
constexpr int leastForBoth_px = 560;  // three plots of 110 px, with their axes and what chooses them

QFrame* comparedCard(QWidget* parent, QWidget* plot) {
  auto* frame = card(parent);
  columnOf(frame)->setContentsMargins(12, 8, 12, 8);
  plot->setParent(frame);
  columnOf(frame)->addWidget(plot, 1);
  return frame;
}

}  // namespace

ComparedPlots::ComparedPlots(Comparison& comparison, QWidget* parent) : QWidget(parent), comparison_(comparison) {
  auto* column = columnIn(this, 8);
  column->addWidget(buildRow());
  auto* evidence = new EvidencePlot(comparison_, this);
  plots_ = new ResidualPlots(comparison_, this);
  evidence_ = comparedCard(this, evidence);
  motion_ = comparedCard(this, plots_);
  column->addWidget(evidence_, 2);
  column->addWidget(motion_, 3);
  connect(evidence, &EvidencePlot::reading, this, &ComparedPlots::reading);
  connect(plots_, &ResidualPlots::visibleChanged, this, &ComparedPlots::visibleChanged);
  connect(axis_, &QComboBox::currentIndexChanged, this, [this] { plots_->setAxis(axis_->currentData().toString()); });
  connect(axis_, &QComboBox::activated, this, [this] { choose(false); });
  connect(keep_, &QPushButton::clicked, this, &ComparedPlots::keepAsked);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &ComparedPlots::arrange);
  arrange();
}

QWidget* ComparedPlots::buildRow() {
  auto* group = new QWidget(this);
  auto* row = rowIn(group, 4);
  evidenceChip_ = chipButton(group, "showEvidence", tr("Evidence"), {});
  motionChip_ = chipButton(group, "showMotion", tr("Motion and residual"),
                           tr("Measured and simulated motion, and what is left between them"));
  auto* chips = new QButtonGroup(group);
  for (QPushButton* chip : {evidenceChip_, motionChip_}) {
    chips->addButton(chip);
    row->addWidget(chip);
    connect(chip, &QPushButton::clicked, this, [this, chip] { choose(chip == evidenceChip_); });
  }
  row->addSpacing(8);
  row->addStretch(1);
  axis_ = new QComboBox(group);
  axis_->setObjectName("residualAxis");
  axis_->setAccessibleName(tr("Axis of the residual"));
  const std::pair<const char*, QString> axes[] = {{"time", tr("time")},
                                                  {"angle", tr("angle")},
                                                  {"velocity", tr("velocity")},
                                                  {"acceleration", tr("acceleration")},
                                                  {"current", tr("motor torque or force")},
                                                  {"reversal", tr("travel since reversal")}};
  for (const auto& [name, words] : axes) axis_->addItem(tr("Residual over %1").arg(words), name);
  // Where words are long, it is what gives way.
  axis_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  axis_->setMinimumContentsLength(shortestAxis);
  axis_->setMaximumWidth(widestAxis_px);
  row->addWidget(axis_, 8);
  keep_ = pushButton(group, "keepVisibleButton", tr("Keep visible part"));
  row->addWidget(keep_);
  return group;
}

void ComparedPlots::showResidualOver(const QString& axis) {
  axis_->setCurrentIndex(axis_->findData(axis));
  choose(false);
}

void ComparedPlots::showEvidenceOf(const QString& effect) {
  comparison_.chooseEvidence(effect.toStdString());
  choose(true);
}

std::pair<double, double> ComparedPlots::visible_s() const {
  return plots_->visible_s();
}

void ComparedPlots::setKeepObstacle(const QString& reason) {
  setAvailable(keep_, tr("Puts what the plot over time shows into the project, as a recording of its own"), reason);
}

void ComparedPlots::choose(bool evidence) {
  evidenceWanted_ = evidence;
  arrange();
}

/// Before a diagnosis the recording has all the room.
void ComparedPlots::arrange() {
  const bool diagnosed = comparison_.diagnosis().has_value();
  const bool both = diagnosed && height() >= leastForBoth_px;
  const bool evidence = diagnosed && (both || evidenceWanted_), motion = both || !evidence;
  for (QPushButton* chip : {evidenceChip_, motionChip_}) chip->setVisible(!both);
  setAvailable(evidenceChip_, diagnosed, tr("What is left over the finding's own axis, before and after"),
               tr("Comes with the diagnosis: press Diagnose"));
  (evidence ? evidenceChip_ : motionChip_)->setChecked(true);
  setAvailable(axis_, motion, tr("Over what the residual is drawn. Drag and wheel zoom in time."),
               tr("The evidence lies over its finding's own axis; Motion and residual is drawn over any"));
  // One goes before the other comes: together they may ask for more room than there is.
  if (!evidence) evidence_->hide();
  if (!motion) motion_->hide();
  evidence_->setVisible(evidence);
  motion_->setVisible(motion);
}

void ComparedPlots::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

}  // namespace breakaway
