#include "widgets/live_cursors.h"

#include <qcustomplot.h>

#include <QKeyEvent>
#include <QMouseEvent>

#include "session/live_history.h"
#include "widgets/elided_label.h"
#include "widgets/look.h"
#include "widgets/number_text.h"

namespace breakaway {

namespace {

constexpr double reach_px = 6.0;       // within which a cursor is taken hold of
constexpr double keyStepPart = 0.005;  // of the view

QCPRange viewOf(const QCustomPlot& plot) {
  return plot.axisRect(0)->axis(QCPAxis::atBottom)->range();
}

}  // namespace

LiveCursors::LiveCursors(QCustomPlot& plot, const LiveHistory& history, ElidedLabel& difference)
    : QObject(&plot), plot_(plot), history_(history), difference_(difference) {
  plot_.installEventFilter(this);
}

void LiveCursors::addTo(QCPAxisRect& rect, QCPTextElement& readout) {
  for (TimeMark& mark : marks_) mark.addTo(rect);
  readouts_.push_back(&readout);
}

void LiveCursors::show(bool shown) {
  shown_ = shown;
  const QCPRange view = viewOf(plot_);
  marks_[0].moveTo(view.lower + 0.4 * view.size());
  marks_[1].moveTo(view.lower + 0.6 * view.size());
  for (TimeMark& mark : marks_) mark.show(shown);
  for (QCPTextElement* readout : readouts_) readout->setVisible(shown);
  if (shown) plot_.setFocus();
  changed();
}

void LiveCursors::moveTo(const std::array<double, 2>& times_s) {
  for (size_t which = 0; which < marks_.size(); ++which) marks_[which].moveTo(times_s[which]);
  changed();
}

void LiveCursors::shift(double by_s) {
  for (TimeMark& mark : marks_) mark.moveTo(mark.time_s() + by_s);
  write();
}

void LiveCursors::dress(const Look& look) {
  marks_[0].setPen(QPen(look.ink, 1));
  marks_[1].setPen(QPen(look.ink, 1, Qt::DashLine));
  for (QCPTextElement* readout : readouts_) {
    readout->setTextColor(look.ink);
    readout->setFont(typed(Type::caption));
  }
}

void LiveCursors::changed() {
  write();
  plot_.replot(QCustomPlot::rpQueuedReplot);
}

void LiveCursors::write() {
  const auto a = history_.nearest(marks_[0].time_s());
  const auto b = history_.nearest(marks_[1].time_s());
  difference_.setVisible(shown_ && a && b);
  if (!shown_ || !a || !b) return;
  const QString apart = tr("Δt %1 s").arg(fixedText(b->time_s - a->time_s, 4));
  difference_.setText(tr("%1   A %2 s   B %3 s").arg(apart).arg(fixedText(a->time_s, 4)).arg(fixedText(b->time_s, 4)));
  difference_.setShorter(apart);
  for (size_t k = 0; k < std::min(readouts_.size(), channels_.size()); ++k) {
    const auto text = [&](double value) { return fixedText(value, channels_[k].decimals); };
    const double atA = channels_[k].of(*a), atB = channels_[k].of(*b);
    readouts_[k]->setText(tr("A %1   B %2   Δy %3").arg(text(atA), text(atB), text(atB - atA)));
  }
}

bool LiveCursors::mouse(QEvent* event) {
  if (!shown_) return false;
  const QPointF at = static_cast<QMouseEvent*>(event)->position();
  if (event->type() == QEvent::MouseButtonRelease) {
    const bool was = dragged_ >= 0;
    dragged_ = -1;
    return was;
  }
  const QCPAxisRect* rect = plot_.axisRectAt(at);
  if (rect == nullptr) return false;
  const QCPAxis* time = rect->axis(QCPAxis::atBottom);
  if (event->type() == QEvent::MouseButtonPress) {
    for (size_t which = 0; which < marks_.size(); ++which) {
      if (std::abs(time->coordToPixel(marks_[which].time_s()) - at.x()) < reach_px) dragged_ = static_cast<int>(which);
    }
    return dragged_ >= 0;
  }
  if (dragged_ < 0) return false;
  marks_[static_cast<size_t>(dragged_)].moveTo(time->pixelToCoord(at.x()));
  changed();
  return true;
}

bool LiveCursors::key(int key, bool shift) {
  if (!shown_ || (key != Qt::Key_Left && key != Qt::Key_Right)) return false;
  TimeMark& mark = marks_[shift ? 1 : 0];
  mark.moveTo(mark.time_s() + (key == Qt::Key_Left ? -keyStepPart : keyStepPart) * viewOf(plot_).size());
  changed();
  return true;
}

bool LiveCursors::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &plot_) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
      return mouse(event);
    case QEvent::KeyPress: {
      const auto* pressed = static_cast<QKeyEvent*>(event);
      return key(pressed->key(), pressed->modifiers().testFlag(Qt::ShiftModifier));
    }
    default:
      return false;
  }
}

}  // namespace breakaway
