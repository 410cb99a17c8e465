// Runs: what the project keeps, found again, named, opened, compared and written out.
#pragma once

#include <vector>

#include "pages/page.h"
#include "project/run.h"
#include "widgets/file_chooser.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace breakaway {

class BenchProject;
class Comparison;
class ElidedLabel;
class FactsTable;
class ProjectRuns;
class RunComparisonPanel;
class RunsTable;
class ShownMaps;
struct KeptRun;
struct RunComparison;

class RunsPage : public Page {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  RunsPage(BenchProject& project, ProjectRuns& runs, ShownMaps& maps, Comparison& comparison, FileChooser& files,
           QWidget* parent = nullptr);
  bool isTool() const override { return true; }
  bool wantsLive() const override { return false; }

  /// The comparison that is shown, if one is.
  QVariant kept() const;
  void take(const QVariant& kept);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildFind();
  QWidget* buildChosen();
  void find();
  void showList();
  void offer(QComboBox& box, const std::vector<std::string>& names, QString (*inWords)(const std::string&));
  void showChosen();
  void showRun(const KeptRun& kept);
  void showButtons();
  void open();
  void openReport();
  void layBeneath();
  void saveCsv();
  void compareChosen();
  void showComparison(const RunComparison& comparison);

  BenchProject& project_;
  ProjectRuns& runs_;
  ShownMaps& maps_;
  Comparison& comparison_;
  FileChooser& files_;
  QLineEdit* text_ = nullptr;
  QComboBox* motor_ = nullptr;
  QComboBox* kind_ = nullptr;
  QLabel* count_ = nullptr;
  RunsTable* table_ = nullptr;
  RunComparisonPanel* compared_ = nullptr;
  ElidedLabel* title_ = nullptr;
  FactsTable* values_ = nullptr;
  QLabel* findings_ = nullptr;
  QPushButton* open_ = nullptr;
  QPushButton* compare_ = nullptr;
  QPushButton* report_ = nullptr;
  QPushButton* csv_ = nullptr;
  QPushButton* beneath_ = nullptr;
  std::vector<ProjectRun> chosen_;  ///< with its files, once they are read, where it is one
  bool read_ = false;
};

}  // namespace breakaway
