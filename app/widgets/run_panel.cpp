#include "widgets/run_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "session/language.h"
#include "widgets/controls.h"

namespace breakaway {

RunPanel::RunPanel(const char* objectName, std::vector<RunKind> kinds, QWidget* parent)
    : QWidget(parent), kinds_(std::move(kinds)), activity_(new QLabel(this)) {
  setObjectName(objectName);
  activity_->setObjectName(QString(objectName) + "Activity");
  activity_->setAccessibleName(tr("Activity"));
  activity_->setWordWrap(true);
  activity_->setMinimumHeight(2 * activity_->fontMetrics().lineSpacing());
  activity_->setAlignment(Qt::AlignVCenter | Qt::AlignLeft);
  activity_->setTextInteractionFlags(Qt::TextBrowserInteraction);
  activity_->setToolTip(tr("How the last run ended, and what is next"));
  connect(activity_, &QLabel::linkActivated, this, &RunPanel::pageAsked);
  columnIn(this)->addWidget(activity_);
}

void RunPanel::leadOn(RunKind done, const QString& page, const QString& title) {
  next_[done] = QString("<a href='%1'>%2</a>").arg(page, title);
}

QString RunPanel::doneText(RunKind kind) const {
  const auto next = next_.find(kind);
  return next == next_.end() ? tr("Done") : tr("Done. Next: %1").arg(next->second);
}

bool RunPanel::saysSomething() const {
  return !activity_->text().isEmpty();
}

void RunPanel::show(const RunSnapshot& snapshot) {
  if (snapshot.kind == RunKind::none) {  // another board, or none: what the last one did is over
    shown_ = {};
    activity_->clear();
    return;
  }
  if (std::find(kinds_.begin(), kinds_.end(), snapshot.kind) == kinds_.end()) return;
  const Procedure::Status& status = snapshot.status;
  shown_ = {snapshot.kind, status, {}, snapshot.endedByBoard};
  const QString failure = inLanguage(status.failure);
  switch (status.state) {
    case Procedure::State::running:
      activity_->clear();  // the bar says what is being done, and how far it is
      break;
    case Procedure::State::finished:
      activity_->setText(doneText(snapshot.kind));
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
