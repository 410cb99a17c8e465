// Scrolls what has no room, and takes no more height than that: what is left over is its neighbours'.
#pragma once

#include <QScrollArea>

namespace breakaway {

class FittedScroll : public QScrollArea {
 public:
  FittedScroll(const char* objectName, QWidget* parent);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();
};

}  // namespace breakaway
