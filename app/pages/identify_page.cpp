#include "pages/identify_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "pages/run_state.h"
#include "session/bench_runs.h"
#include "session/connection.h"
#include "session/language.h"
#include "widgets/axis_units.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/facts_table.h"
#include "widgets/look.h"
#include "widgets/motor_tests_plot.h"
#include "widgets/number_text.h"
#include "widgets/run_panel.h"

namespace breakaway {

namespace {

constexpr size_t mostSteps = 7;
constexpr int cardHeight = 68, motorWidth = 352, factsHeight = 268;

QString resultText(const IdentifyStep& step) {
  if (step.state == IdentifyStep::State::failed) return step.trouble;
  QStringList parts;
  for (const Measured& one : step.results) parts << one.name + " " + estimateText(one.value, one.scale, one.unit);
  return parts.join("   ");
}

}  // namespace

IdentifyPage::IdentifyPage(Connection& connection, BenchRuns& bench, QWidget* parent)
    : Page("identifyPage", tr("Identify"), parent), connection_(connection), bench_(bench) {
  setHead(tr("Identify the motor"), tr("Each step says what it moves; nothing is written to the board."));
  identify_ = addPrimary("identifyButton", tr("Identify the motor"));
  wiring_ = addSecondary("wiringButton", tr("Check the wiring"));
  for (size_t k = 0; k < mostSteps; ++k) cards_.push_back(addCard(*settings()));
  settings()->setSpacing(8);
  settings()->addStretch(1);
  run_ = new RunPanel("identifyRun", {RunKind::wiring, RunKind::identification}, this);
  run_->leadOn(RunKind::identification, "tunePage", tr("Tune"));
  connect(run_, &RunPanel::pageAsked, this, &Page::pageAsked);
  auto* frame = card(this);
  columnOf(frame)->setContentsMargins(8, 8, 8, 8);
  tests_ = new MotorTestsPlot(frame);
  columnOf(frame)->addWidget(tests_);
  picture()->addWidget(frame, 3);
  picture()->addWidget(buildFacts(), 4);
  outcome_ = card(this);
  columnOf(outcome_)->setContentsMargins(12, 4, 12, 4);
  columnOf(outcome_)->addWidget(run_);
  QSizePolicy room = outcome_->sizePolicy();
  room.setRetainSizeWhenHidden(true);  // what is above it stays where it is
  outcome_->setSizePolicy(room);
  picture()->addWidget(outcome_);
  connect(identify_, &QPushButton::clicked, this, [this] { bench_.make(RunKind::identification); });
  connect(wiring_, &QPushButton::clicked, this, [this] { bench_.make(RunKind::wiring); });
  connect(&connection_, &Connection::changed, this, &IdentifyPage::showSteps);
  connect(&connection_, &Connection::runChanged, this, &IdentifyPage::showSteps);
  connect(&bench_, &BenchRuns::knownChanged, this, &IdentifyPage::showSteps);
  connect(&bench_, &BenchRuns::knownChanged, this, [this] { tests_->show(bench_.known()); });
  connect(tests_, &MotorTestsPlot::chosen, this, [this] { tests_->show(bench_.known()); });
  tests_->show(bench_.known());
  showSteps();
}

IdentifyPage::Card IdentifyPage::addCard(QVBoxLayout& column) {
  auto* frame = card(this);
  frame->setFixedHeight(cardHeight);
  columnOf(frame)->setContentsMargins(16, 4, 12, 6);
  columnOf(frame)->setSpacing(2);
  auto* head = new QHBoxLayout;
  auto* title = section(frame, {});
  auto* badge = new QLabel(frame);
  badge->setFont(typed(Type::caption));
  head->addWidget(title, 1);
  head->addWidget(badge);
  auto* moves = new ElidedLabel("", frame);
  moves->setFont(typed(Type::caption));
  moves->setProperty("tone", "muted");
  auto* result = new ElidedLabel("", frame);
  result->setFont(typed(Type::caption));
  columnOf(frame)->addLayout(head);
  columnOf(frame)->addWidget(moves);
  columnOf(frame)->addWidget(result);
  column.addWidget(frame);
  return {frame, title, badge, moves, result};
}

QWidget* IdentifyPage::buildFacts() {
  auto* area = new QScrollArea(this);
  area->setObjectName("identifyFacts");
  area->setFocusPolicy(Qt::NoFocus);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidgetResizable(true);
  area->setMaximumHeight(factsHeight);  // whatever they say: what is above them stays as it is
  auto* group = new QWidget(area);
  group->setProperty("role", "column");
  auto* row = rowIn(group, 8);
  auto* motor = card(group);
  columnOf(motor)->addWidget(section(motor, tr("Motor")));
  motor_ = new FactsTable("motorFacts", motor);
  columnOf(motor)->addWidget(motor_);
  auto* wires = card(group);
  columnOf(wires)->addWidget(section(wires, tr("Wiring")));
  wires_ = new FactsTable("wiringFacts", wires);
  columnOf(wires)->addWidget(wires_);
  motor->setFixedWidth(motorWidth);  // the sentences have the rest
  row->addWidget(motor, 0, Qt::AlignTop);
  row->addWidget(wires, 1, Qt::AlignTop);
  area->setWidget(group);
  area->viewport()->setAutoFillBackground(false);
  group->setAutoFillBackground(false);
  return area;
}

void IdentifyPage::showCard(const Card& card, int number, const IdentifyStep& step) {
  card.title->setText(QString("%1  %2").arg(number).arg(step.title));
  card.moves->setText(step.moves);
  card.result->setText(resultText(step));
  card.result->setToolTip(resultText(step));
  switch (step.state) {
    case IdentifyStep::State::open:
      card.badge->setText({});
      dressAs(card.badge, "badge", "open");
      dressAs(card.frame, "tone", {});
      break;
    case IdentifyStep::State::running:
      card.badge->setText(tr("running"));
      dressAs(card.badge, "badge", "running");
      dressAs(card.frame, "tone", "running");
      break;
    case IdentifyStep::State::passed:
      card.badge->setText(tr("pass"));
      dressAs(card.badge, "badge", "good");
      dressAs(card.frame, "tone", {});
      break;
    case IdentifyStep::State::failed:
      card.badge->setText(tr("fail"));
      dressAs(card.badge, "badge", "trouble");
      dressAs(card.frame, "tone", "trouble");
      break;
  }
  dressAs(card.result, "tone", step.state == IdentifyStep::State::failed ? "trouble" : QString());
}

void IdentifyPage::showSteps() {
  const auto steps = identifySteps(bench_.known(), connection_.run());
  size_t passed = 0;
  for (size_t k = 0; k < cards_.size(); ++k) {
    cards_[k].frame->setVisible(k < steps.size());
    if (k >= steps.size()) continue;
    showCard(cards_[k], static_cast<int>(k) + 1, steps[k]);
    if (steps[k].state == IdentifyStep::State::passed) ++passed;
  }
  run_->show(connection_.run());
  outcome_->setVisible(run_->saysSomething());
  showFacts();
  showButtons();
  StepState state = stateOf(connection_, {RunKind::wiring, RunKind::identification});
  if (state.mark == StepMark::open && passed > 0)
    state.mark = passed == steps.size() ? StepMark::done : StepMark::paused;
  if (state.words.isEmpty() && passed > 0) state.words = tr("%1 of %2 passed").arg(passed).arg(steps.size());
  setState(state);
}

void IdentifyPage::showFacts() {
  const Commission& known = bench_.known();
  const AxisUnits units = unitsOf(known.identity.axis);
  const bool linear = known.linear();
  const IdentifiedMotor& motor = known.motor;
  const QString scale = inLanguage(motor.gauge);
  std::vector<Fact> facts{
      {linear ? tr("Force constant") : tr("Torque constant"),
       motor.torqueConstant_Nm_per_A.standardError > 0.0
           ? estimateText(motor.torqueConstant_Nm_per_A, 1.0, units.constant)
           : tr("%1, believed").arg(estimateText(motor.torqueConstant_Nm_per_A, 1.0, units.constant)),
       scale},
      {tr("Resistance"), estimateText(motor.resistance_ohm, 1.0, tr("Ω")), {}},
      {tr("Inductance"), estimateText(motor.inductance_H, 1e3, tr("mH")), {}},
      {linear ? tr("Mass") : tr("Inertia"), estimateText(motor.inertia_kg_m2, units.inertiaScale, units.inertia),
       scale},
      {tr("Coulomb friction"), estimateText(motor.coulomb_Nm, units.torqueScale, units.torque),
       tr("Mean of both ways")},
      {tr("Viscous friction"), estimateText(motor.viscous_Nm_s_per_rad, units.viscousScale, units.viscous), {}},
      {tr("Dead zone of the bridge"), estimateText(motor.deadZone_V, 1e3, tr("mV")), {}}};
  if (!known.knows(Known::motor)) {
    for (Fact& fact : facts) fact = {fact.name, tr("–"), tr("Not identified yet")};
  }
  motor_->show(facts);
  std::vector<Fact> wires;
  if (known.knows(Known::wiring) && known.wiring) {
    for (const Message& sentence :
         inWords(*known.wiring, known.sensorZero_A, known.noiseRms_A, known.identity.supply_V, known.identity.axis)) {
      const QString whole = inLanguage(sentence);
      wires.push_back({whole.section(": ", 0, 0), whole.section(": ", 1), {}});
    }
  } else {
    wires.push_back({tr("Not checked yet"), {}, {}});
  }
  wires_->show(wires);
}

void IdentifyPage::showButtons() {
  setAvailable(identify_,
               tr("Measure the motor's constants, its inertia, and what the current sensor's scale is worth"),
               bench_.obstacleToMake(RunKind::identification));
  setAvailable(wiring_,
               tr("A few small pulses tell whether motor, encoder and current sensor belong together; the shaft moves "
                  "by a tenth of a turn at most"),
               bench_.obstacleToMake(RunKind::wiring));
}

}  // namespace breakaway
