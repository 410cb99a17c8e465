// What was said so far, with its time: opened by whoever wants to read it. New lines are counted on the button that
// opens it, and the last one is shown above the live strip for a while.
#pragma once

#include <QWidget>

#include "session/messages.h"

class QPushButton;
class QTableWidget;

namespace breakaway {

class LogDrawer : public QWidget {
  Q_OBJECT

 public:
  explicit LogDrawer(Messages& messages, QWidget* parent = nullptr);
  /// Chooses the newest line of this text, so that all of it can be read.
  void showLine(const QString& text);

 signals:
  void closed();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void take();
  void addOnTop(const Messages::Line& line);
  void fill();
  void copy() const;
  void unfold(int row, int before);

  Messages& messages_;
  QTableWidget* table_ = nullptr;
  QPushButton* troubleOnly_ = nullptr;
};

}  // namespace breakaway
