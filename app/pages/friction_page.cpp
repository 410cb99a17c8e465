#include "pages/friction_page.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "base/numbers.h"
#include "session/bench_runs.h"
#include "session/connection.h"
#include "session/messages.h"
#include "widgets/axis_units.h"
#include "widgets/controls.h"
#include "widgets/facts_table.h"
#include "widgets/map_export.h"
#include "widgets/map_panel.h"
#include "widgets/run_panel.h"

namespace breakaway {

namespace {

QString withInterval(const std::optional<Estimate>& estimate, double scale, const QString& unit, int decimals) {
  if (!estimate) return FrictionPage::tr("not measured");
  return FrictionPage::tr("%1 ± %2 %3")
      .arg(scale * estimate->value, 0, 'f', decimals)
      .arg(normal95 * scale * estimate->standardError, 0, 'f', decimals)
      .arg(unit);
}

QSpinBox* countBox(QWidget* parent, const char* objectName, const QString& name, int least, int most, int value) {
  auto* box = new QSpinBox(parent);
  box->setObjectName(objectName);
  box->setAccessibleName(name);
  box->setRange(least, most);
  box->setValue(value);
  box->setAlignment(Qt::AlignRight);
  return box;
}

QDoubleSpinBox* numberBox(QWidget* parent, const char* objectName, const QString& name, double least, double most,
                          double value, const QString& suffix) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(objectName);
  box->setAccessibleName(name);
  box->setRange(least, most);
  box->setDecimals(1);
  box->setValue(value);
  box->setSuffix(suffix);
  box->setAlignment(Qt::AlignRight);
  return box;
}

}  // namespace

FrictionPage::FrictionPage(Connection& connection, BenchRuns& bench, Messages& messages, FileChooser& files,
                           QWidget* parent)
    : Page("frictionPage", tr("Friction"), "friction", parent),
      connection_(connection),
      bench_(bench),
      messages_(messages),
      files_(files) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 10, 16, 6);
  row->setSpacing(20);
  map_ = new MapPanel(this);
  row->addWidget(buildControls());
  row->addWidget(map_, 1);
  connect(&connection_, &Connection::changed, this, &FrictionPage::showConnection);
  connect(&connection_, &Connection::runChanged, this, &FrictionPage::showMotion);
  connect(&bench_, &BenchRuns::measured, this, &FrictionPage::showMotion);
  connect(&bench_, &BenchRuns::knownChanged, this, &FrictionPage::showKnown);
  showConnection();
  showKnown();
}

QWidget* FrictionPage::buildControls() {
  auto* side = new QWidget(this);
  side->setFixedWidth(336);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  title_ = heading(side, {});
  column->addWidget(title_);
  column->addWidget(buildVelocityGroup());
  column->addWidget(buildBreakawayGroup());
  run_ = new RunPanel("frictionRun", {RunKind::velocitySweep, RunKind::breakaway, RunKind::trial}, side);
  column->addWidget(run_);
  column->addWidget(rule(side));
  averages_ = new FactsTable("frictionAverages", side);
  column->addWidget(averages_);
  column->addStretch(1);
  column->addWidget(new MapExport(bench_, messages_, files_, *map_, side));
  return side;
}

QWidget* FrictionPage::buildVelocityGroup() {
  auto* group = new QWidget(this);
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  highest_ = numberBox(group, "highestSpeed", tr("Highest speed"), 0.0, 2000.0, 0.0, {});
  highest_->setSpecialValueText(tr("As fast as it can"));
  speeds_ = countBox(group, "speedCount", tr("Number of speeds"), 2, 12, 6);
  speeds_->setSuffix(tr(" speeds"));
  duration_ =
      numberBox(group, "speedDuration", tr("Time at each speed"), 0.5, 120.0, SweepSettings{}.speedRun_s, tr(" s"));
  row->addWidget(highest_, 3);
  row->addWidget(speeds_, 3);
  row->addWidget(duration_, 2);
  velocity_ = pushButton(group, "velocitySweepButton", tr("Run velocity sweep"));
  speedsCaption_ = caption(group, {});
  column->addWidget(speedsCaption_);
  column->addLayout(row);
  column->addWidget(velocity_);
  connect(velocity_, &QPushButton::clicked, this, [this] { bench_.make(RunKind::velocitySweep, sweeps()); });
  return group;
}

QWidget* FrictionPage::buildBreakawayGroup() {
  auto* group = new QWidget(this);
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(4);
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  bins_ = countBox(group, "bins", tr("Angles per turn"), 8, 720, SweepSettings{}.bins);
  turns_ = countBox(group, "turns", tr("Turns each way"), 1, 10, 2);
  row->addWidget(bins_, 1);
  row->addWidget(turns_, 1);
  breakaway_ = pushButton(group, "breakawaySweepButton", tr("Run breakaway sweep"));
  column->addWidget(caption(group, tr("Breakaway from standstill at")));
  column->addLayout(row);
  column->addWidget(breakaway_);
  trial_ = pushButton(group, "tryMapButton", tr("Tune and try the map"));
  column->addWidget(trial_);
  for (const QSpinBox* box : {bins_, turns_, speeds_})
    connect(box, &QSpinBox::valueChanged, this, &FrictionPage::showMotion);
  for (const QDoubleSpinBox* box : {highest_, duration_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &FrictionPage::showMotion);
  connect(breakaway_, &QPushButton::clicked, this, [this] { bench_.make(RunKind::breakaway, sweeps()); });
  connect(trial_, &QPushButton::clicked, this, [this] { bench_.make(RunKind::trial, sweeps()); });
  return group;
}

void FrictionPage::showConnection() {
  const Axis axis = connection_.identity().axis;
  if (axis != worded_) axis == Axis::linear ? wordForTravel() : wordForRotor();
  worded_ = axis;
  showMotion();
}

void FrictionPage::wordForRotor() {
  title_->setText(tr("Friction around the rotor"));
  speedsCaption_->setText(tr("Constant speeds up to"));
  highest_->setDecimals(1);
  highest_->setRange(0.0, 2000.0);
  highest_->setSingleStep(1.0);
  highest_->setSuffix(tr(" rad/s"));
  highest_->setToolTip(tr("Speeds lie between 6 % of it and it, in equal ratios, each both ways"));
  speeds_->setMinimum(2);
  speeds_->setValue(6);
  duration_->setToolTip(tr("At least this long at each speed, and then on to the end of the turn"));
  bins_->setSuffix(tr(" angles"));
  bins_->setAccessibleName(tr("Angles per turn"));
  bins_->setToolTip(tr("Breakaways per turn, evenly spaced"));
  turns_->setSuffix(tr(" turns each way"));
  turns_->setAccessibleName(tr("Turns each way"));
}

void FrictionPage::wordForTravel() {
  title_->setText(tr("Friction over the travel"));
  speedsCaption_->setText(tr("Strokes at speeds up to"));
  highest_->setDecimals(3);
  highest_->setRange(0.0, 10.0);
  highest_->setSingleStep(0.01);
  highest_->setSuffix(tr(" m/s"));
  highest_->setToolTip(tr("Speeds lie between 1.2 % of it and it, in equal ratios, each both ways"));
  speeds_->setMinimum(3);
  speeds_->setValue(7);
  duration_->setToolTip(tr("At least this long at each speed, and then on to the end of the stroke"));
  bins_->setSuffix(tr(" places"));
  bins_->setAccessibleName(tr("Places over the travel"));
  bins_->setToolTip(tr("Places over the travel, evenly spaced; strokes are taken apart into as many"));
  turns_->setSuffix(tr(" passes each way"));
  turns_->setAccessibleName(tr("Passes each way"));
}

SweepSettings FrictionPage::sweeps() const {
  SweepSettings sweeps;
  sweeps.bins = static_cast<size_t>(bins_->value());
  sweeps.turns = static_cast<size_t>(turns_->value());
  sweeps.speedRun_s = duration_->value();
  sweeps.speeds = static_cast<size_t>(speeds_->value());
  sweeps.highest_rad_per_s = highest_->value();
  return sweeps;
}

void FrictionPage::showMotion() {
  run_->show(connection_.run());
  const bool linear = connection_.linear();
  const auto offer = [this](QPushButton* button, RunKind kind, const QString& what) {
    const QString first = connection_.connected() ? bench_.missingFor(kind, sweeps()) : QString();
    setAvailable(button, first.isEmpty() ? what : what + " " + first, bench_.obstacleToMake(kind));
  };
  offer(velocity_, RunKind::velocitySweep,
        linear ? tr("Strokes to and fro over the travel at several speeds.")
               : tr("Turns at constant speeds, both ways, over whole turns."));
  offer(breakaway_, RunKind::breakaway,
        linear ? tr("Steps over the travel; at each place the current rises slowly until the axis moves.")
               : tr("Steps around the rotor; at each angle the current rises slowly until the shaft moves."));
  offer(
      trial_, RunKind::trial,
      tr("Tunes the controller for the motor as it is known now, leaves it so, and goes slowly to and fro without and "
         "with the measured friction compensated."));
}

void FrictionPage::showKnown() {
  showAverages();
  map_->show(bench_.known());
  showMotion();
}

void FrictionPage::showAverages() {
  const Commission& known = bench_.known();
  const AxisUnits units = unitsOf(known.identity.axis);
  const int decimals = known.identity.axis == Axis::linear ? 3 : 2;
  std::vector<Fact> facts{
      {tr("Coulomb average"), withInterval(known.coulombAverage_Nm(), units.torqueScale, units.torque, decimals),
       tr("Mean of both ways at zero speed, 95 % interval")},
      {tr("Viscous average"),
       withInterval(known.viscousAverage_Nm_s_per_rad(), units.viscousScale, units.viscous, decimals),
       tr("Slope with speed, 95 % interval")}};
  if (known.knows(Known::map)) {
    const auto mean = [&known, &units, decimals](Way way) {
      double sum_Nm = 0.0;
      for (const MapBin& bin : known.map.bins) sum_Nm += bin.way[static_cast<size_t>(way)].static_Nm.value;
      return tr("%1 %2")
          .arg(units.torqueScale * sum_Nm / static_cast<double>(known.map.bins.size()), 0, 'f', decimals)
          .arg(units.torque);
    };
    const QString ccw = shortWayName(Way::ccw, known.identity.axis), cw = shortWayName(Way::cw, known.identity.axis);
    facts.push_back({tr("Static, %1 mean").arg(ccw), mean(Way::ccw), {}});
    facts.push_back({tr("Static, %1 mean").arg(cw), mean(Way::cw), {}});
    const auto& repeat = known.map.repeatability;
    if (known.map.turns > 1) {
      const auto number = [](double value) { return QString::number(value, 'f', 3); };
      const auto differ = [&](size_t way) { return number(units.torqueScale * repeat[way].rmsDifference_Nm); };
      facts.push_back(
          {known.identity.axis == Axis::linear ? tr("Passes correlate") : tr("Turns correlate"),
           tr("%1 %2, %3 %4").arg(ccw, number(repeat[1].correlation), cw, number(repeat[0].correlation)),
           tr("They differ by %1 (%2) and %3 %4 rms (%5)").arg(differ(1), ccw, differ(0), units.torque, cw)});
    }
  }
  if (known.compensatedRun) {
    const auto error = [&](double value) { return tr("%1 %2").arg(value, 0, 'g', 3).arg(units.speed); };
    const CompensatedRun& run = *known.compensatedRun;
    facts.push_back({tr("Velocity error"),
                     tr("%1, with the map %2").arg(error(run.without_rad_per_s), error(run.with_rad_per_s)),
                     tr("rms, going slowly to and fro, tuned for use")});
  }
  averages_->show(facts);
}

}  // namespace breakaway
