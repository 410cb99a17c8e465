// The board's settings beside every page: what the board has, what is edited, what it had at first and what a profile
// holds. Edits are shared with Tune; nothing is sent before Apply.
#pragma once

#include <QTimer>
#include <QWidget>
#include <set>
#include <vector>

#include "session/settings_edits.h"
#include "widgets/file_chooser.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace breakaway {

class ElidedLabel;

class ParametersDock : public QWidget {
  Q_OBJECT

 public:
  /// Narrow in a narrow window, so that the page beside it can be used: without what the board had at first, the
  /// ranges, which stand under the table for the chosen row, and the profile as long as none is open.
  void fitIn(int window_px);

  ParametersDock(Connection& connection, SettingsEdits& edits, FileChooser& files, QWidget* parent = nullptr);

 signals:
  void closed();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildHead();
  QWidget* buildTools();
  QWidget* buildFoot();
  void buildTable();
  void fill();
  void fillRow(int row);
  void takeCell(int row, int column);
  void takeText(int row, const QString& text);
  void tick(int row, bool ticked);
  void toggle(int row);
  bool canTick(int row) const;
  /// The settings that are ticked and can be.
  std::vector<SettingsEdits::Setting> ticked() const;
  void showColumns();
  void showAvailable();
  void explain(const QString& trouble = {});
  QString obstacle() const;
  SettingsEdits::Setting settingOf(int row) const;

  Connection& connection_;
  SettingsEdits& edits_;
  FileChooser& files_;
  bool narrow_ = true;
  std::set<int> unticked_;  ///< rows that somebody has taken the tick from
  QTableWidget* table_ = nullptr;
  QTimer rowsSoon_;  ///< are made as high as their text
  QPushButton* undo_ = nullptr;
  QPushButton* redo_ = nullptr;
  QPushButton* revert_ = nullptr;
  QPushButton* revertAll_ = nullptr;
  QPushButton* open_ = nullptr;
  QPushButton* take_ = nullptr;
  QPushButton* apply_ = nullptr;
  ElidedLabel* source_ = nullptr;
  QLabel* note_ = nullptr;
};

}  // namespace breakaway
