#include "widgets/motor_tests_plot.h"

#include <qcustomplot.h>

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "commission/known.h"
#include "commission/motor_tests.h"
#include "session/motor_test_curves.h"
#include "widgets/axis_units.h"
#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr size_t mostPoints = 2000;

/// One of so many that the picture has enough.
size_t strideOf(size_t points) {
  return std::max<size_t>(1, points / mostPoints);
}

TestCurve milli(TestCurve curve) {
  for (double& y : curve.y) y *= 1e3;
  return curve;
}

QVector<double> asVector(const std::vector<double>& values) {
  return QVector<double>(values.begin(), values.end());
}

}  // namespace

MotorTestsPlot::MotorTestsPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName("motorTestsPlot");
  auto* column = columnIn(this, 4);
  column->addWidget(buildChips());
  column->addWidget(plot_, 1);
  plot_->setAccessibleName(tr("What the motor was identified from: points as measured, lines as identified"));
  plot_->setToolTip(plot_->accessibleName());
  plot_->setMinimumSize(200, 80);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->setRowSpacing(2);
  plot_->plotLayout()->setColumnSpacing(16);
  for (size_t k = 0; k < halves_.size(); ++k) build(halves_[k], static_cast<int>(k));
  plot_->plotLayout()->setRowStretchFactors({1e-3, 1.0});
  hint_ = new QCPTextElement(plot_, tr("Identify the motor: what it shows standing and turning is drawn here"));
  halves_[0].rect->insetLayout()->addElement(hint_, Qt::AlignCenter);
  applyLook();
  onNewLook(this, [this] { applyLook(); });
}

void MotorTestsPlot::build(Half& half, int column) {
  half.title = new QCPTextElement(plot_);
  half.title->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
  half.title->setMargins(QMargins(8, 0, 8, 0));
  half.rect = new QCPAxisRect(plot_);
  half.rect->setMinimumMargins(QMargins(44, 7, 8, 3));
  plot_->plotLayout()->addElement(0, column, half.title);
  plot_->plotLayout()->addElement(1, column, half.rect);
  QCPAxis *across = half.rect->axis(QCPAxis::atBottom), *values = half.rect->axis(QCPAxis::atLeft);
  values->ticker()->setTickCount(4);
  half.points = plot_->addGraph(across, values);
  half.line = plot_->addGraph(across, values);
}

QWidget* MotorTestsPlot::buildChips() {
  auto* row = new QWidget(this);
  auto* chips = rowIn(row, 4);
  const auto add = [&](View view, const char* objectName, const QString& text, const QString& tip) {
    chips_[view] = chipButton(row, objectName, text, tip);
    chips->addWidget(chips_[view]);
    connect(chips_[view], &QPushButton::clicked, this, [this, view] { choose(view); });
  };
  add(all, "testsOfAll", tr("Overview"), tr("The line of the standing motor, and that of the turning one"));
  add(winding, "testsOfWinding", tr("Winding"), tr("Current over voltage, and what the line leaves of it"));
  add(spin, "testsOfSpin", tr("Spin"), tr("How fast the motor turned, and its back-EMF"));
  add(reversal, "testsOfReversal", tr("Reversal"), tr("Speed and current, and the speed that the inertia foretells"));
  chips->addStretch(1);
  return row;
}

void MotorTestsPlot::showChips(const Commission& known) {
  const QString notYet = tr("Not measured yet");
  for (int view = 0; view < views; ++view) {
    chips_[view]->setChecked(view == chosen_);
    const bool available = view == all || isThere(known, view);
    if (!chips_[view]->property("tip").isValid()) chips_[view]->setProperty("tip", chips_[view]->toolTip());
    setAvailable(chips_[view], available, chips_[view]->property("tip").toString(), notYet);
  }
  const bool linear = known.linear();
  chips_[spin]->setText(linear ? tr("Strokes") : tr("Spin"));
  chips_[reversal]->setVisible(!linear);
}

void MotorTestsPlot::choose(int view) {
  chosen_ = view >= 0 && view < views ? view : all;
  emit chosen();
}

bool MotorTestsPlot::isThere(const Commission& known, int view) {
  if (known.tests == nullptr || !known.knows(Known::windingTest)) return false;
  const size_t moving = known.tests->bridge.moving.size();
  return view == all || view == winding || (view == spin ? moving > 0 : moving > 1);
}

void MotorTestsPlot::show(const Commission& known) {
  if (!isThere(known, chosen_)) chosen_ = all;
  showChips(known);
  for (Half& half : halves_) {
    half.points->data()->clear();
    half.line->data()->clear();
    half.title->setText({});
    half.drawn = false;
  }
  if (isThere(known, chosen_)) {
    const auto& moving = known.tests->bridge.moving;
    const QString speed = tr("Speed (%1) over time (s)").arg(unitsOf(known.identity.axis).speed);
    switch (chosen_) {
      case winding:
        drawStanding(known);
        put(halves_[1], tr("What the line leaves of the current (mA) over voltage (V)"), milli(currentLeft(known)),
            false);
        break;
      case spin:
        put(halves_[0], speed, speedOverTime(moving[0]), true);
        drawTurning(known);
        break;
      case reversal: {
        put(halves_[0], speed, speedOverTime(moving[1]), true);
        const TestCurve foretold = foretoldSpeed(moving[1], known);
        if (known.knows(Known::motor)) halves_[0].line->setData(asVector(foretold.x), asVector(foretold.y), true);
        put(halves_[1], tr("Current (A) over time (s)"), currentOverTime(moving[1]), true);
        break;
      }
      default:
        drawStanding(known);
        drawTurning(known);
    }
  }
  hint_->setVisible(!halves_[0].drawn);
  // Each has its half of the width, and all of it while it is alone.
  plot_->plotLayout()->setColumnStretchFactors({1.0, halves_[1].drawn ? 1.0 : 1e-3});
  for (Half& half : halves_) {
    for (QCPAxis* axis : {half.rect->axis(QCPAxis::atBottom), half.rect->axis(QCPAxis::atLeft)}) {
      axis->setVisible(half.drawn);
      axis->grid()->setVisible(half.drawn);
      axis->rescale();
      axis->scaleRange(1.1);
    }
  }
  applyLook();
}

void MotorTestsPlot::put(Half& half, const QString& title, const TestCurve& curve, bool course) {
  half.title->setText(title);
  half.drawn = true;
  half.points->setLineStyle(course ? QCPGraph::lsLine : QCPGraph::lsNone);
  const size_t stride = course ? 1 : strideOf(curve.x.size());
  for (size_t k = 0; k < curve.x.size(); k += stride) half.points->addData(curve.x[k], curve.y[k]);
}

void MotorTestsPlot::drawStanding(const Commission& known) {
  const auto& points = known.tests->bridge.standing;
  const WindingLine& line = known.tests->winding.line;
  TestCurve measured;
  double reach_V = 0.0;
  for (const WindingPoint& one : points) {
    measured.x.push_back(one.voltage_V);
    measured.y.push_back(one.current_A);
    reach_V = std::max(reach_V, std::abs(one.voltage_V));
  }
  put(halves_[0], tr("Standing: current (A) over voltage (V)"), measured, false);
  const double dead_V = line.deadZone_V.value, R = line.resistance_ohm.value, zero_A = line.offset_A.value;
  if (!(R > 0.0) || reach_V <= dead_V) return;
  for (const double voltage_V : {-reach_V, -dead_V, dead_V, reach_V})
    halves_[0].line->addData(
        voltage_V, zero_A + (voltage_V - std::copysign(std::min(dead_V, std::abs(voltage_V)), voltage_V)) / R);
}

/// What is left of the voltage when the winding and the bridge have taken theirs.
void MotorTestsPlot::drawTurning(const Commission& known) {
  if (!known.knows(Known::motor) || known.tests->bridge.moving.empty()) return;
  const auto& blocks = known.tests->bridge.moving.front();
  const double R = known.shownResistance_ohm, L = R * known.tests->bridge.timeConstant_s;
  const double Ke = known.motor.backEmfConstant_V_s_per_rad.value, dead_V = known.motor.deadZone_V.value;
  double reach = 0.0;
  TestCurve measured;
  for (size_t k = 1; k + 1 < blocks.size(); ++k) {
    const auto &before = blocks[k - 1], &here = blocks[k], &after = blocks[k + 1];
    const double span_s = after.end_s - before.end_s, speed = (here.angle_rad - before.angle_rad) / here.duration_s;
    if (!(here.duration_s > 0.0) || span_s > 2.5 * here.duration_s || speed * here.voltage_V <= 0.0) continue;
    const double inWinding_V = R * here.current_A + L * (after.current_A - before.current_A) / span_s;
    measured.x.push_back(speed);
    measured.y.push_back(here.voltage_V - std::copysign(dead_V, here.voltage_V) - inWinding_V);
    reach = std::max(reach, std::abs(speed));
  }
  put(halves_[1], tr("Turning: back-EMF (V) over %1").arg(unitsOf(known.identity.axis).speed), measured, false);
  for (const double speed : {-reach, reach}) halves_[1].line->addData(speed, Ke * speed);
}

void MotorTestsPlot::applyLook() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  hint_->setTextColor(look.muted);
  hint_->setFont(typed(Type::body));
  for (const Half& half : halves_) {
    half.title->setTextColor(look.ink);
    half.title->setFont(typed(Type::caption));
    const bool course = half.points->lineStyle() == QCPGraph::lsLine;
    half.points->setPen(QPen(look.measured(0), 3.0));
    half.points->setScatterStyle(course ? QCPScatterStyle()
                                        : QCPScatterStyle(QCPScatterStyle::ssDisc, look.measured(0), 4));
    half.line->setPen(QPen(look.curve(0), 1.6));
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace breakaway
