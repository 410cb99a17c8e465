// What is done again and again as long as a widget is seen, and costs nothing else.
#pragma once

#include <QTimer>
#include <QWidget>
#include <chrono>
#include <functional>

namespace breakaway {

/// Calls `show` at once when `widget` comes into sight, and then every `every`. `show` says whether there was anything
/// new: while there isn't for a while, it is called four times a second at most.
class WhileShown : public QObject {
 public:
  WhileShown(QWidget* widget, std::chrono::milliseconds every, std::function<bool()> show);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showNow();

  std::function<bool()> show_;
  std::chrono::milliseconds every_;
  int nothingNew_ = 0;  ///< times in a row
  QTimer timer_;
};

}  // namespace breakaway
