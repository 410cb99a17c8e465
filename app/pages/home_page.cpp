#include "pages/home_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "experiment/homing.h"
#include "pages/run_state.h"
#include "session/bench_runs.h"
#include "session/connection.h"
#include "widgets/controls.h"
#include "widgets/facts_table.h"
#include "widgets/number_text.h"
#include "widgets/position_view.h"
#include "widgets/run_panel.h"

namespace breakaway {

namespace {

/// One below the other.
QString numbered(const QStringList& steps) {
  QStringList lines;
  for (const QString& step : steps) lines << QString("%1. %2").arg(lines.size() + 1).arg(step);
  return lines.join('\n');
}

double degrees(double angle_rad) {
  return angle_rad * 180.0 / std::numbers::pi;
}

double withinATurn_deg(double angle_rad) {
  return degrees(angle_rad - turn_rad * std::floor(angle_rad / turn_rad));
}

}  // namespace

HomePage::HomePage(Connection& connection, BenchRuns& bench, const LiveSamples& live, QWidget* parent)
    : Page("homePage", tr("Home"), parent), connection_(connection), bench_(bench) {
  home_ = addPrimary("homeButton", tr("Home"));
  settings()->addWidget(buildPlan());
  settings()->addWidget(buildResult());
  settings()->addStretch(1);
  picture()->addWidget(new PositionView(connection, bench, live, this), 1);
  connect(home_, &QPushButton::clicked, this, [this] { bench_.make(RunKind::homing); });
  connect(&connection_, &Connection::changed, this, &HomePage::showConnection);
  connect(&bench_, &BenchRuns::knownChanged, this, &HomePage::showConnection);
  connect(&bench_, &BenchRuns::measured, this, &HomePage::showResult);
  connect(&connection_, &Connection::runChanged, this, &HomePage::showMotion);
  showConnection();
}

QWidget* HomePage::buildPlan() {
  auto* group = card(this);
  auto* column = columnOf(group);
  column->addWidget(section(group, tr("What will move")));
  plan_ = explanation(group, {}, "homingPlan");
  column->addWidget(plan_);
  run_ = new RunPanel("homingRun", {RunKind::homing}, group);
  run_->leadOn(RunKind::homing, "frictionPage", tr("Friction"));
  connect(run_, &RunPanel::pageAsked, this, &Page::pageAsked);
  column->addWidget(run_);
  return group;
}

QWidget* HomePage::buildResult() {
  auto* group = card(this);
  columnOf(group)->addWidget(section(group, tr("Result")));
  result_ = new FactsTable("homingResult", group);
  columnOf(group)->addWidget(result_);
  return group;
}

QString HomePage::plan() const {
  const HomingOptions options;
  const bool first = !bench_.known().knows(Known::motor) && bench_.obstacleToMake(RunKind::identification).isEmpty();
  QStringList steps;
  if (first) steps << tr("The motor is identified: about a minute, standing and then turning both ways.");
  steps << tr("The shaft turns counter-clockwise at %1 rad/s until the index is seen, at most %2 turns.")
               .arg(options.searchSpeed_rad_per_s)
               .arg(options.mostTurns)
        << tr("It backs off by %1° and passes the index's edge %2 times at %3 rad/s, always from the same side.")
               .arg(degrees(options.backOff_rad), 0, 'f', 0)
               .arg(options.approaches)
               .arg(options.approachSpeed_rad_per_s)
        << tr("It gives up after %1 s.").arg(options.timeout_s);
  return numbered(steps);
}

QString HomePage::travelPlan() const {
  QStringList steps{
      tr("The axis feels for both ends at 50 mm/s, with a current limit that grows only until it moves.")};
  if (!bench_.known().knows(Known::motor))
    steps << tr("The motor is identified: half a minute standing in the middle, then strokes to and fro by voltage.");
  steps << (connection_.identity().hasIndex
                ? tr("It runs over the whole travel to see the index once and only once, and passes it slowly from "
                     "below three times.")
                : tr("It has no index: positions are counted from the lower end."));
  steps << tr("From there on everything keeps 3 % of the travel, at least 2.4 mm, away from the ends.");
  return numbered(steps);
}

void HomePage::showConnection() {
  const bool linear = connection_.linear();
  setHead(linear ? tr("Feel for the ends, home to the index") : tr("Home to the index"),
          linear ? tr("Every place of the map is counted from the encoder's index.")
                 : tr("Every angle of the map is counted from the encoder's index."));
  plan_->setText(linear ? travelPlan() : plan());
  showResult();
}

std::vector<Fact> HomePage::travelFacts() const {
  const auto index = bench_.index_rad();
  if (!index) return {{tr("Travel"), tr("not felt yet"), {}}, {tr("Index"), tr("not homed yet"), {}}};
  const auto millimetres = [](double length_m, int decimals) {
    return tr("%1 mm").arg(fixedText(1e3 * length_m, decimals));
  };
  const Commission& known = bench_.known();
  const bool hasIndex = connection_.identity().hasIndex;
  return {{tr("Travel"), millimetres(known.counted.high_m - known.counted.low_m, 2), tr("From end to end")},
          {tr("Margin"), millimetres(known.counted.margin_m, 1), tr("Kept away from either end")},
          {hasIndex ? tr("Index") : tr("Lower end"),
           tr("%1 mm in the board's position").arg(fixedText(1e3 * index->value, 3)),
           hasIndex ? tr("Mean over the passes") : tr("Positions are counted from here")},
          {tr("Interval"), tr("± %1 µm (95 %)").arg(1e6 * normal95 * index->standardError, 0, 'f', 1), {}},
          {tr("Highest speed"), tr("%1 m/s").arg(known.pace.speed_m_per_s, 0, 'f', 3),
           tr("That strokes can reach between the margins")}};
}

std::vector<Fact> HomePage::indexFacts() const {
  const auto index = bench_.index_rad();
  if (!index) return {{tr("Index"), connection_.connected() ? tr("not homed yet") : tr("–"), {}}};
  return {{tr("Index"), tr("%1°").arg(withinATurn_deg(index->value), 0, 'f', 3),
           tr("In the board's own angle, whole turns left out; mean over the passes")},
          {tr("Interval"), tr("± %1° (95 %)").arg(numberText(degrees(normal95 * index->standardError), 2)), {}},
          {tr("Encoder count"), tr("%1°").arg(numberText(360.0 / connection_.identity().countsPerRev)), {}}};
}

void HomePage::showResult() {
  result_->show(connection_.linear() ? travelFacts() : indexFacts());
  showMotion();
}

void HomePage::showMotion() {
  run_->show(connection_.run());
  const QString what = connection_.linear() ? tr("Find both ends and the index") : tr("Find the index");
  const QString first = connection_.connected() ? bench_.missingFor(RunKind::homing) : QString();
  setAvailable(home_, first.isEmpty() ? what : what + ". " + first, bench_.obstacleToMake(RunKind::homing));
  StepState state = stateOf(connection_, {RunKind::homing});
  const auto index = bench_.index_rad();
  if (index && state.mark != StepMark::running)
    state = {StepMark::done, connection_.linear()
                                 ? tr("index at %1 mm").arg(fixedText(1e3 * index->value, 2))
                                 : tr("index ± %1°").arg(numberText(degrees(normal95 * index->standardError), 2))};
  setState(state);
}

}  // namespace breakaway
