#include "pages/hand_page.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "base/numbers.h"
#include "pages/run_state.h"
#include "session/bench_runs.h"
#include "session/connection.h"
#include "session/language.h"
#include "session/live_samples.h"
#include "widgets/axis_units.h"
#include "widgets/controls.h"
#include "widgets/live_channels.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/position_view.h"
#include "widgets/while_shown.h"

using namespace std::chrono_literals;

namespace breakaway {

namespace {

constexpr int handBoxWidth = 144;
constexpr auto shownEvery = 100ms;

QDoubleSpinBox* numberBox(QWidget* parent, const char* objectName, const QString& name, const QString& tip) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(objectName);
  box->setAccessibleName(name);
  box->setToolTip(tip);
  box->setAlignment(Qt::AlignRight);
  box->setFixedWidth(handBoxWidth);
  return box;
}

}  // namespace

HandPage::HandPage(Connection& connection, BenchRuns& bench, const LiveSamples& live, QWidget* parent)
    : Page("handPage", tr("Drive by hand"), parent), connection_(connection), bench_(bench), live_(live) {
  setFocusPolicy(Qt::ClickFocus);
  setHead(tr("Drive by hand"), tr("The motor runs while a button is held, and its windings open when it is let go."));
  settings()->addWidget(buildSettings());
  settings()->addWidget(buildStep());
  settings()->addStretch(1);
  picture()->addWidget(buildNumbers());
  picture()->addWidget(buildButtons());
  picture()->addWidget(new PositionView(connection, bench, live, this), 1);
  addReading("handReading");
  connect(&connection_, &Connection::changed, this, &HandPage::showState);
  connect(&connection_, &Connection::runChanged, this, &HandPage::showState);
  connect(&bench_, &BenchRuns::measured, this, &HandPage::showState);
  new WhileShown(this, shownEvery, [this] { return showNumbers(); });
  wordForAxis();
  choose(HandMode::speed);
  showState();
}

QWidget* HandPage::buildSettings() {
  auto* group = card(this);
  columnOf(group)->addWidget(section(group, tr("What is held")));
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  const std::pair<const char*, QString> names[] = {
      {"handVoltage", tr("Voltage")}, {"handCurrent", tr("Current")}, {"handSpeed", tr("Speed")}};
  for (size_t k = 0; k < modes_.size(); ++k) {
    modes_[k] = chipButton(group, names[k].first, names[k].second, tr("Hold this at the value below"));
    row->addWidget(modes_[k], 1);
    connect(modes_[k], &QPushButton::clicked, this, [this, k] { choose(static_cast<HandMode>(k)); });
  }
  columnOf(group)->addLayout(row);
  target_ = numberBox(group, "handTarget", tr("Value"), tr("What is held, either way"));
  mostSpeed_ = numberBox(group, "handMostSpeed", tr("Highest speed"), tr("Faster than this, the motor is let go"));
  most_A_ = numberBox(group, "handMostCurrent", tr("Highest current"), tr("The current is held within this"));
  auto* grid = new QGridLayout;
  grid->setColumnStretch(0, 1);
  grid->setVerticalSpacing(4);
  int at = 0;
  for (QDoubleSpinBox* box : {target_, mostSpeed_, most_A_}) {
    auto* name = new QLabel(box->accessibleName(), group);
    name->setBuddy(box);
    grid->addWidget(name, at, 0);
    grid->addWidget(box, at++, 1);
  }
  columnOf(group)->addLayout(grid);
  most_A_->setRange(0.05, 100.0);
  most_A_->setSuffix(tr(" A"));
  most_A_->setValue(1.0);
  connect(target_, &QDoubleSpinBox::valueChanged, this,
          [this](double value) { targets_[static_cast<size_t>(mode_)] = value; });
  return group;
}

QWidget* HandPage::buildStep() {
  auto* group = card(this);
  columnOf(group)->addWidget(section(group, tr("One step")));
  step_ = numberBox(group, "handStep", tr("Step"), tr("How far one press of a step button goes"));
  stepSpeed_ = numberBox(group, "handStepSpeed", tr("Speed of a step"), tr("How fast it goes there"));
  auto* grid = new QGridLayout;
  grid->setColumnStretch(0, 1);
  grid->setVerticalSpacing(4);
  int at = 0;
  for (QDoubleSpinBox* box : {step_, stepSpeed_}) {
    auto* name = new QLabel(box->accessibleName(), group);
    name->setBuddy(box);
    grid->addWidget(name, at, 0);
    grid->addWidget(box, at++, 1);
  }
  columnOf(group)->addLayout(grid);
  jogs_ = {pushButton(group, "jogBack", {}), pushButton(group, "jogOn", {})};
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  for (size_t k = 0; k < jogs_.size(); ++k) {
    row->addWidget(jogs_[k], 1);
    connect(jogs_[k], &QPushButton::clicked, this, [this, k] { jog(k == 0 ? -1.0 : 1.0); });
  }
  columnOf(group)->addLayout(row);
  return group;
}

QPushButton* HandPage::holdButton(QWidget* parent, const char* objectName, double way) {
  auto* button = pushButton(parent, objectName, {});
  button->setProperty("role", "hold");
  button->setFont(typed(Type::section));
  connect(button, &QPushButton::pressed, this, [this, way] { hold(way); });
  connect(button, &QPushButton::released, this, &HandPage::letGo);
  return button;
}

QWidget* HandPage::buildButtons() {
  auto* group = card(this);
  auto* row = new QHBoxLayout;
  row->setSpacing(16);
  buttons_ = {holdButton(group, "handBack", -1.0), holdButton(group, "handOn", 1.0)};
  for (QPushButton* button : buttons_) row->addWidget(button, 1);
  columnOf(group)->addLayout(row);
  return group;
}

QWidget* HandPage::buildNumbers() {
  auto* group = card(this);
  auto* row = new QHBoxLayout;
  for (size_t k = 0; k < numbers_.size(); ++k) {
    auto* column = new QVBoxLayout;
    units_[k] = caption(group, {});
    numbers_[k] = new QLabel(group);
    numbers_[k]->setFont(typed(Type::figure));
    column->addWidget(units_[k]);
    column->addWidget(numbers_[k]);
    row->addLayout(column, 1);
  }
  columnOf(group)->addLayout(row);
  return group;
}

void HandPage::choose(HandMode mode) {
  mode_ = mode;
  for (size_t k = 0; k < modes_.size(); ++k) modes_[k]->setChecked(k == static_cast<size_t>(mode));
  const double value = targets_[static_cast<size_t>(mode)];
  const bool linear = connection_.linear();
  switch (mode) {
    case HandMode::voltage:
      target_->setSuffix(tr(" V"));
      target_->setRange(0.0, connection_.connected() ? connection_.identity().supply_V : 100.0);
      break;
    case HandMode::current:
      target_->setSuffix(tr(" A"));
      target_->setRange(0.0, connection_.connected() ? connection_.settings().current_limit_A : 100.0);
      break;
    case HandMode::speed:
      target_->setSuffix(linear ? tr(" mm/s") : tr(" rad/s"));
      target_->setRange(0.0, linear ? 200.0 : 500.0);
      break;
  }
  target_->setValue(value);
}

QVariant HandPage::kept() const {
  return QVariantList{targets_[0], targets_[1], targets_[2]};
}

void HandPage::take(const QVariant& kept) {
  const QVariantList values = kept.toList();
  for (size_t k = 0; k < targets_.size(); ++k) targets_[k] = values.value(static_cast<qsizetype>(k)).toDouble();
  choose(mode_);
}

void HandPage::wordForAxis() {
  const bool linear = connection_.linear();
  if (worded_ == linear) return;
  worded_ = linear;
  mostSpeed_->setSuffix(linear ? tr(" mm/s") : tr(" rad/s"));
  mostSpeed_->setRange(1.0, 2000.0);
  mostSpeed_->setValue(linear ? 100.0 : 60.0);
  targets_[static_cast<size_t>(HandMode::speed)] = linear ? 20.0 : 5.0;
  const Axis axis = linear ? Axis::linear : Axis::rotary;
  buttons_[0]->setText(tr("◀  hold: %1").arg(wayName(Way::cw, axis)));
  buttons_[1]->setText(tr("hold: %1  ▶").arg(wayName(Way::ccw, axis)));
  for (size_t k = 0; k < buttons_.size(); ++k) buttons_[k]->setAccessibleName(buttons_[k]->text());
  step_->setSuffix(linear ? tr(" mm") : tr("°"));
  step_->setRange(linear ? 0.01 : 0.1, linear ? 1000.0 : 3600.0);
  step_->setValue(linear ? 5.0 : 10.0);
  stepSpeed_->setSuffix(linear ? tr(" mm/s") : tr(" rad/s"));
  stepSpeed_->setRange(0.1, linear ? 200.0 : 50.0);
  stepSpeed_->setValue(linear ? 20.0 : 2.0);
  const std::array<QString, 2> jogTexts{tr("◀  %1").arg(wayName(Way::cw, axis)),
                                        tr("%1  ▶").arg(wayName(Way::ccw, axis))};
  for (size_t k = 0; k < jogs_.size(); ++k) {
    jogs_[k]->setText(jogTexts[k]);
    jogs_[k]->setAccessibleName(tr("One step %1").arg(wayName(k == 0 ? Way::cw : Way::ccw, axis)));
  }
  const auto channels = liveChannels(linear);
  for (size_t k = 0; k < units_.size(); ++k) units_[k]->setText(channels[k].title());
  choose(mode_);
}

void HandPage::hold(double way) {
  if (!bench_.handObstacle().isEmpty()) return;
  const double metre = connection_.linear() ? 1e-3 : 1.0;
  HandOptions options;
  options.mode = mode_;
  options.target = way * target_->value() * (mode_ == HandMode::speed ? metre : 1.0);
  options.mostSpeed_rad_per_s = speedLimit();
  options.most_A = most_A_->value();
  grip_ = bench_.driveByHand(options);
}

double HandPage::speedLimit() const {
  return (connection_.linear() ? 1e-3 : 1.0) * mostSpeed_->value();
}

void HandPage::jog(double way) {
  if (!bench_.handObstacle().isEmpty()) return;
  const bool linear = connection_.linear();
  JogOptions options;
  options.by_rad = way * step_->value() * (linear ? 1e-3 : turn_rad / 360.0);
  options.speed_rad_per_s = (linear ? 1e-3 : 1.0) * stepSpeed_->value();
  options.mostSpeed_rad_per_s = speedLimit();
  options.most_A = most_A_->value();
  jogGrip_ = bench_.jog(options);
}

void HandPage::letGo() {
  if (grip_) grip_->held = false;
  grip_.reset();
}

void HandPage::leave() {
  letGo();
  if (jogGrip_) jogGrip_->held = false;
  jogGrip_.reset();
}

void HandPage::keyPressEvent(QKeyEvent* event) {
  const bool arrow = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
  if (!arrow) return Page::keyPressEvent(event);
  if (event->isAutoRepeat()) return;
  const double way = event->key() == Qt::Key_Left ? -1.0 : 1.0;
  if (event->modifiers() & Qt::ShiftModifier) {
    jog(way);
  } else {
    hold(way);
  }
}

void HandPage::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat()) letGo();
}

/// A key that is let go while another window has the keyboard is never heard of.
void HandPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ActivationChange && !isActiveWindow()) leave();
  Page::changeEvent(event);
}

void HandPage::hideEvent(QHideEvent* event) {
  leave();
  Page::hideEvent(event);
}

void HandPage::showState() {
  wordForAxis();
  const QString obstacle = bench_.handObstacle();
  for (QPushButton* button : buttons_)
    if (!button->isDown()) setAvailable(button, tr("Runs while it is held; the arrow keys do the same"), obstacle);
  for (QPushButton* button : jogs_)
    setAvailable(button, tr("Goes one step and stops; Shift with an arrow key does the same"), obstacle);
  StepState state = stateOf(connection_, {RunKind::hand});
  if (state.mark == StepMark::running) state.words = tr("moving");
  if (state.words.isEmpty()) state.words = obstacle.isEmpty() ? tr("runs while held") : tr("not now");
  setState(state);
  const RunSnapshot& run = connection_.run();
  const bool failed = run.kind == RunKind::hand && run.status.state == Procedure::State::failed;
  read(failed               ? inLanguage(run.status.failure)
       : obstacle.isEmpty() ? tr("Hold a button, or an arrow key after a click on the page")
                            : obstacle);
}

bool HandPage::showNumbers() {
  const auto newest = live_.current();
  const auto channels = liveChannels(live_.board().axis == Axis::linear);
  for (size_t k = 0; k < numbers_.size(); ++k)
    numbers_[k]->setText(newest ? steadyNumber(channels[k].of(*newest), channels[k].leastSpan) : tr("–"));
  return newest.has_value();
}

}  // namespace breakaway
