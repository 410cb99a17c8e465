#include "pages/tune_page.h"

#include <QButtonGroup>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <iterator>
#include <numbers>

#include "pages/run_state.h"
#include "session/bench_runs.h"
#include "session/connection.h"
#include "session/settings_edits.h"
#include "widgets/axis_units.h"
#include "widgets/bode_plot.h"
#include "widgets/controls.h"
#include "widgets/figure_chip.h"
#include "widgets/locus_plot.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/observer_noise_plot.h"
#include "widgets/quantity_slider.h"
#include "widgets/setting_words.h"
#include "widgets/step_plot.h"
#include "widgets/step_table.h"

namespace breakaway {

namespace {

constexpr int soon_ms = 25, plotsWidth = 320, stepBoxWidth = 136;

/// A round number above what is set, so that a slider has room both ways.
QuantityRange roomFor(double value, double otherwise) {
  const double most = std::max(10.0 * value, otherwise);
  const double magnitude = std::pow(10.0, std::floor(std::log10(most)));
  const int decimals = std::clamp(4 - static_cast<int>(std::floor(std::log10(magnitude))), 0, 8);
  return {0.0, std::ceil(most / magnitude) * magnitude, decimals, true};
}

bool isOfPosition(double ControllerSettings::*field) {
  return field == &ControllerSettings::position_kp_A_per_rad || field == &ControllerSettings::position_ki_A_per_rad_s ||
         field == &ControllerSettings::position_kd_A_s_per_rad;
}

/// A step in position as it is drawn: in degrees or mm.
void inShownPosition(StepCurve& curve, bool linear) {
  const double scale = linear ? 1e3 : 180.0 / std::numbers::pi;
  for (std::vector<double>* values : {&curve.velocity_rad_per_s, &curve.reference_rad_per_s})
    for (double& value : *values) value *= scale;
}

/// What the friction in it rests on is said where it isn't measured with care.
QString foretoldWords(FrictionSource friction) {
  switch (friction) {
    case FrictionSource::step:
      return TunePage::tr(
          "Foretold, friction as in the last step: rise %1 ms, overshoot %2 %, settling %3 ms, "
          "peak %4 A");
    case FrictionSource::wiring:
      return TunePage::tr(
          "Foretold, friction by the wiring check: rise %1 ms, overshoot %2 %, settling %3 ms, "
          "peak %4 A");
    case FrictionSource::none:
      return TunePage::tr("Foretold, friction unknown: rise %1 ms, overshoot %2 %, settling %3 ms, peak %4 A");
    case FrictionSource::identification:
    case FrictionSource::benchFile:
      break;
  }
  return TunePage::tr("Foretold: rise %1 ms, overshoot %2 %, settling %3 ms, peak %4 A");
}

QString toneOf(Grade grade) {
  return grade == Grade::good ? "good" : grade == Grade::warning ? "warning" : "trouble";
}

QWidget* titled(QWidget* parent, const QString& title, QWidget* plot) {
  auto* frame = card(parent);
  columnOf(frame)->setContentsMargins(12, 8, 8, 8);
  columnOf(frame)->setSpacing(4);
  if (!title.isEmpty()) {
    auto* words = new QLabel(title, frame);
    words->setFont(typed(Type::caption));
    columnOf(frame)->addWidget(words);
  }
  columnOf(frame)->addWidget(plot, 1);
  return frame;
}

}  // namespace

TunePage::TunePage(Connection& connection, BenchRuns& bench, SettingsEdits& edits, QWidget* parent)
    : Page("tunePage", tr("Tune"), parent), connection_(connection), bench_(bench), edits_(edits) {
  setHead(tr("Tune"), tr("The step moves with the sliders; the board keeps its values until Apply."));
  apply_ = addPrimary("applyButton", tr("Apply"));
  measure_ = addSecondary("measureStepButton", tr("Measure a step"));
  forget_ = addSecondary("forgetStepsButton", tr("Clear steps"));
  settings()->addWidget(buildControls());
  settings()->addStretch(1);
  picture()->addWidget(buildChips());
  picture()->addWidget(buildPlots(), 1);
  addReading("tuneReading");
  soon_.setSingleShot(true);
  soon_.setInterval(soon_ms);
  connect(&soon_, &QTimer::timeout, this, &TunePage::foretell);
  connect(apply_, &QPushButton::clicked, this, [this] { edits_.apply(); });
  connect(measure_, &QPushButton::clicked, this, &TunePage::measure);
  connect(forget_, &QPushButton::clicked, &bench_, &BenchRuns::forgetSteps);
  connect(&connection_, &Connection::changed, this, &TunePage::meetBoard);
  connect(&edits_, &SettingsEdits::changed, this, &TunePage::showSliders);
  connect(&connection_, &Connection::runChanged, this, &TunePage::showMotion);
  connect(&bench_, &BenchRuns::knownChanged, &soon_, qOverload<>(&QTimer::start));
  connect(&bench_, &BenchRuns::tuningChanged, this, &TunePage::showEdits);
  connect(&bench_, &BenchRuns::measured, this, &TunePage::showSteps);
  connect(&bench_, &BenchRuns::measured, &soon_, qOverload<>(&QTimer::start));  // a step tells the friction
  connect(&bench_, &BenchRuns::measured, this, &TunePage::showMotion);
  meetBoard();
  showSteps();
}

QuantitySlider* TunePage::addSlider(const QString& objectName, double ControllerSettings::*field) {
  const SettingWords words = settingWords(field, Axis::rotary);
  auto* slider = new QuantitySlider(objectName, words.title, words.unit, words.meaning, this);
  sliders_.push_back({slider, field});
  connect(slider, &QuantitySlider::chosen, this, [this, field](double value) {
    ControllerSettings wanted = edits_.edited();
    wanted.*field = value;
    edits_.edit(wanted);
  });
  return slider;
}

QWidget* TunePage::buildTuning() {
  auto* group = new QWidget(this);
  auto* column = columnIn(group, 8);
  source_ = caption(group, {});
  column->addWidget(source_);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  const std::pair<const char*, QString> names[] = {
      {"tuneSoftButton", tr("Soft")}, {"tuneMediumButton", tr("Medium")}, {"tuneStiffButton", tr("Stiff")}};
  for (size_t k = 0; k < std::size(names); ++k) {
    auto* button = pushButton(group, names[k].first, names[k].second);
    connect(button, &QPushButton::clicked, this,
            [this, k] { bench_.tune(static_cast<Stiffness>(k), edits_.edited()); });
    row->addWidget(button, 1);
    stiffness_.push_back(button);
  }
  column->addLayout(row);
  return group;
}

QWidget* TunePage::buildUndo() {
  auto* group = new QWidget(this);
  auto* row = rowIn(group, 8);
  undo_ = pushButton(group, "undoButton", tr("Undo"));
  redo_ = pushButton(group, "redoButton", tr("Redo"));
  revert_ = pushButton(group, "revertButton", tr("Revert"));
  for (QPushButton* button : {undo_, redo_, revert_}) row->addWidget(button, 1);
  connect(undo_, &QPushButton::clicked, &edits_, &SettingsEdits::undo);
  connect(redo_, &QPushButton::clicked, &edits_, &SettingsEdits::redo);
  connect(revert_, &QPushButton::clicked, &edits_, &SettingsEdits::revertAll);
  return group;
}

QWidget* TunePage::buildControls() {
  auto* side = card(this);
  auto* column = columnOf(side);
  column->setSpacing(10);
  column->addWidget(buildLoops());
  column->addWidget(buildTuning());
  column->addWidget(addSlider("kp", &ControllerSettings::velocity_kp_A_s_per_rad));
  column->addWidget(addSlider("ki", &ControllerSettings::velocity_ki_A_per_rad));
  column->addWidget(addSlider("kd", &ControllerSettings::velocity_kd_A_s2_per_rad));
  column->addWidget(addSlider("positionKp", &ControllerSettings::position_kp_A_per_rad));
  column->addWidget(addSlider("positionKi", &ControllerSettings::position_ki_A_per_rad_s));
  column->addWidget(addSlider("positionKd", &ControllerSettings::position_kd_A_s_per_rad));
  column->addWidget(addSlider("cutoff", &ControllerSettings::observer_cutoff_rad_per_s));
  column->addWidget(buildStep());
  column->addWidget(buildUndo());
  showLoop(false);
  return side;
}

/// The current loop and the speed's observer follow from the board's tick, and are none of its settings.
QWidget* TunePage::buildLoops() {
  auto* group = new QWidget(this);
  auto* row = rowIn(group, 4);
  auto* loops = new QButtonGroup(group);
  velocityLoop_ = chipButton(group, "velocityLoopTab", tr("Velocity loop"),
                             tr("Gains, margins and step of the loop that holds a speed"));
  positionLoop_ = chipButton(group, "positionLoopTab", tr("Position loop"), {});
  for (QPushButton* tab : {velocityLoop_, positionLoop_}) {
    loops->addButton(tab);
    row->addWidget(tab, 1);
    connect(tab, &QPushButton::clicked, this, [this, tab] { showLoop(tab == positionLoop_); });
  }
  return group;
}

QWidget* TunePage::buildStep() {
  auto* group = new QWidget(this);
  auto* row = rowIn(group);
  auto* name = new QLabel(tr("Step from 0 to"), group);
  row->addWidget(name, 1);
  const auto box = [&](const char* objectName, const QString& accessible, const QString& tip) {
    auto* one = new QDoubleSpinBox(group);
    one->setObjectName(objectName);
    one->setAccessibleName(accessible);
    one->setAlignment(Qt::AlignRight);
    one->setToolTip(tip);
    one->setFixedSize(stepBoxWidth, 28);
    connect(one, &QDoubleSpinBox::valueChanged, &soon_, qOverload<>(&QTimer::start));
    row->addWidget(one);
    return one;
  };
  height_ = box("stepHeight", tr("Velocity step"), tr("From standstill to this velocity"));
  travel_ = box("stepTravel", tr("Position step"), tr("From where it stands to a place so far from there"));
  name->setBuddy(height_);
  return group;
}

void TunePage::showLoop(bool position) {
  position_ = position;
  (position ? positionLoop_ : velocityLoop_)->setChecked(true);
  for (const Slider& slider : sliders_) {
    const bool ofBoth = slider.field == &ControllerSettings::observer_cutoff_rad_per_s;
    slider.widget->setVisible(ofBoth || isOfPosition(slider.field) == position);
  }
  height_->setVisible(!position);
  travel_->setVisible(position);
  if (plot_ == nullptr) return;  // the page is being built
  wordForAxis();
  showMotion();
  foretell();
}

void TunePage::showCurve() {
  StepCurve curve = preview_.step, onBoard = onBoard_.step;
  if (position_) {
    for (StepCurve* one : {&curve, &onBoard}) inShownPosition(*one, connection_.linear());
  }
  plot_->setQuantity(position_ ? (connection_.linear() ? tr("Position (mm)") : tr("Angle (°)"))
                               : tr("Speed (%1)").arg(unitsOf(connection_.identity().axis).speed));
  plot_->foretell(curve, onBoard);
}

QWidget* TunePage::buildChips() {
  auto* group = new QWidget(this);
  chips_ = new QGridLayout(group);
  chips_->setContentsMargins(0, 0, 0, 0);
  chips_->setSpacing(8);
  phase_ = new FigureChip("phaseMarginChip", tr("Phase margin"), group);
  gain_ = new FigureChip("gainMarginChip", tr("Gain margin"), group);
  rule_ = new FigureChip("alphaChip", tr("αgT"), group);
  noise_ = new FigureChip("noiseChip", tr("Current noise"), group);
  arrangeChips(4);
  return group;
}

void TunePage::arrangeChips(int columns) {
  int at = 0;
  for (FigureChip* chip : {phase_, gain_, rule_, noise_}) {
    chips_->addWidget(chip, at / columns, at % columns);
    ++at;
  }
  for (int column = 0; column < at; ++column) chips_->setColumnStretch(column, column < columns ? 1 : 0);
}

QWidget* TunePage::buildPlots() {
  auto* group = new QWidget(this);
  auto* row = rowIn(group, 8);
  auto* left = new QVBoxLayout;
  left->setSpacing(8);
  plot_ = new StepPlot(group);
  table_ = new StepTable(group);
  left->addWidget(titled(group, {}, plot_), 1);
  left->addWidget(table_);
  auto* right = new QVBoxLayout;
  right->setSpacing(8);
  bode_ = new BodePlot(group);
  right->addWidget(titled(group, {}, bode_), 1);
  right->addWidget(titled(group, {}, buildLocusOrNoise(group)), 1);
  loops_ = new QWidget(group);
  loops_->setFixedWidth(plotsWidth);
  loops_->setLayout(right);
  right->setContentsMargins(0, 0, 0, 0);
  row->addLayout(left, 1);
  row->addWidget(loops_);
  return group;
}

/// One of the two at a time.
QWidget* TunePage::buildLocusOrNoise(QWidget* parent) {
  auto* group = new QWidget(parent);
  auto* column = columnIn(group, 4);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  auto* tabs = new QButtonGroup(group);
  locus_ = new LocusPlot(group);
  observerNoise_ = new ObserverNoisePlot(group);
  auto* poles = chipButton(group, "polesTab", tr("Poles over g (1/s)"), tr("Poles of the closed loop as g grows"));
  auto* noise = chipButton(group, "observerNoiseTab", tr("Noise (mA)"),
                           tr("The current's noise with these gains, were the board's speed observer slower or faster "
                              "(rad/s); dashed: 2 % of the current limit"));
  for (QPushButton* tab : {poles, noise}) {
    tabs->addButton(tab);
    row->addWidget(tab);
  }
  row->addStretch(1);
  poles->setChecked(true);
  observerNoise_->setVisible(false);
  connect(noise, &QPushButton::toggled, this, [this](bool shown) {
    locus_->setVisible(!shown);
    observerNoise_->setVisible(shown);
  });
  column->addLayout(row);
  column->addWidget(locus_, 1);
  column->addWidget(observerNoise_, 1);
  return group;
}

/// Where all of it has no room, the step stays, with what it came to.
void TunePage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  const bool whole = !narrow();
  if (whole_ == whole) return;
  whole_ = whole;
  loops_->setVisible(whole);
  table_->setWhole(whole);  // the gains stand in the parameters
  arrangeChips(whole ? 4 : 2);
  // At once: a plot of the room that was left before would be seen for a moment.
  for (QLayout* one : {static_cast<QLayout*>(chips_), loops_->parentWidget()->layout(), layout()}) one->activate();
}

void TunePage::wordForAxis() {
  const Axis axis = connection_.identity().axis;
  if (axis == worded_) return;
  worded_ = axis;
  const AxisUnits units = unitsOf(axis);
  for (const Slider& slider : sliders_) slider.widget->setUnit(settingWords(slider.field, axis).unit);
  const bool linear = axis == Axis::linear;
  height_->setDecimals(linear ? 3 : 1);
  height_->setRange(linear ? 0.01 : 1.0, linear ? 10.0 : 300.0);
  height_->setSingleStep(linear ? 0.01 : 1.0);
  height_->setValue(linear ? 0.1 : 20.0);
  height_->setSuffix(" " + units.speed);
  travel_->setDecimals(linear ? 2 : 1);
  travel_->setRange(linear ? 0.01 : 0.1, linear ? 100.0 : 360.0);
  travel_->setValue(linear ? 1.0 : 5.0);
  travel_->setSuffix(linear ? tr(" mm") : tr("°"));
}

void TunePage::meetBoard() {
  wordForAxis();
  const ControllerSettings& now = edits_.before();
  const bool positions = !connection_.connected() || connection_.identity().can.positions;
  setAvailable(positionLoop_, positions, tr("Gains, margins and step of the loop that holds a position"),
               tr("This board takes no position commands"));
  if (position_ && !positions) showLoop(false);
  for (const Slider& slider : sliders_) {
    const double kp = isOfPosition(slider.field) ? now.position_kp_A_per_rad : now.velocity_kp_A_s_per_rad;
    const bool cutoff = slider.field == &ControllerSettings::observer_cutoff_rad_per_s;
    const bool derivative = slider.field == &ControllerSettings::velocity_kd_A_s2_per_rad;
    const double otherwise = cutoff ? 2000.0 : derivative ? 0.01 * kp : 10.0 * kp;
    slider.widget->setRange(roomFor(now.*slider.field, std::max(otherwise, 1e-6)));
  }
  showSliders();
  showMotion();
}

void TunePage::showSliders() {
  const QString obstacle = bench_.gainsObstacle();
  for (const Slider& slider : sliders_) {
    slider.widget->show(edits_.edited().*slider.field);
    slider.widget->setOnBoard(connection_.connected() ? std::optional(edits_.accepted().*slider.field) : std::nullopt);
    slider.widget->setAvailable(obstacle.isEmpty(), obstacle);
  }
  showEdits();
  soon_.start();
}

void TunePage::showEdits() {
  const size_t count = edits_.count();
  const QString obstacle = bench_.gainsObstacle();
  apply_->setText(count == 0 ? tr("Apply") : count == 1 ? tr("Apply 1 edit") : tr("Apply %1 edits").arg(count));
  setAvailable(apply_, tr("Send all edits to the board, those in Parameters too; what it accepts is shown"),
               !obstacle.isEmpty() ? obstacle
               : count == 0        ? tr("Nothing is edited: the board has what is shown")
                                   : QString());
  setAvailable(undo_, edits_.canUndo(), tr("Take the last edit back"), tr("There is no edit to take back"));
  setAvailable(redo_, edits_.canRedo(), tr("Make the edit again that was taken back"), tr("No edit was taken back"));
  setAvailable(revert_, count > 0, tr("Back to what the board has"), tr("Nothing is edited"));
  source_->setText(connection_.connected() ? tr("Automatically, by the motor's %1").arg(bench_.motor().source)
                                           : tr("Automatically"));
  for (QPushButton* button : stiffness_)
    setAvailable(button, tr("Sets gains whose margins hold for what is known of the motor; Apply sends them"),
                 bench_.tuningObstacle());
  StepState state = stateOf(connection_, {RunKind::step, RunKind::positionStep});
  if (state.mark == StepMark::open && !bench_.steps().empty())
    state = {StepMark::done, tr("%1 measured").arg(bench_.steps().size())};
  if (count > 0) state = {StepMark::paused, tr("%1 not applied").arg(count)};
  setState(state);
}

VelocityStepOptions TunePage::step() const {
  return {.to_rad_per_s = height_->value(), .axis = connection_.identity().axis};
}

PositionStepOptions TunePage::positionStep() const {
  const double scale = connection_.linear() ? 1e-3 : std::numbers::pi / 180.0;
  return {.by_rad = travel_->value() * scale, .axis = connection_.identity().axis};
}

void TunePage::foretell() {
  preview_ = onBoard_ = {};
  if (connection_.connected() && bench_.gainsObstacle().isEmpty()) {
    const KnownMotor motor = bench_.motor();
    const KnownFriction friction = knownFriction(bench_.bench(), bench_.known(), bench_.steps(), motor.values);
    frictionSource_ = friction.source;
    PreviewQuestion question{connection_.identity(), edits_.edited(), motor, friction.coulomb_Nm, step()};
    question.mode = position_ ? ServoMode::position : ServoMode::velocity;
    question.to_rad = positionStep().by_rad;
    question.static_Nm = friction.static_Nm;
    preview_ = previewOf(question);
    question.settings = edits_.accepted();
    if (edits_.count() > 0) onBoard_ = previewOf(question);
  }
  showCurve();
  bode_->show(preview_.response, preview_.margins, onBoard_.response);
  locus_->show(preview_.locus, edits_.edited().observer_cutoff_rad_per_s, preview_.tick_s, onBoard_.locus,
               edits_.accepted().observer_cutoff_rad_per_s);
  for (const Slider& slider : sliders_)
    if (slider.field == &ControllerSettings::observer_cutoff_rad_per_s)
      slider.widget->setRule(preview_.tick_s > 0.0 ? std::optional(preview_.ruleOfThumb_rad_per_s) : std::nullopt);
  observerNoise_->show(preview_.observerNoise, goodNoise_A(edits_.edited().current_limit_A));
  showChips();
  showSteps();
}

void TunePage::showChips() {
  const TuningPreview& now = preview_;
  if (now.tick_s <= 0.0) {
    for (FigureChip* chip : {phase_, gain_, rule_, noise_})
      chip->show(tr("–"), connection_.connected() ? now.trouble : tr("no board"), {});
    read(now.trouble);
    return;
  }
  const bool stable = now.margins.stable;
  const auto bounded = [](double value, const QString& text) { return std::isfinite(value) ? text : tr("any"); };
  const double phase_deg = now.margins.phaseMargin_rad * 180.0 / std::numbers::pi;
  phase_->show(stable ? bounded(phase_deg, tr("%1°").arg(fixedText(phase_deg, 1))) : tr("none"),
               stable ? QString("≥ 45°") : tr("unstable"), toneOf(gradeOfPhase(now.margins)));
  gain_->show(stable ? bounded(now.margins.gainMargin, numberText(now.margins.gainMargin)) : tr("none"),
              stable ? QString("≥ 2.5") : tr("unstable"), toneOf(gradeOfGain(now.margins)));
  rule_->show(numberText(now.alphaGT, 2), QString("≤ 0.3"), toneOf(gradeOfAlphaGT(now.alphaGT)));
  noise_->show(stable ? tr("%1 mA").arg(numberText(1e3 * now.currentNoise_A)) : tr("–"),
               QString("≤ %1 mA").arg(numberText(1e3 * goodNoise_A(edits_.edited().current_limit_A), 2)),
               stable ? toneOf(gradeOfNoise(now.currentNoise_A, edits_.edited().current_limit_A)) : "trouble");
  if (!stable) {
    read(tr("Unstable: the loop would swing up by itself. Lower the gain or the cutoff."));
  } else if (gradeOfAlphaGT(now.alphaGT) != Grade::good) {
    read(tr("αgT is beyond its rule of thumb; g up to %1 rad/s keeps it").arg(numberText(now.ruleOfThumb_rad_per_s)));
  } else {
    read(foretoldWords(frictionSource_)
             .arg(milliseconds(now.figures.rise_s), overshootPercent(now.figures.overshoot),
                  milliseconds(now.figures.settling_s), numberText(now.figures.peakCurrent_A)));
  }
}

void TunePage::showMotion() {
  const auto highest = bench_.highestStep();
  if (highest) height_->setMaximum(*highest);
  if (const auto longest = bench_.longestStep()) travel_->setMaximum(1e3 * *longest);
  const QString motion =
      connection_.linear()
          ? tr("Goes to the lower end of the travel, then the step forwards, measured and stopped again, with what the "
               "board has now")
      : position_
          ? tr("Holds the shaft for 0.8 s, then the step, measured and let go, with what the board has now")
          : tr("Turns up to 2 s: standstill, then the step, measured and stopped again, with what the board has "
               "now");
  setAvailable(measure_, motion, bench_.stepObstacle());
  showEdits();
}

void TunePage::measure() {
  position_ ? bench_.measureStep(positionStep()) : bench_.measureStep(step());
}

/// Of the loop that is shown.
void TunePage::showSteps() {
  std::vector<StepResult> steps;
  for (const StepResult& one : bench_.steps()) {
    if ((one.kind == RunKind::positionStep) != position_) continue;
    steps.push_back(one);
    if (position_) inShownPosition(steps.back().curve, connection_.linear());
  }
  plot_->show(steps);
  const StepResult foretold{{}, preview_.figures, {}, edits_.edited()};
  table_->show(steps, preview_.step.time_s.empty() ? nullptr : &foretold, position_, connection_.identity().axis);
  setAvailable(forget_, !bench_.steps().empty(), tr("Forget all measured steps, of both loops"),
               tr("No step was measured"));
}

}  // namespace breakaway
