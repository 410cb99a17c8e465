#include "pages/home_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "session/bench_runs.h"
#include "session/connection.h"
#include "session/live_samples.h"
#include "widgets/controls.h"
#include "widgets/facts_table.h"
#include "widgets/rotor_dial.h"
#include "widgets/run_panel.h"
#include "widgets/travel_strip.h"

namespace breakaway {

HomePage::HomePage(Connection& connection, BenchRuns& bench, const LiveSamples& live, QWidget* parent)
    : Page("homePage", tr("Home"), "home", parent), connection_(connection), bench_(bench), live_(live) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 12, 16, 8);
  row->setSpacing(28);
  row->addWidget(buildControls());
  pictures_ = new QStackedWidget(this);
  dial_ = new RotorDial(pictures_);
  strip_ = new TravelStrip(pictures_);
  pictures_->addWidget(dial_);
  pictures_->addWidget(strip_);
  row->addWidget(pictures_, 1);
  connect(&connection_, &Connection::changed, this, &HomePage::showConnection);
  connect(&bench_, &BenchRuns::surveyChanged, this, &HomePage::showConnection);
  connect(&bench_, &BenchRuns::measured, this, &HomePage::showResult);
  connect(&connection_, &Connection::runChanged, this, &HomePage::showMotion);
  connect(&timer_, &QTimer::timeout, this, &HomePage::showAngle);
  timer_.start(33);
  showConnection();
}

QWidget* HomePage::buildControls() {
  auto* side = new QWidget(this);
  side->setFixedWidth(420);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(9);
  title_ = heading(side, {});
  column->addWidget(title_);
  plan_ = explanation(side, {}, "homingPlan");
  column->addWidget(plan_);
  auto* buttons = new QHBoxLayout;
  home_ = pushButton(side, "homeButton", tr("Home"));
  buttons->addWidget(home_);
  buttons->addStretch(1);
  column->addLayout(buttons);
  run_ = new RunPanel("homingRun", {RunKind::homing}, side);
  column->addWidget(run_);
  column->addWidget(rule(side));
  result_ = new FactsTable("homingResult", side);
  column->addWidget(result_);
  column->addStretch(1);
  connect(home_, &QPushButton::clicked, this, [this] { bench_.home(options_); });
  return side;
}

QString HomePage::plan() const {
  const double backOff_deg = options_.backOff_rad * 180.0 / std::numbers::pi;
  return tr("The shaft turns counter-clockwise at %1 rad/s until the index is seen, at most %2 turns. Then it backs "
            "off by %3° and passes "
            "the index's edge %4 times at %5 rad/s, always from the same side. It gives up after %6 s.")
      .arg(options_.searchSpeed_rad_per_s)
      .arg(options_.mostTurns)
      .arg(backOff_deg, 0, 'f', 0)
      .arg(options_.approaches)
      .arg(options_.approachSpeed_rad_per_s)
      .arg(options_.timeout_s);
}

QString HomePage::travelPlan() const {
  QStringList steps{
      tr("The axis feels for both ends at 50 mm/s, with a current limit that grows only until it moves.")};
  if (!bench_.survey().identification)
    steps << tr("The motor is identified: half a minute standing in the middle, then strokes to and fro by voltage.");
  steps
      << (connection_.identity().hasIndex
              ? tr("Then it runs over the whole travel to see the index once and only once, and passes it slowly from "
                   "below three times.")
              : tr("It has no index: positions are counted from the lower end."));
  steps << tr("From there on everything keeps 3 % of the travel, at least 2.4 mm, away from the ends.");
  return steps.join(' ');
}

void HomePage::showConnection() {
  const bool linear = connection_.linear();
  pictures_->setCurrentWidget(linear ? static_cast<QWidget*>(strip_) : dial_);
  title_->setText(linear ? tr("Feel for the ends, home to the index") : tr("Home to the index"));
  plan_->setText(linear ? travelPlan() : plan());
  showResult();
}

void HomePage::showTravel() {
  const auto axis = bench_.axis();
  if (!axis) {
    result_->show({{tr("Travel"), tr("not felt yet"), {}}, {tr("Index"), tr("not homed yet"), {}}});
    return;
  }
  const auto millimetres = [](double length_m, int decimals) {
    return tr("%1 mm").arg(1e3 * length_m, 0, 'f', decimals);
  };
  const Estimate& index = *bench_.index_rad();
  const bool hasIndex = connection_.identity().hasIndex;
  result_->show(
      {{tr("Travel"), millimetres(axis->travel.high_m - axis->travel.low_m, 2), tr("From end to end")},
       {tr("Margin"), millimetres(axis->travel.margin_m, 1), tr("Kept away from either end")},
       {hasIndex ? tr("Index") : tr("Lower end"), tr("%1 mm in the board's position").arg(1e3 * index.value, 0, 'f', 3),
        hasIndex ? tr("Mean over the passes") : tr("Positions are counted from here")},
       {tr("Interval"), tr("± %1 µm (95 %)").arg(1.96e6 * index.standardError, 0, 'f', 1), {}},
       {tr("Mass"),
        tr("%1 ± %2 kg")
            .arg(axis->motor.inertia_kg_m2.value, 0, 'f', 3)
            .arg(1.96 * axis->motor.inertia_kg_m2.standardError, 0, 'f', 3),
        tr("By strokes, 95 %; %1").arg(QString::fromStdString(axis->motor.gauge))},
       {tr("Highest speed"), tr("%1 m/s").arg(bench_.reachableSpeed_rad_per_s(), 0, 'f', 3),
        tr("That strokes can reach between the margins")}});
}

void HomePage::showResult() {
  if (connection_.linear()) {
    showTravel();
    showMotion();
    return;
  }
  const auto& index = bench_.index_rad();
  if (!index) {
    result_->show({{tr("Index"), connection_.connected() ? tr("not homed yet") : tr("–"), {}}});
  } else {
    result_->show(
        {{tr("Index"), tr("%1 rad in the board's angle").arg(index->value, 0, 'f', 5), tr("Mean over the passes")},
         {tr("Interval"), tr("± %1 mrad (95 %)").arg(1.96e3 * index->standardError, 0, 'f', 3), {}},
         {tr("Encoder count"),
          tr("%1 mrad").arg(2e3 * std::numbers::pi / connection_.identity().countsPerRev, 0, 'f', 3),
          {}}});
  }
  showMotion();
}

void HomePage::showMotion() {
  run_->show(connection_.run());
  setAvailable(home_, connection_.linear() ? tr("Find both ends and the index") : tr("Find the index"),
               bench_.homingObstacle());
}

void HomePage::showAngle() {
  if (!isVisible()) return;
  const auto newest = live_.history().newest();
  if (connection_.linear()) {
    const auto axis = bench_.axis();
    strip_->show(newest ? std::optional(newest->angle_rad) : std::nullopt,
                 axis ? std::optional(axis->travel) : std::nullopt,
                 bench_.index_rad() ? std::optional(bench_.index_rad()->value) : std::nullopt);
    return;
  }
  dial_->show(newest ? std::optional(newest->angle_rad) : std::nullopt,
              bench_.index_rad() ? std::optional(bench_.index_rad()->value) : std::nullopt);
}

}  // namespace breakaway
