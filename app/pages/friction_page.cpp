#include "pages/friction_page.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "commission/unfinished_job.h"
#include "friction/static_average.h"
#include "pages/run_state.h"
#include "session/bench_runs.h"
#include "session/connection.h"
#include "session/messages.h"
#include "session/shown_maps.h"
#include "widgets/axis_units.h"
#include "widgets/controls.h"
#include "widgets/facts_table.h"
#include "widgets/kept_maps_card.h"
#include "widgets/map_export.h"
#include "widgets/map_panel.h"
#include "widgets/number_text.h"
#include "widgets/run_panel.h"
#include "widgets/run_words.h"

namespace breakaway {

namespace {

constexpr int boxWidth = 128, continueWidth = 112;

QString withInterval(const std::optional<Estimate>& estimate, double scale, const QString& unit) {
  return estimate ? estimateText(*estimate, scale, unit) : FrictionPage::tr("not measured");
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

FrictionPage::FrictionPage(Connection& connection, BenchRuns& bench, ShownMaps& maps, Messages& messages,
                           FileChooser& files, QWidget* parent)
    : Page("frictionPage", tr("Friction"), parent),
      connection_(connection),
      bench_(bench),
      maps_(maps),
      messages_(messages),
      files_(files) {
  breakaway_ = addPrimary("breakawaySweepButton", tr("Run breakaway sweep"));
  continue_ = addSecondary("continueSweepButton", tr("Continue"), continueWidth);
  velocity_ = addSecondary("velocitySweepButton", tr("Run velocity sweep"), 160);
  map_ = new MapPanel(this);
  buildSettings();
  picture()->addWidget(map_, 1);
  addReading("polarReading");
  connect(map_, &MapPanel::reading, this, &FrictionPage::read);
  connect(&connection_, &Connection::changed, this, &FrictionPage::showConnection);
  connect(&connection_, &Connection::runChanged, this, &FrictionPage::showMotion);
  connect(&bench_, &BenchRuns::measured, this, &FrictionPage::showMotion);
  connect(&bench_, &BenchRuns::knownChanged, this, &FrictionPage::showKnown);
  connect(&bench_, &BenchRuns::tookUp, this, [this] { setSweeps(bench_.known().sweeps); });
  connect(&maps_, &ShownMaps::changed, this, &FrictionPage::showMaps);
  showConnection();
  showMaps();
}

void FrictionPage::buildSettings() {
  settings()->addWidget(buildSweep());
  auto* averages = card(this);
  columnOf(averages)->addWidget(section(averages, tr("Averages")));
  averages_ = new FactsTable("frictionAverages", averages);
  columnOf(averages)->addWidget(averages_);
  settings()->addWidget(averages);
  auto* use = card(this);
  columnOf(use)->addWidget(section(use, tr("Export and use")));
  export_ = new MapExport(messages_, files_, *map_, use);
  columnOf(use)->addWidget(export_);
  trial_ = pushButton(use, "tryMapButton", tr("Tune and try the map"));
  columnOf(use)->addWidget(trial_);
  settings()->addWidget(use);
  auto* maps = new KeptMapsCard(maps_, this);
  connect(maps, &KeptMapsCard::runsAsked, this, [this] { emit pageAsked("runsPage"); });
  settings()->addWidget(maps);
  settings()->addStretch(1);
  connect(velocity_, &QPushButton::clicked, this, [this] { bench_.make(RunKind::velocitySweep, sweeps()); });
  for (QPushButton* button : {continue_, breakaway_})
    connect(button, &QPushButton::clicked, this, [this] { bench_.make(RunKind::breakaway, sweeps()); });
  connect(trial_, &QPushButton::clicked, this, [this] { bench_.make(RunKind::trial, sweeps()); });
}

QWidget* FrictionPage::buildSweep() {
  auto* group = card(this);
  columnOf(group)->addWidget(section(group, tr("Sweeps")));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(0, 1);
  const auto row = [&](QWidget* box) {
    const int at = grid->rowCount();
    auto* name = new QLabel(box->accessibleName(), group);
    name->setBuddy(box);
    box->setFixedWidth(boxWidth);
    grid->addWidget(name, at, 0);
    grid->addWidget(box, at, 1);
    return name;
  };
  bins_ = countBox(group, "bins", tr("Angles per turn"), 8, 720, SweepSettings{}.bins);
  turns_ = countBox(group, "turns", tr("Turns each way"), 1, 10, 2);
  highest_ = numberBox(group, "highestSpeed", tr("Highest speed"), 0.0, 2000.0, 0.0, {});
  highest_->setSpecialValueText(tr("reachable"));
  speeds_ = countBox(group, "speedCount", tr("Number of speeds"), 2, 12, 6);
  duration_ =
      numberBox(group, "speedDuration", tr("Time at each speed"), 0.5, 120.0, SweepSettings{}.speedRun_s, tr(" s"));
  turns_->setToolTip(
      tr("How often each angle is visited each way; what differs between turns is the doubt of the map"));
  speeds_->setToolTip(tr("How many speeds the velocity sweep measures each way"));
  binsName_ = row(bins_);
  turnsName_ = row(turns_);
  row(highest_);
  row(speeds_);
  row(duration_);
  columnOf(group)->addLayout(grid);
  run_ = new RunPanel("frictionRun", {RunKind::velocitySweep, RunKind::breakaway, RunKind::trial}, group);
  run_->leadOn(RunKind::breakaway, "reportPage", tr("Report"));
  connect(run_, &RunPanel::pageAsked, this, &Page::pageAsked);
  anew_ = pushButton(group, "startAnewButton", tr("Start anew"));
  auto* under = new QHBoxLayout;
  under->setSpacing(8);
  under->addWidget(run_, 1);
  under->addWidget(anew_, 0, Qt::AlignTop);
  columnOf(group)->addLayout(under);
  connect(anew_, &QPushButton::clicked, this, [this] { bench_.forgetSweeps(); });
  for (const QSpinBox* box : {bins_, turns_, speeds_})
    connect(box, &QSpinBox::valueChanged, this, &FrictionPage::showMotion);
  for (const QDoubleSpinBox* box : {highest_, duration_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &FrictionPage::showMotion);
  return group;
}

void FrictionPage::showConnection() {
  const Axis axis = connection_.identity().axis;
  if (axis != worded_) wordFor(axis);
  worded_ = axis;
  showHead();
  showMotion();
}

void FrictionPage::showHead() {
  if (maps_.opened())
    return setHead(titleOf(maps_.opened()->run),
                   tr("A map of the project. A sweep measures today's, which is shown then."));
  const bool linear = worded_ == Axis::linear;
  setHead(linear ? tr("Friction over the travel") : tr("Friction around the rotor"),
          linear ? tr("The force that breaks the axis away at every place, and what keeps it moving.")
                 : tr("The torque that breaks the rotor away at every angle, and what keeps it moving."));
}

void FrictionPage::wordFor(Axis axis) {
  const bool linear = axis == Axis::linear;
  const auto either = [linear](const QString& rotor, const QString& travel) { return linear ? travel : rotor; };
  highest_->setDecimals(linear ? 3 : 1);
  highest_->setRange(0.0, linear ? 10.0 : 2000.0);
  highest_->setSingleStep(linear ? 0.01 : 1.0);
  highest_->setSuffix(either(tr(" rad/s"), tr(" m/s")));
  highest_->setToolTip(
      tr("Speeds lie between %1 % of it and it, in equal ratios, each both ways").arg(linear ? 1.2 : 6.0));
  speeds_->setMinimum(linear ? 3 : 2);
  speeds_->setValue(linear ? 7 : 6);
  duration_->setToolTip(
      tr("At least this long at each speed, and then on to the end of the %1").arg(either(tr("turn"), tr("stroke"))));
  bins_->setAccessibleName(either(tr("Angles per turn"), tr("Places over travel")));
  binsName_->setText(bins_->accessibleName());
  bins_->setToolTip(either(tr("Breakaways per turn, evenly spaced"),
                           tr("Places over the travel, evenly spaced; strokes are taken apart into as many")));
  turns_->setAccessibleName(either(tr("Turns each way"), tr("Passes each way")));
  turnsName_->setText(turns_->accessibleName());
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

void FrictionPage::setSweeps(const SweepSettings& sweeps) {
  bins_->setValue(static_cast<int>(sweeps.bins));
  turns_->setValue(static_cast<int>(sweeps.turns));
  duration_->setValue(sweeps.speedRun_s);
  speeds_->setValue(static_cast<int>(sweeps.speeds));
  highest_->setValue(sweeps.highest_rad_per_s);
}

void FrictionPage::showMotion() {
  run_->show(connection_.run());
  const bool sweeping = connection_.runs(RunKind::velocitySweep) || connection_.runs(RunKind::breakaway);
  map_->setUnderWay(connection_.runs(RunKind::breakaway));
  if (sweeping && maps_.opened()) return maps_.open({});
  const bool linear = connection_.linear();
  const auto offer = [this](QPushButton* button, RunKind kind, const QString& what, const QString& otherwise = {}) {
    const QString first = connection_.connected() ? bench_.missingFor(kind, sweeps()) : QString();
    const QString obstacle = bench_.obstacleToMake(kind);
    setAvailable(button, first.isEmpty() ? what : what + " " + first, obstacle.isEmpty() ? otherwise : obstacle);
  };
  offer(velocity_, RunKind::velocitySweep,
        linear ? tr("Strokes to and fro over the travel at several speeds.")
               : tr("Turns at constant speeds, both ways, over whole turns."));
  // Two buttons, each of which means one thing: what goes on and what begins never lie under the same click.
  const Commission& known = bench_.known();
  const size_t whole = 2 * sweeps().bins * sweeps().turns, done = known.breakaways.size() + known.missed;
  const bool unfinished = done > 0 && !known.knows(Known::breakaways);
  const bool goesOn = unfinished && !known.otherThan(sweeps()).has(Known::breakaways);
  offer(breakaway_, RunKind::breakaway,
        linear ? tr("Steps over the travel; at each place the current rises slowly until the axis moves.")
               : tr("Steps around the rotor; at each angle the current rises slowly until the shaft moves."),
        goesOn ? tr("A sweep is unfinished: Continue goes on with it, Start anew forgets it") : QString());
  offer(continue_, RunKind::breakaway, tr("Goes on with the sweep: %1 of %2 are measured.").arg(done).arg(whole),
        goesOn       ? QString()
        : unfinished ? tr("The sweep began with other settings; Run breakaway sweep begins anew with these")
                     : tr("No sweep is unfinished"));
  dressAs(continue_, "role", continue_->isEnabled() ? "primary" : QString());
  offer(
      trial_, RunKind::trial,
      tr("Tunes the controller for the motor as it is known now, leaves it so, and goes slowly to and fro without and "
         "with the measured friction compensated."));
  setAvailable(anew_, tr("Forgets what the interrupted sweeps have measured; the motor stays known."),
               connection_.connected() && !isUnfinished(known) ? tr("No sweep is unfinished") : connection_.obstacle());
  showState();
}

void FrictionPage::showState() {
  StepState state = stateOf(connection_, {RunKind::velocitySweep, RunKind::breakaway, RunKind::trial});
  const Commission& known = bench_.known();
  const size_t whole = 2 * known.sweeps.bins * known.sweeps.turns, done = known.breakaways.size() + known.missed;
  const bool map = known.knows(Known::map);
  if (map && state.mark != StepMark::running) state = {StepMark::done, tr("map complete")};
  if (!map && done > 0) state.words = tr("%1 of %2").arg(done).arg(whole);
  if (!map && done > 0 && state.mark == StepMark::open) state.mark = StepMark::paused;
  setState(state);
}

void FrictionPage::showKnown() {
  const Commission known = shown();
  showAverages(known);
  export_->show(known);
  map_->show(known);
  showMotion();
}

/// Of the project's map that was opened, else of this bench.
Commission FrictionPage::shown() const {
  return maps_.opened() ? commissionOf(maps_.opened()->map) : bench_.known();
}

void FrictionPage::showMaps() {
  const auto& earlier = maps_.earlier();
  map_->layBeneath(earlier ? std::optional(earlier->map) : std::nullopt);
  showHead();
  showKnown();
}

void FrictionPage::showAverages(const Commission& known) {
  const auto& opened = maps_.opened();
  const auto coulomb = opened ? std::optional(opened->map.coulombAverage_Nm) : known.coulombAverage_Nm();
  const auto viscous =
      opened ? std::optional(opened->map.viscousAverage_Nm_s_per_rad) : known.viscousAverage_Nm_s_per_rad();
  const AxisUnits units = unitsOf(known.identity.axis);
  const bool mapped = known.knows(Known::map), linear = known.identity.axis == Axis::linear;
  const QString ccw = shortWayName(Way::ccw, known.identity.axis), cw = shortWayName(Way::cw, known.identity.axis);
  // As many lines as there will be: what is below stays where it is.
  std::vector<Fact> facts{
      {tr("Coulomb"), withInterval(coulomb, units.torqueScale, units.torque),
       tr("Mean of both ways at zero speed, 95 % interval")},
      {tr("Viscous"), withInterval(viscous, units.viscousScale, units.viscous), tr("Slope with speed, 95 % interval")}};
  for (const Way way : {Way::ccw, Way::cw})
    facts.push_back({tr("Static, %1").arg(way == Way::ccw ? ccw : cw),
                     withInterval(mapped ? std::optional(staticAverage_Nm(known.map, way)) : std::nullopt,
                                  units.torqueScale, units.torque),
                     tr("Mean of all bins, which share their errors; 95 % interval")});
  facts.push_back({linear ? tr("Passes correlate") : tr("Turns correlate"), tr("not measured"),
                   tr("How alike the breakaways of one turn and the next are")});
  if (mapped && known.map.turns > 1) {
    const auto& repeat = known.map.repeatability;
    const auto number = [](double value) { return QString::number(value, 'f', 3); };
    const auto differ = [&](size_t way) { return number(units.torqueScale * repeat[way].rmsDifference_Nm); };
    facts.back().value = tr("%1 %2, %3 %4").arg(ccw, number(repeat[1].correlation), cw, number(repeat[0].correlation));
    facts.back().help =
        tr("They differ by %1 (%2) and %3 %4 rms (%5)").arg(differ(1), ccw, differ(0), units.torque, cw);
  }
  facts.push_back({tr("Velocity error"), tr("not measured"), tr("rms, going slowly to and fro, tuned for use")});
  if (known.compensatedRun) {
    const auto error = [&](double value) { return tr("%1 %2").arg(numberText(value)).arg(units.speed); };
    const CompensatedRun& run = *known.compensatedRun;
    facts.back().value = tr("%1, with the map %2").arg(error(run.without_rad_per_s), error(run.with_rad_per_s));
  }
  averages_->show(facts);
}

}  // namespace breakaway
