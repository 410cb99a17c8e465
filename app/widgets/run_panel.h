// How far a procedure is, what it does now, and how it ended, in words: its progress bar is the board bar's.
#pragma once

#include <QVariant>
#include <QWidget>
#include <map>
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

  /// Once a run of this kind is done, that page is named as what comes next.
  void leadOn(RunKind done, const QString& page, const QString& title);

  void show(const RunSnapshot& snapshot);
  /// Of how a run ended; while one runs the bar says what it does.
  bool saysSomething() const;
  using QWidget::show;

  /// How far what is shown has come.
  QVariant kept() const { return QVariant::fromValue(shown_); }
  void take(const QVariant& kept) { show(kept.value<RunSnapshot>()); }

 signals:
  void pageAsked(const QString& objectName);

 private:
  QString doneText(RunKind kind) const;

  std::vector<RunKind> kinds_;
  std::map<RunKind, QString> next_;  ///< a link to its page
  RunSnapshot shown_;                ///< without its result
  QLabel* activity_ = nullptr;
};

}  // namespace breakaway
