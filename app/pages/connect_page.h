// Connect: which board, and what it says of itself.
#pragma once

#include "pages/page.h"
#include "widgets/file_chooser.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace breakaway {

class FactsTable;
class Session;

class ConnectPage : public Page {
  Q_OBJECT

 public:
  ConnectPage(Session& session, FileChooser& files, QWidget* parent = nullptr);

 private:
  QWidget* buildBoards();
  QWidget* buildIdentity();
  void listPresets();
  void addBoard(const QString& name, const QString& uri);
  void connectChosen();
  void openRig();
  void showConnection();
  void showMotion();

  Session& session_;
  FileChooser& files_;
  QListWidget* boards_ = nullptr;
  QPushButton* connect_ = nullptr;
  QPushButton* disconnect_ = nullptr;
  QPushButton* turn_ = nullptr;
  QComboBox* pace_ = nullptr;
  FactsTable* facts_ = nullptr;
  FactsTable* controller_ = nullptr;
};

}  // namespace breakaway
