// What has changed between two runs, in words: what lies beyond the intervals first.
#pragma once

#include <QWidget>
#include <optional>

#include "report/run_comparison.h"
#include "session/messages.h"
#include "widgets/file_chooser.h"

class QPushButton;
class QTextBrowser;

namespace breakaway {

class ElidedLabel;

class RunComparisonPanel : public QWidget {
  Q_OBJECT

 public:
  RunComparisonPanel(FileChooser& files, QWidget* parent = nullptr);
  void show(const RunComparison& comparison);
  using QWidget::show;
  /// What is shown.
  const std::optional<RunComparison>& comparison() const { return comparison_; }

 signals:
  void closed();
  /// The comparison's report is wanted in this folder.
  void reportAsked(const breakaway::RunComparison& comparison, const QString& folder);

 private:
  FileChooser& files_;
  std::optional<RunComparison> comparison_;
  ElidedLabel* title_ = nullptr;
  QTextBrowser* words_ = nullptr;
};

}  // namespace breakaway
