#include "widgets/toast.h"

#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "session/messages.h"
#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

namespace {
constexpr int left_px = 184, width_px = 324;  // of the settings, beside the rail
constexpr int shown_ms = 5000;
}  // namespace

Toast::Toast(Messages& messages, QWidget* parent) : QWidget(parent) {
  setObjectName("toast");
  setToolTip(tr("Opens the log"));
  setFixedWidth(width_px);
  text_ = new QLabel(this);
  text_->setObjectName("messageLine");
  text_->setWordWrap(true);
  text_->setAccessibleName(tr("Last message"));
  text_->setAttribute(Qt::WA_TransparentForMouseEvents);
  columnIn(this, 0, {12, 8, 12, 8})->addWidget(text_);
  hide();
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &QWidget::hide);
  connect(&messages, &Messages::said, this, &Toast::take);
  if (const Messages::Line* trouble = messages.unreadTrouble(); trouble != nullptr) take(trouble->text, true);
}

void Toast::take(const QString& text, bool trouble) {
  trouble_ = trouble;
  text_->setText(text);
  setToolTip(tr("%1\nOpens the log").arg(text));
  dressAs(text_, "tone", trouble ? "trouble" : QString());
  place();
  show();
  raise();
  update();
  trouble ? timer_.stop() : timer_.start(shown_ms);
}

void Toast::place() {
  if (text_->text().isEmpty()) return;
  setFixedHeight(layout()->heightForWidth(width_px));
  move(left_px, parentWidget()->height() - below_px_ - height() - 12);
}

void Toast::keepAbove(int below_px) {
  below_px_ = below_px;
  place();
}

void Toast::paintEvent(QPaintEvent*) {
  const Look& look = Look::of(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(trouble_ ? look.trouble : look.border, 1));
  painter.setBrush(trouble_ ? look.troubleBack : look.surface);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

void Toast::mousePressEvent(QMouseEvent*) {
  hide();
  emit clicked();
}

}  // namespace breakaway
