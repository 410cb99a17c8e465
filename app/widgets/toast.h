// The last thing that was said, for a few seconds; what failed stays until it is clicked. It lies over the foot of the
// page's settings, as wide as these, so that nothing moves and neither a curve nor what is read off it is hidden.
#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;

namespace breakaway {

class Messages;

class Toast : public QWidget {
  Q_OBJECT

 public:
  Toast(Messages& messages, QWidget* parent);
  /// To its place in the parent.
  void place();
  /// How much of the parent, at its lower edge, isn't the page's.
  void keepAbove(int below_px);

 signals:
  void clicked();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void take(const QString& text, bool trouble);

  QLabel* text_ = nullptr;
  bool trouble_ = false;
  int below_px_ = 0;
  QTimer timer_;
};

}  // namespace breakaway
