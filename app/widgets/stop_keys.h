// Esc and Space stop the motor from anywhere in the program, whatever has the focus.
#pragma once

#include <QObject>
#include <functional>

namespace breakaway {

/// A filter on the whole application. Space is left to a widget in which text is typed; Esc always stops, and goes on
/// to a menu or a dialog so that it closes too. Since Space no longer presses a focused button, Return does.
class StopKeys : public QObject {
 public:
  StopKeys(std::function<void()> stop, QObject* parent);
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::function<void()> stop_;
};

}  // namespace breakaway
