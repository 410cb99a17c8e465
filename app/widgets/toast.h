// The last thing that was said, for a few seconds; what failed stays until it is clicked. It stands below the steps of
// the rail, where nothing else is, so that it hides nothing and nothing moves.
#pragma once

#include <QRect>
#include <QTimer>
#include <QWidget>

class QLabel;

namespace breakaway {

class Messages;

class Toast : public QWidget {
  Q_OBJECT

 public:
  Toast(Messages& messages, QWidget* parent);
  /// Where in the parent it may stand; it keeps to the lower edge and elides what has no room.
  void keepIn(const QRect& room);

 signals:
  void clicked(const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void take(const QString& text, bool trouble);
  void place();

  QLabel* text_ = nullptr;
  bool trouble_ = false;
  QRect room_;
  QTimer timer_;
};

}  // namespace breakaway
