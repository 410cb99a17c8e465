// One figure of a tuning against what is asked of it: green, amber or red, and in words.
#pragma once

#include <QFrame>

class QLabel;

namespace breakaway {

class FigureChip : public QFrame {
  Q_OBJECT

 public:
  FigureChip(const char* objectName, const QString& title, QWidget* parent);
  /// `tone`: "good", "warning", "trouble" or empty; `rule`: what is asked of it.
  void show(const QString& value, const QString& rule, const QString& tone);
  using QWidget::show;
  QString value() const;
  QString tone() const { return property("tone").toString(); }

 private:
  QLabel* title_ = nullptr;
  QLabel* rule_ = nullptr;
  QLabel* value_ = nullptr;
};

}  // namespace breakaway
