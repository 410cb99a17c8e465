#include "pages/tune_page.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>
#include <iterator>

#include "session/bench_runs.h"
#include "session/connection.h"
#include "widgets/axis_units.h"
#include "widgets/controls.h"
#include "widgets/quantity_slider.h"
#include "widgets/step_plot.h"
#include "widgets/table.h"

namespace breakaway {

namespace {

/// A round number above what is set, so that a slider has room both ways.
QuantityRange roomFor(double value, double otherwise) {
  const double most = std::max(10.0 * value, otherwise);
  const double magnitude = std::pow(10.0, std::floor(std::log10(most)));
  const int decimals = std::clamp(4 - static_cast<int>(std::floor(std::log10(magnitude))), 0, 8);
  return {0.0, std::ceil(most / magnitude) * magnitude, decimals, true};
}

QString milliseconds(double time_s) {
  return std::isfinite(time_s) ? QString::number(1e3 * time_s, 'f', 1) : TunePage::tr("not reached");
}

}  // namespace

TunePage::TunePage(Connection& connection, BenchRuns& bench, QWidget* parent)
    : Page("tunePage", tr("Tune"), "tune", parent), connection_(connection), bench_(bench) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 12, 16, 8);
  row->setSpacing(20);
  row->addWidget(buildControls());
  row->addWidget(buildResults(), 1);
  connect(&connection_, &Connection::changed, this, &TunePage::scaleSliders);
  connect(&connection_, &Connection::settingsChanged, this, &TunePage::showSettings);
  connect(&bench_, &BenchRuns::knownChanged, this, &TunePage::showMargins);
  connect(&bench_, &BenchRuns::tuningChanged, this, &TunePage::showMargins);
  connect(&connection_, &Connection::runChanged, this, &TunePage::showMotion);
  connect(&bench_, &BenchRuns::measured, this, &TunePage::showSteps);
  connect(&bench_, &BenchRuns::measured, this, &TunePage::showMotion);
  scaleSliders();
  showSteps();
}

QuantitySlider* TunePage::addSlider(const QString& objectName, const QString& title, const QString& unit,
                                    const QString& help, double ControllerSettings::*field) {
  auto* slider = new QuantitySlider(objectName, title, unit, help, this);
  sliders_.push_back({slider, field});
  connect(slider, &QuantitySlider::chosen, this, [this, field](double value) {
    ControllerSettings wanted = connection_.settings();
    wanted.*field = value;
    connection_.configure(wanted);
  });
  return slider;
}

QWidget* TunePage::buildTuning() {
  auto* group = new QWidget(this);
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  const std::pair<const char*, QString> names[] = {
      {"tuneSoftButton", tr("Soft")}, {"tuneMediumButton", tr("Medium")}, {"tuneStiffButton", tr("Stiff")}};
  for (size_t k = 0; k < std::size(names); ++k) {
    auto* button = pushButton(group, names[k].first, names[k].second);
    connect(button, &QPushButton::clicked, this, [this, k] { bench_.tune(static_cast<Stiffness>(k)); });
    row->addWidget(button, 1);
    stiffness_.push_back(button);
  }
  margins_ = explanation(group, {}, "marginLine");
  column->addLayout(row);
  column->addWidget(margins_);
  return group;
}

QWidget* TunePage::buildControls() {
  auto* side = new QWidget(this);
  side->setFixedWidth(320);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  column->addWidget(heading(side, tr("Velocity loop")));
  column->addWidget(buildTuning());
  column->addWidget(addSlider("kp", tr("Proportional gain Kp"), tr("A s/rad"),
                              tr("Current per velocity error; applied at once"),
                              &ControllerSettings::velocity_kp_A_s_per_rad));
  column->addWidget(addSlider("ki", tr("Integral gain Ki"), tr("A/rad"),
                              tr("Current per accumulated velocity error; applied at once"),
                              &ControllerSettings::velocity_ki_A_per_rad));
  column->addWidget(addSlider("kd", tr("Derivative gain Kd"), tr("A s²/rad"),
                              tr("Current per change of the velocity error; applied at once"),
                              &ControllerSettings::velocity_kd_A_s2_per_rad));
  column->addWidget(addSlider("cutoff", tr("Observer cutoff g"), tr("rad/s"),
                              tr("Bandwidth of the disturbance observer's feedback; 0 switches the feedback off"),
                              &ControllerSettings::observer_cutoff_rad_per_s));
  column->addSpacing(4);
  auto* form = new QFormLayout;
  height_ = new QDoubleSpinBox(side);
  height_->setObjectName("stepHeight");
  height_->setAccessibleName(tr("Velocity step"));
  height_->setAlignment(Qt::AlignRight);
  height_->setToolTip(tr("From standstill to this velocity"));
  form->addRow(tr("Step from 0 to"), height_);
  column->addLayout(form);
  auto* buttons = new QHBoxLayout;
  measure_ = pushButton(side, "measureStepButton", tr("Measure step"));
  forget_ = pushButton(side, "forgetStepsButton", tr("Clear steps"));
  buttons->addWidget(measure_, 1);
  buttons->addWidget(forget_, 1);
  column->addLayout(buttons);
  column->addStretch(1);
  connect(measure_, &QPushButton::clicked, this, &TunePage::measure);
  connect(forget_, &QPushButton::clicked, &bench_, &BenchRuns::forgetSteps);
  return side;
}

QWidget* TunePage::buildResults() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  plot_ = new StepPlot(side);
  table_ = readTable(side, "stepTable", tr("Measured steps"), QStringList(9, QString()));
  table_->setFixedHeight(116);
  column->addWidget(plot_, 1);
  column->addWidget(table_);
  return side;
}

void TunePage::wordForAxis() {
  const Axis axis = connection_.identity().axis;
  if (axis == worded_) return;
  worded_ = axis;
  const AxisUnits units = unitsOf(axis);
  for (const Slider& slider : sliders_) {
    if (slider.field == &ControllerSettings::velocity_kp_A_s_per_rad) slider.widget->setUnit(units.gain);
    if (slider.field == &ControllerSettings::velocity_ki_A_per_rad) slider.widget->setUnit(units.integral);
    if (slider.field == &ControllerSettings::velocity_kd_A_s2_per_rad) slider.widget->setUnit(units.derivative);
  }
  const bool linear = axis == Axis::linear;
  height_->setDecimals(linear ? 3 : 1);
  height_->setRange(linear ? 0.01 : 1.0, linear ? 10.0 : 300.0);
  height_->setSingleStep(linear ? 0.01 : 1.0);
  height_->setValue(linear ? 0.1 : 20.0);
  height_->setSuffix(" " + units.speed);
  plot_->setSpeedUnit(units.speed);
  table_->setHorizontalHeaderLabels({tr("Step"), tr("Kp (%1)").arg(units.gain), tr("Ki (%1)").arg(units.integral),
                                     tr("Kd (%1)").arg(units.derivative), tr("g (rad/s)"), tr("Rise (ms)"),
                                     tr("Overshoot (%)"), tr("Settling (ms)"), tr("Peak (A)")});
}

void TunePage::scaleSliders() {
  wordForAxis();
  const ControllerSettings& settings = connection_.settings();
  const double kp = settings.velocity_kp_A_s_per_rad;
  for (const Slider& slider : sliders_) {
    const bool cutoff = slider.field == &ControllerSettings::observer_cutoff_rad_per_s;
    const bool derivative = slider.field == &ControllerSettings::velocity_kd_A_s2_per_rad;
    const double otherwise = cutoff ? 2000.0 : derivative ? 0.01 * kp : 10.0 * kp;
    slider.widget->setRange(roomFor(settings.*slider.field, std::max(otherwise, 1e-6)));
  }
  showSettings();
}

void TunePage::showSettings() {
  for (const Slider& slider : sliders_) {
    slider.widget->show(connection_.settings().*slider.field);
    slider.widget->setAvailable(bench_.gainsObstacle().isEmpty(), bench_.gainsObstacle());
  }
  showMargins();
  showMotion();
}

void TunePage::showMargins() {
  const QString tip = tr("Gains whose margins hold for what is known of the motor (%1)").arg(bench_.motor().source);
  for (QPushButton* button : stiffness_) setAvailable(button, tip, bench_.tuningObstacle());
  margins_->setText(bench_.marginLine());
}

void TunePage::showMotion() {
  const auto highest = bench_.highestStep();
  if (highest) height_->setMaximum(*highest);
  setAvailable(measure_,
               connection_.linear()
                   ? tr("Goes to the lower end of the travel, then the step forwards, measured and stopped "
                        "again")
                   : tr("Turns up to 2 s: standstill, then the step, measured and stopped again"),
               bench_.stepObstacle());
}

void TunePage::measure() {
  VelocityStepOptions options;
  options.to_rad_per_s = height_->value();
  bench_.measureStep(options);
}

void TunePage::showSteps() {
  const auto& steps = bench_.steps();
  plot_->show(steps);
  table_->setRowCount(static_cast<int>(steps.size()));
  for (size_t k = 0; k < steps.size(); ++k) {
    const StepResult& step = steps[steps.size() - 1 - k];  // the newest on top
    const auto number = [](double value) { return QString::number(value, 'g', 4); };
    fillRow(*table_, static_cast<int>(k),
            {QString::number(steps.size() - k), number(step.settings.velocity_kp_A_s_per_rad),
             number(step.settings.velocity_ki_A_per_rad), number(step.settings.velocity_kd_A_s2_per_rad),
             number(step.settings.observer_cutoff_rad_per_s), milliseconds(step.figures.rise_s),
             QString::number(100.0 * step.figures.overshoot, 'f', 1), milliseconds(step.figures.settling_s),
             QString::number(step.figures.peakCurrent_A, 'f', 2)});
  }
  setAvailable(forget_, !steps.empty(), tr("Forget all measured steps"), tr("No step was measured"));
}

}  // namespace breakaway
