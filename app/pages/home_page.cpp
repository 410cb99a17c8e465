#include "pages/home_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "session.h"
#include "widgets/controls.h"
#include "widgets/facts_table.h"
#include "widgets/rotor_dial.h"
#include "widgets/run_panel.h"

namespace breakaway {

HomePage::HomePage(Session& session, QWidget* parent)
    : Page("homePage", tr("Home"), "home", parent), session_(session) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 12, 16, 8);
  row->setSpacing(28);
  row->addWidget(buildControls());
  dial_ = new RotorDial(this);
  row->addWidget(dial_, 1);
  connect(&session_, &Session::connectionChanged, this, &HomePage::showResult);
  connect(&session_, &Session::measured, this, &HomePage::showResult);
  connect(&session_, &Session::runChanged, this, &HomePage::showMotion);
  connect(&timer_, &QTimer::timeout, this, &HomePage::showAngle);
  timer_.start(33);
  showResult();
}

QWidget* HomePage::buildControls() {
  auto* side = new QWidget(this);
  side->setFixedWidth(420);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(9);
  column->addWidget(heading(side, tr("Home to the index")));
  column->addWidget(explanation(side, plan(), "homingPlan"));
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
  connect(home_, &QPushButton::clicked, this, [this] { session_.home(options_); });
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

void HomePage::showResult() {
  const auto& index = session_.index_rad();
  if (!index) {
    result_->show({{tr("Index"), session_.connected() ? tr("not homed yet") : tr("–"), {}}});
  } else {
    result_->show(
        {{tr("Index"), tr("%1 rad in the board's angle").arg(index->value, 0, 'f', 5), tr("Mean over the passes")},
         {tr("Interval"), tr("± %1 mrad (95 %)").arg(1.96e3 * index->standardError, 0, 'f', 3), {}},
         {tr("Encoder count"),
          tr("%1 mrad").arg(2e3 * std::numbers::pi / session_.identity().countsPerRev, 0, 'f', 3),
          {}}});
  }
  showMotion();
}

void HomePage::showMotion() {
  run_->show(session_.run());
  setAvailable(home_, tr("Find the index"), session_.homingObstacle());
}

void HomePage::showAngle() {
  if (!isVisible()) return;
  const auto newest = session_.history().newest();
  dial_->show(newest ? std::optional(newest->angle_rad) : std::nullopt,
              session_.index_rad() ? std::optional(session_.index_rad()->value) : std::nullopt);
}

}  // namespace breakaway
