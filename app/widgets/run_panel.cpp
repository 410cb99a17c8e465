#include "widgets/run_panel.h"

#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "session/language.h"
#include "widgets/controls.h"

namespace breakaway {

RunPanel::RunPanel(const char* objectName, std::vector<RunKind> kinds, QWidget* parent)
    : QWidget(parent), kinds_(std::move(kinds)), bar_(new QProgressBar(this)), activity_(new QLabel(this)) {
  setObjectName(objectName);
  auto* column = columnIn(this, 3);
  bar_->setObjectName(QString(objectName) + "Bar");
  bar_->setAccessibleName(tr("Progress"));
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedHeight(10);
  activity_->setObjectName(QString(objectName) + "Activity");
  activity_->setAccessibleName(tr("Activity"));
  activity_->setWordWrap(true);
  activity_->setMinimumHeight(2 * activity_->fontMetrics().lineSpacing());
  activity_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  activity_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(bar_);
  column->addWidget(activity_);
}

void RunPanel::show(const RunSnapshot& snapshot) {
  if (snapshot.kind == RunKind::none) {  // another board, or none: what the last one did is over
    shown_ = {};
    bar_->setValue(0);
    activity_->clear();
    return;
  }
  if (std::find(kinds_.begin(), kinds_.end(), snapshot.kind) == kinds_.end()) return;
  const Procedure::Status& status = snapshot.status;
  shown_ = {snapshot.kind, status, {}, snapshot.endedByBoard};
  bar_->setValue(static_cast<int>(std::lround(1000.0 * std::clamp(status.progress, 0.0, 1.0))));
  const QString activity = inLanguage(status.activity);
  const QString failure = inLanguage(status.failure);
  switch (status.state) {
    case Procedure::State::running:
      activity_->setText(tr("%1 %: %2").arg(100.0 * status.progress, 0, 'f', 0).arg(activity));
      break;
    case Procedure::State::finished:
      activity_->setText(tr("Done"));
      break;
    case Procedure::State::failed:
      activity_->setText(tr("Failed: %1").arg(failure));
      break;
    case Procedure::State::stopped:
      activity_->setText(tr("Stopped: %1. What was measured is kept.").arg(failure));
      break;
  }
}

}  // namespace breakaway
