// The runs of a project as a table: the newest first, names and remarks written in place.
#pragma once

#include <QTableView>
#include <QVariant>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "project/run.h"

namespace breakaway {

class RunsTable : public QTableView {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  enum Column { atColumn, kindColumn, motorColumn, deviceColumn, nameColumn, resultColumn, remarkColumn };

  explicit RunsTable(QWidget* parent = nullptr);
  ~RunsTable() override;
  /// What was chosen stays so, as far as it is there.
  /// `instead` stands there while there are none.
  void show(const std::vector<ProjectRun>& runs, const QString& instead);
  using QWidget::show;
  /// The runs that are chosen, from the top down.
  std::vector<ProjectRun> chosen() const;
  /// Chooses the run with this identifier alone, if it is listed.
  void choose(const std::string& id);

  /// Which runs are chosen.
  QVariant kept() const;
  void take(const QVariant& kept);

 signals:
  void chosenChanged();
  /// By Enter or a double click on what isn't written in place.
  void opened();
  void renamed(const std::string& id, const QString& name);
  void remarked(const std::string& id, const QString& remark);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  class Model;
  void select(const QStringList& ids);
  void shareOutWidth();

  Model* model_ = nullptr;
  QString instead_;
  bool filling_ = false;
  std::array<std::optional<bool>, remarkColumn + 1> columnHasText_;
};

}  // namespace breakaway
