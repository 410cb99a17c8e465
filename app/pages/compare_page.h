// Compare: a recording against what its bench declares: where they part, which physics is missing, and the proof.
#pragma once

#include "pages/page.h"
#include "widgets/file_chooser.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace breakaway {

class Comparison;
class FactsTable;
class FindingsList;
class ResidualPlots;
class Session;

class ComparePage : public Page {
  Q_OBJECT

 public:
  ComparePage(Session& session, Comparison& comparison, FileChooser& files, QWidget* parent = nullptr);

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

  Session& session_;
  Comparison& comparison_;
  FileChooser& files_;
  QPushButton* bench_ = nullptr;
  QPushButton* recording_ = nullptr;
  QPushButton* heldout_ = nullptr;
  QPushButton* example_ = nullptr;
  QPushButton* live_ = nullptr;
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
