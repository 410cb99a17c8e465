// How far a procedure is, what it does now, and how it ended, in words: its progress bar is the board bar's.
#pragma once

#include <QVariant>
#include <QWidget>
#include <vector>

#include "session/run.h"

class QLabel;

namespace breakaway {

class RunPanel : public QWidget {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  /// Shows runs of these kinds only; others leave it as it is.
  RunPanel(const char* objectName, std::vector<RunKind> kinds, QWidget* parent = nullptr);

  void show(const RunSnapshot& snapshot);
  /// Of how a run ended; while one runs the bar says what it does.
  bool saysSomething() const;
  using QWidget::show;

  /// How far what is shown has come.
  QVariant kept() const { return QVariant::fromValue(shown_); }
  void take(const QVariant& kept) { show(kept.value<RunSnapshot>()); }

 private:
  std::vector<RunKind> kinds_;
  RunSnapshot shown_;  ///< without its result
  QLabel* activity_ = nullptr;
};

}  // namespace breakaway
