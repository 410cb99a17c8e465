#include "widgets/while_shown.h"

#include <QEvent>
#include <utility>

namespace breakaway {

WhileShown::WhileShown(QWidget* widget, std::chrono::milliseconds every, std::function<void()> show)
    : QObject(widget), show_(std::move(show)) {
  timer_.setInterval(every);
  connect(&timer_, &QTimer::timeout, this, [this] { show_(); });
  widget->installEventFilter(this);
}

bool WhileShown::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Hide) timer_.stop();
  if (event->type() == QEvent::Show) {
    timer_.start();
    // Once what else comes of being shown is done.
    QTimer::singleShot(0, this, [this] { show_(); });
  }
  return false;
}

}  // namespace breakaway
