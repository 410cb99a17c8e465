// How far a procedure is: progress, remaining time, what it does now, and how it ended, in words.
#pragma once

#include <QWidget>
#include <vector>

#include "session/run.h"

class QLabel;
class QProgressBar;

namespace breakaway {

class RunPanel : public QWidget {
  Q_OBJECT

 public:
  /// Shows runs of these kinds only; others leave it as it is.
  RunPanel(const char* objectName, std::vector<RunKind> kinds, QWidget* parent = nullptr);

  void show(const RunSnapshot& snapshot);
  using QWidget::show;

 private:
  std::vector<RunKind> kinds_;
  QProgressBar* bar_ = nullptr;
  QLabel* activity_ = nullptr;
};

}  // namespace breakaway
