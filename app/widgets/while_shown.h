// What is done again and again as long as a widget is seen, and costs nothing else.
#pragma once

#include <QTimer>
#include <QWidget>
#include <chrono>
#include <functional>

namespace breakaway {

/// Calls `show` at once when `widget` comes into sight, and then every `every`.
class WhileShown : public QObject {
 public:
  WhileShown(QWidget* widget, std::chrono::milliseconds every, std::function<void()> show);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::function<void()> show_;
  QTimer timer_;
};

}  // namespace breakaway
