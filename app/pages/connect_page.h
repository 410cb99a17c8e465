// Connect: which board, how the connection stands, what the board says of itself, and its profile.
#pragma once

#include "pages/page.h"
#include "widgets/file_chooser.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace breakaway {

class BenchRuns;
class BoardList;
class Connection;
class FactsTable;
class ProfileComparison;

class ConnectPage : public Page {
  Q_OBJECT

 public:
  ConnectPage(Connection& connection, BenchRuns& bench, ProfileComparison& profile, FileChooser& files,
              QWidget* parent = nullptr);

 private:
  QWidget* buildBoards();
  QWidget* buildIdentity();
  QWidget* buildMotion();
  QWidget* buildProfile();
  StepState railState() const;
  void connectChosen();
  void openRig();
  /// Goes to a page, with a simulated board where that needs one.
  void tryOut(const QString& page, bool needsBoard);
  /// What follows once a board is connected.
  QString nextPage() const;
  void showConnection();
  void showNext();
  void showState();
  void showIdentity();
  void showMotion();

  Connection& connection_;
  BenchRuns& bench_;
  ProfileComparison& profile_;
  FileChooser& files_;
  BoardList* boards_ = nullptr;
  QLineEdit* address_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* cannot_ = nullptr;
  QPushButton* connect_ = nullptr;
  QPushButton* goOn_ = nullptr;
  QPushButton* disconnect_ = nullptr;
  QPushButton* turn_ = nullptr;
  QComboBox* pace_ = nullptr;
  QWidget* welcome_ = nullptr;  ///< as long as there is no board
  QWidget* board_ = nullptr;    ///< what is told of it
  FactsTable* facts_ = nullptr;
  FactsTable* controller_ = nullptr;
};

}  // namespace breakaway
