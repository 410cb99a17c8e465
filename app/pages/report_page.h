// Report: what was measured or compared, as files to hand over.
#pragma once

#include "base/result.h"
#include "pages/page.h"
#include "widgets/file_chooser.h"

class QLabel;
class QPushButton;

namespace breakaway {

class BenchRuns;
class Comparison;
class Messages;

class ReportPage : public Page {
  Q_OBJECT

 public:
  ReportPage(const BenchRuns& bench, const Comparison& comparison, Messages& messages, FileChooser& files,
             QWidget* parent = nullptr);

 private:
  void showFriction();
  void showComparison();
  void writeFriction();
  void writeComparison();
  void written(const Result<void>& result, const QString& report);

  const BenchRuns& bench_;
  const Comparison& comparison_;
  Messages& messages_;
  FileChooser& files_;
  QLabel* frictionHolds_ = nullptr;
  QLabel* comparisonHolds_ = nullptr;
  QPushButton* friction_ = nullptr;
  QPushButton* compared_ = nullptr;
  QPushButton* open_ = nullptr;
  QString last_;
};

}  // namespace breakaway
