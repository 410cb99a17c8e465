// Compare: a recording against what its bench declares: where they part, which physics is missing, and the proof.
#pragma once

#include <optional>
#include <vector>

#include "pages/page.h"
#include "recording/recording.h"
#include "widgets/file_chooser.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace breakaway {

class BenchProject;
class BenchRuns;
class ComparedPlots;
class Comparison;
class ExperimentRun;
class FactsTable;
class FileSlot;
struct Diagnosis;
struct Fact;
class FindingsList;
class LiveSamples;
class LogPanel;
class TrialRun;

class ComparePage : public Page {
  Q_OBJECT

 public:
  ComparePage(const BenchRuns& bench, const LiveSamples& live, Comparison& comparison, ExperimentRun& experiment,
              TrialRun& trial, BenchProject& project, FileChooser& files, QWidget* parent = nullptr);

  bool wantsLive() const override { return false; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildInputs();
  void buildBase();
  void buildFindings();
  static std::vector<Fact> baseFacts(const Diagnosis& diagnosis);
  void ask(const QString& title, const QString& filter, const FileChooser::Answer& open);
  void openExample();
  void takeLive();
  void showInputs();
  void showBeneath();
  void showTrial();
  void showExperiment();
  void showNext();
  void showProgress();
  void showProof();
  void showLog();
  std::optional<Recording> visible() const;
  void showKeep();
  void keepVisible();
  void showHint();
  void showState();

  const BenchRuns& bench_;
  BenchProject& project_;
  const LiveSamples& live_;
  Comparison& comparison_;
  ExperimentRun& experiment_;
  TrialRun& trial_;
  FileChooser& files_;
  FileSlot* openBench_ = nullptr;
  FileSlot* openRecording_ = nullptr;
  FileSlot* openHeldout_ = nullptr;
  FileSlot* openBeneath_ = nullptr;
  QToolButton* takeBeneathAway_ = nullptr;
  QPushButton* openExample_ = nullptr;
  QPushButton* sealedTrial_ = nullptr;
  QPushButton* runExperiment_ = nullptr;
  QPushButton* takeLive_ = nullptr;
  QPushButton* diagnose_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* finish_ = nullptr;
  QLabel* ticked_ = nullptr;
  ComparedPlots* plots_ = nullptr;
  LogPanel* log_ = nullptr;
  QWidget* compared_ = nullptr;  ///< plots and verdict, which give way to a log
  FactsTable* base_ = nullptr;
  FindingsList* findings_ = nullptr;
};

}  // namespace breakaway
