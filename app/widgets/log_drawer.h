// What was said so far, with its time: opened by whoever wants to read it. New lines are counted on the button that
// opens it, and the last one is shown above the live strip for a while.
#pragma once

#include <QWidget>
#include <deque>

class QPushButton;
class QTableWidget;

namespace breakaway {

class Messages;

class LogDrawer : public QWidget {
  Q_OBJECT

 public:
  struct Line {
    QString time, text;
    bool trouble = false;
  };

  explicit LogDrawer(Messages& messages, QWidget* parent = nullptr);
  const std::deque<Line>& lines() const { return lines_; }
  /// Since it was open last.
  size_t unread() const { return unread_; }
  bool unreadTrouble() const { return unreadTrouble_; }

 signals:
  void closed();
  void changed();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void take(const QString& text, bool trouble);
  void addOnTop(const Line& line);
  void fill();
  void copy() const;

  std::deque<Line> lines_;
  size_t unread_ = 0;
  bool unreadTrouble_ = false;
  QTableWidget* table_ = nullptr;
  QPushButton* troubleOnly_ = nullptr;
};

}  // namespace breakaway
