// Compare: a recording against what its bench declares: where they part, which physics is missing, and the proof.
#pragma once

#include "pages/page.h"
#include "widgets/file_chooser.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace breakaway {

class BenchRuns;
class Comparison;
class FactsTable;
class FindingsList;
class LiveSamples;
class ResidualPlots;

class ComparePage : public Page {
  Q_OBJECT

 public:
  ComparePage(const BenchRuns& bench, const LiveSamples& live, Comparison& comparison, FileChooser& files,
              QWidget* parent = nullptr);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* buildInputs();
  QWidget* buildPlots();
  QWidget* buildVerdict();
  void ask(const QString& title, const QString& filter, const FileChooser::Answer& open);
  void openExample();
  void takeLive();
  void showInputs();
  void showProgress();
  void showProof();

  const BenchRuns& bench_;
  const LiveSamples& live_;
  Comparison& comparison_;
  FileChooser& files_;
  QPushButton* openBench_ = nullptr;
  QPushButton* openRecording_ = nullptr;
  QPushButton* openHeldout_ = nullptr;
  QPushButton* openExample_ = nullptr;
  QPushButton* takeLive_ = nullptr;
  QPushButton* diagnose_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* activity_ = nullptr;
  QComboBox* axis_ = nullptr;
  ResidualPlots* plots_ = nullptr;
  FactsTable* proof_ = nullptr;
  FindingsList* findings_ = nullptr;
};

}  // namespace breakaway
