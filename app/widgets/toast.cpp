#include "widgets/toast.h"

#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "session/messages.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/look.h"

namespace breakaway {

namespace {
constexpr int railWidth = 168, margin = 16, room_px = 28, height_px = 32, shown_ms = 5000;
}  // namespace

Toast::Toast(Messages& messages, QWidget* parent) : QWidget(parent) {
  setObjectName("toast");
  setToolTip(tr("Opens the log"));
  setFixedHeight(height_px);
  auto* row = rowIn(this, 0, {12, 0, 12, 0});
  text_ = new ElidedLabel("messageLine", this);
  text_->setAccessibleName(tr("Last message"));
  text_->setAttribute(Qt::WA_TransparentForMouseEvents);
  text_->setAlignment(Qt::AlignVCenter);
  row->addWidget(text_);
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
  const QSize room = parentWidget()->size();
  const int whole = text_->fontMetrics().horizontalAdvance(text_->text()) + room_px;
  setFixedWidth(std::min(room.width() - railWidth - 2 * margin, whole));
  move(room.width() - width() - margin, room.height() - below_px_ - height() - 8);
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
