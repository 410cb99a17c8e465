#include "widgets/toast.h"

#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QTextLayout>
#include <algorithm>
#include <cmath>

#include "session/messages.h"
#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr int shown_ms = 5000;
constexpr int sides_px = 8, ends_px = 4, leastHeight_px = 40;

/// Text over several lines, its end elided where there isn't room for it.
class WrappedWords : public QLabel {
 public:
  using QLabel::QLabel;

  int heightForWidth(int width_px) const override { return heightOf(text(), width_px); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QTextLayout lines(whatFits(), font());
    layOut(lines, width());
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    lines.draw(&painter, QPointF(0.0, 0.0));
  }

 private:
  /// Between words, within one only where it is longer than a line, as a path is. Returns the height.
  static int layOut(QTextLayout& lines, int width_px) {
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    lines.setTextOption(option);
    lines.beginLayout();
    double height_px = 0.0;
    for (QTextLine line = lines.createLine(); line.isValid(); line = lines.createLine()) {
      line.setLineWidth(width_px);
      line.setPosition(QPointF(0.0, height_px));
      height_px += line.height();
    }
    lines.endLayout();
    return static_cast<int>(std::ceil(height_px));
  }

  int heightOf(const QString& text, int width_px) const {
    QTextLayout lines(text, font());
    return layOut(lines, width_px);
  }

  QString whatFits() const {
    QString all = text();
    if (heightOf(all, width()) <= height()) return all;
    qsizetype fits = 0, tooLong = all.size();
    while (fits + 1 < tooLong) {
      const qsizetype middle = (fits + tooLong) / 2;
      (heightOf(all.left(middle) + "…", width()) <= height() ? fits : tooLong) = middle;
    }
    return all.left(fits) + "…";
  }
};

}  // namespace

Toast::Toast(Messages& messages, QWidget* parent) : QWidget(parent) {
  setObjectName("toast");
  setToolTip(tr("Opens the log"));
  text_ = new WrappedWords(this);
  text_->setObjectName("messageLine");
  text_->setFont(typed(Type::caption));
  text_->setWordWrap(true);
  text_->setAccessibleName(tr("Last message"));
  text_->setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &QWidget::hide);
  connect(&messages, &Messages::said, this, &Toast::take);
  if (const Messages::Line* trouble = messages.unreadTrouble(); trouble != nullptr) take(trouble->text, true);
}

void Toast::take(const QString& text, bool trouble) {
  trouble_ = trouble;
  text_->setText(text);
  setToolTip(tr("%1\nClick: shows it in the log").arg(text));
  dressAs(text_, "tone", trouble ? "trouble" : QString());
  place();
  show();
  raise();
  update();
  trouble ? timer_.stop() : timer_.start(shown_ms);
}

void Toast::place() {
  if (text_->text().isEmpty()) return;
  const int inner_px = room_.width() - 2 * sides_px;
  const int wanted_px = text_->heightForWidth(inner_px) + 2 * ends_px;
  const int height_px = std::min(wanted_px, std::max(room_.height(), leastHeight_px));
  setGeometry(room_.left(), room_.bottom() + 1 - height_px, room_.width(), height_px);
  text_->setGeometry(sides_px, ends_px, inner_px, height_px - 2 * ends_px);
}

void Toast::keepIn(const QRect& room) {
  room_ = room;
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
  emit clicked(text_->text());
}

}  // namespace breakaway
