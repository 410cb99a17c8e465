#include "widgets/step_table.h"

#include <QHeaderView>
#include <cmath>

#include "widgets/axis_units.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/setting_words.h"
#include "widgets/step_plot.h"
#include "widgets/table.h"

namespace breakaway {

namespace {

constexpr int mostHeight = 148, leastHeight = 84, columns = 8;

}  // namespace

QString milliseconds(double time_s) {
  return std::isfinite(time_s) ? numberText(1e3 * time_s) : StepTable::tr("not reached");
}

QString overshootPercent(double part) {
  return numberText(1e-3 * std::round(1e5 * part), 2);
}

StepTable::StepTable(QWidget* parent) : QTableWidget(parent) {
  dressAsReadTable(*this, "stepTable", tr("Measured steps"), QStringList(columns, QString()));
  setToolTip(tr("What is foretold, and the measured steps, the newest on top; settling to 5 %"));
  setFont(typed(Type::caption));
  setMinimumHeight(leastHeight);
  setMaximumHeight(mostHeight);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  setHorizontalHeaderLabels(
      {tr("Step"), tr("Kp"), tr("Ki"), tr("g"), tr("Rise\nms"), tr("Over\n%"), tr("Settle\nms"), tr("Peak\nA")});
}

void StepTable::setWhole(bool whole) {
  for (const int column : {1, 2, 3}) setColumnHidden(column, !whole);
}

void StepTable::show(const std::vector<StepResult>& steps, const StepResult* foretold, bool position, Axis axis) {
  const Look& look = Look::of(palette());
  setRowCount(static_cast<int>(steps.size()) + (foretold != nullptr ? 1 : 0));
  int row = 0;
  if (foretold != nullptr) fill(row++, tr("Foretold"), *foretold, position, look.curve(0));
  for (size_t k = steps.size(); k-- > 0;)
    fill(row++, tr("Step %1").arg(k + 1), steps[k], position,
         k >= StepPlot::firstDrawn(steps.size()) ? look.curve(StepPlot::colourOf(k)) : look.ink);
  wordFor(position, axis);
}

void StepTable::fill(int row, const QString& name, const StepResult& step, bool position, const QColor& ink) {
  const ControllerSettings& with = step.settings;
  fillRow(*this, row,
          {name, numberText(position ? with.position_kp_A_per_rad : with.velocity_kp_A_s_per_rad),
           numberText(position ? with.position_ki_A_per_rad_s : with.velocity_ki_A_per_rad),
           numberText(with.observer_cutoff_rad_per_s), milliseconds(step.figures.rise_s),
           overshootPercent(step.figures.overshoot), milliseconds(step.figures.settling_s),
           numberText(step.figures.peakCurrent_A)});
  item(row, 0)->setForeground(ink);
  item(row, 0)->setFont(typed(Type::caption, true));
}

void StepTable::wordFor(bool position, Axis axis) {
  const AxisUnits units = unitsOf(axis);
  const QString meanings[] = {
      tr("Foretold, or which measured one"),
      tr("Proportional gain (%1)").arg(position ? units.integral : units.gain),
      tr("Integral gain (%1)")
          .arg(position ? settingWords(&ControllerSettings::position_ki_A_per_rad_s, axis).unit : units.integral),
      tr("Cutoff of the disturbance observer (rad/s)"),
      tr("Time from 10 to 90 % of the step"),
      tr("Overshoot beyond the end, part of the step"),
      tr("Time until it stays within 5 % of the step"),
      tr("Highest current")};
  for (int column = 0; column < columnCount(); ++column) horizontalHeaderItem(column)->setToolTip(meanings[column]);
}

}  // namespace breakaway
