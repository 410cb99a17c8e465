#include "widgets/motor_tests_plot.h"

#include <qcustomplot.h>

#include <QVBoxLayout>
#include <cmath>

#include "commission/known.h"
#include "commission/motor_tests.h"
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

}  // namespace

MotorTestsPlot::MotorTestsPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName("motorTestsPlot");
  columnIn(this)->addWidget(plot_);
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
  half.points->setLineStyle(QCPGraph::lsNone);
  half.line = plot_->addGraph(across, values);
}

void MotorTestsPlot::show(const Commission& known) {
  const bool standing = known.tests != nullptr && known.knows(Known::windingTest);
  const bool turning = standing && known.knows(Known::motor) && !known.tests->bridge.moving.empty();
  for (Half& half : halves_) {
    half.points->data()->clear();
    half.line->data()->clear();
  }
  if (standing) drawStanding(known);
  if (turning) drawTurning(known);
  hint_->setVisible(!standing);
  halves_[0].title->setText(standing ? tr("Standing: current (A) over voltage (V)") : QString());
  halves_[1].title->setText(turning ? tr("Turning: back-EMF (V) over %1").arg(unitsOf(known.identity.axis).speed)
                                    : QString());
  // Each has its half of the width, and all of it while it is alone.
  plot_->plotLayout()->setColumnStretchFactors({1.0, turning ? 1.0 : 1e-3});
  for (size_t k = 0; k < halves_.size(); ++k) {
    QCPAxisRect& rect = *halves_[k].rect;
    for (QCPAxis* axis : {rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft)}) {
      axis->setVisible(k == 0 ? standing : turning);
      axis->grid()->setVisible(axis->visible());
      axis->rescale();
      axis->scaleRange(1.1);
    }
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void MotorTestsPlot::drawStanding(const Commission& known) {
  const auto& points = known.tests->bridge.standing;
  const WindingLine& line = known.tests->winding.line;
  double reach_V = 0.0;
  for (size_t k = 0; k < points.size(); k += strideOf(points.size())) {
    halves_[0].points->addData(points[k].voltage_V, points[k].current_A);
    reach_V = std::max(reach_V, std::abs(points[k].voltage_V));
  }
  const double dead_V = line.deadZone_V.value, R = line.resistance_ohm.value, zero_A = line.offset_A.value;
  if (!(R > 0.0) || reach_V <= dead_V) return;
  for (const double voltage_V : {-reach_V, -dead_V, dead_V, reach_V})
    halves_[0].line->addData(
        voltage_V, zero_A + (voltage_V - std::copysign(std::min(dead_V, std::abs(voltage_V)), voltage_V)) / R);
}

/// What is left of the voltage when the winding and the bridge have taken theirs.
void MotorTestsPlot::drawTurning(const Commission& known) {
  const auto& blocks = known.tests->bridge.moving.front();
  const double R = known.shownResistance_ohm, L = R * known.tests->bridge.timeConstant_s;
  const double Ke = known.motor.backEmfConstant_V_s_per_rad.value, dead_V = known.motor.deadZone_V.value;
  double reach = 0.0;
  const size_t stride = strideOf(blocks.size());
  for (size_t k = 1; k + 1 < blocks.size(); k += stride) {
    const auto &before = blocks[k - 1], &here = blocks[k], &after = blocks[k + 1];
    const double span_s = after.end_s - before.end_s, speed = (here.angle_rad - before.angle_rad) / here.duration_s;
    if (!(here.duration_s > 0.0) || span_s > 2.5 * here.duration_s || speed * here.voltage_V <= 0.0) continue;
    const double inWinding_V = R * here.current_A + L * (after.current_A - before.current_A) / span_s;
    halves_[1].points->addData(speed, here.voltage_V - std::copysign(dead_V, here.voltage_V) - inWinding_V);
    reach = std::max(reach, std::abs(speed));
  }
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
    half.points->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, look.measured(0), 4));
    half.line->setPen(QPen(look.curve(0), 1.6));
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace breakaway
