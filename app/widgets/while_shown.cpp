#include "widgets/while_shown.h"

#include <QEvent>
#include <algorithm>
#include <utility>

namespace breakaway {

namespace {
using namespace std::chrono_literals;
constexpr auto atRest = 250ms;
constexpr int untilRest = 10;  // times without anything new
}  // namespace

WhileShown::WhileShown(QWidget* widget, std::chrono::milliseconds every, std::function<bool()> show)
    : QObject(widget), show_(std::move(show)), every_(every) {
  timer_.setInterval(every_);
  connect(&timer_, &QTimer::timeout, this, &WhileShown::showNow);
  widget->installEventFilter(this);
}

bool WhileShown::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Hide) timer_.stop();
  if (event->type() == QEvent::Show) {
    timer_.start();
    // Once what else comes of being shown is done.
    QTimer::singleShot(0, this, &WhileShown::showNow);
  }
  return false;
}

void WhileShown::showNow() {
  nothingNew_ = show_() ? 0 : nothingNew_ + 1;
  const auto wanted = nothingNew_ < untilRest ? every_ : std::max<std::chrono::milliseconds>(every_, atRest);
  if (timer_.intervalAsDuration() != wanted) timer_.setInterval(wanted);
}

}  // namespace breakaway
