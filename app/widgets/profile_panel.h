// A profile beside the board: what differs, which of it to give back, and what the board accepted.
#pragma once

#include <QWidget>

#include "session/profile_comparison.h"
#include "widgets/file_chooser.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace breakaway {

class ProfilePanel : public QWidget {
  Q_OBJECT

 public:
  ProfilePanel(const Connection& connection, ProfileComparison& profile, FileChooser& files, QWidget* parent = nullptr);

 private:
  void fill();
  void showBoard();
  void fillBoard();
  void fillDifferences();
  void showAvailable();
  QStringList ticked() const;

  const Connection& connection_;
  ProfileComparison& profile_;
  FileChooser& files_;
  QPushButton* save_ = nullptr;
  QPushButton* open_ = nullptr;
  QPushButton* restore_ = nullptr;
  QLabel* source_ = nullptr;
  QTableWidget* table_ = nullptr;
};

}  // namespace breakaway
