// The steps of Tune as a table: what is foretold, and what was measured, the newest on top.
#pragma once

#include <QTableWidget>
#include <vector>

#include "base/axis.h"
#include "session/run.h"

namespace breakaway {

/// "35.4" of 0.0354 s; words where it was not reached.
QString milliseconds(double time_s);
/// Of a part of the step, to a thousandth of a percent: below that is arithmetic.
QString overshootPercent(double part);

class StepTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit StepTable(QWidget* parent = nullptr);
  /// One row a step, all of the velocity loop or all of the position loop; `foretold` above them, if there is any.
  void show(const std::vector<StepResult>& steps, const StepResult* foretold, bool position, Axis axis);
  /// With the gains of each step, or without where there is no room.
  void setWhole(bool whole);

 private:
  void wordFor(bool position, Axis axis);
  void fill(int row, const QString& name, const StepResult& step, bool position, const QColor& ink);
};

}  // namespace breakaway
