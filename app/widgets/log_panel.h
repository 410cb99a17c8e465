// A log as it is understood, column by column, to be corrected by a click before it is opened as a recording.
#pragma once

#include <QWidget>
#include <vector>

#include "session/log_opening.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace breakaway {

class LogPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LogPanel(LogOpening& log, QWidget* parent = nullptr);

 private:
  struct Number {
    std::optional<double> ImportMap::*number;
    QLineEdit* edit;
  };

  QWidget* buildNumbers();
  QWidget* buildSplit();
  void fillSplit();
  QWidget* buildButtons();
  void fill();
  void showRow(int row, const LogColumn& column);
  QComboBox* choice(int row, int cell, const char* what, const QStringList& choices);
  void correct(int row);

  LogOpening& log_;
  QLabel* title_ = nullptr;
  QLabel* state_ = nullptr;
  QTableWidget* table_ = nullptr;
  std::vector<Number> numbers_;
  QComboBox* split_ = nullptr;
  QComboBox* part_ = nullptr;
  QPushButton* open_ = nullptr;
};

}  // namespace breakaway
