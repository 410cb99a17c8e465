// Where a page stands: it gets the room that it asks for, or, while something stands beside it, scrolls in what is
// left.
#pragma once

#include <QScrollArea>

namespace breakaway {

class PageRoom : public QScrollArea {
  Q_OBJECT

 public:
  explicit PageRoom(QWidget* page, QWidget* parent = nullptr);
  void setScrolls(bool scrolls);
  /// How narrow the page that is shown may become before it scrolls.
  void setLeast(int width_px);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool scrolls_ = false;
  int least_px_ = 0;
};

}  // namespace breakaway
