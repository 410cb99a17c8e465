#include "widgets/step_plot.h"

#include <qcustomplot.h>

#include <QVBoxLayout>

#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr size_t ghosts = 5;

QVector<double> list(const std::vector<double>& values, double scale = 1.0) {
  QVector<double> scaled;
  scaled.reserve(static_cast<qsizetype>(values.size()));
  for (const double value : values) scaled << scale * value;
  return scaled;
}

}  // namespace

StepPlot::StepPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName("stepPlot");
  auto* layout = columnIn(this);
  layout->addWidget(plot_);
  plot_->setAccessibleName(tr("Measured velocity step and its current over time"));
  plot_->setMinimumSize(200, 150);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->setRowSpacing(2);
  velocity_ = new QCPAxisRect(plot_);
  current_ = new QCPAxisRect(plot_);
  plot_->plotLayout()->addElement(0, 0, velocity_);
  plot_->plotLayout()->addElement(1, 0, current_);
  plot_->plotLayout()->setRowStretchFactors({1.5, 1.0});
  auto* left = new QCPMarginGroup(plot_);
  for (QCPAxisRect* rect : {velocity_, current_}) {
    rect->setMarginGroup(QCP::msLeft, left);
    rect->setMinimumMargins(QMargins(44, 6, 12, 4));
    rect->setRangeZoom(Qt::Horizontal);
    rect->setRangeDrag(Qt::Horizontal);
  }
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  velocity_->axis(QCPAxis::atBottom)->setTickLabels(false);
  current_->axis(QCPAxis::atLeft)->setLabel(tr("current (A)"));
  current_->axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
  current_->axis(QCPAxis::atBottom)->setLabel(tr("time from the step (ms)"));
  const auto follow = [](QCPAxis* from, QCPAxis* to) {
    connect(from, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), to,
            [to](const QCPRange& range) { to->setRange(range); });
  };
  follow(velocity_->axis(QCPAxis::atBottom), current_->axis(QCPAxis::atBottom));
  follow(current_->axis(QCPAxis::atBottom), velocity_->axis(QCPAxis::atBottom));
  hint_ = new QCPTextElement(plot_, tr("No step measured yet"));
  velocity_->insetLayout()->addElement(hint_, Qt::AlignCenter);
  setSpeedUnit(tr("rad/s"));
  draw();
}

void StepPlot::setSpeedUnit(const QString& unit) {
  velocity_->axis(QCPAxis::atLeft)->setLabel(tr("velocity (%1)").arg(unit));
}

void StepPlot::show(const std::vector<StepResult>& steps) {
  steps_ = steps;
  draw();
}

void StepPlot::draw() {
  const Look look = Look::of(palette());
  dress(*plot_, look);
  hint_->setTextColor(look.muted);
  hint_->setFont(font());
  hint_->setVisible(steps_.empty());
  plot_->clearGraphs();
  const size_t first = steps_.size() > ghosts + 1 ? steps_.size() - ghosts - 1 : 0;
  for (size_t k = first; k < steps_.size(); ++k) drawStep(steps_[k], k + 1 == steps_.size());
  if (!steps_.empty()) {
    for (QCPAxisRect* rect : {velocity_, current_}) {
      QCPAxis* values = rect->axis(QCPAxis::atLeft);
      values->rescale();
      values->scaleRange(1.12);
    }
    const StepResult& newest = steps_.back();
    if (!newest.curve.time_s.empty()) {
      velocity_->axis(QCPAxis::atBottom)->setRange(-20.0, std::min(1e3 * newest.curve.time_s.back(), 400.0));
    }
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void StepPlot::drawStep(const StepResult& step, bool newest) {
  const Look look = Look::of(palette());
  const auto time_ms = list(step.curve.time_s, 1e3);
  const auto add = [&](QCPAxisRect* rect, const std::vector<double>& values, const QPen& pen) {
    QCPGraph* graph = plot_->addGraph(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    graph->setData(time_ms, list(values), true);
    graph->setPen(pen);
  };
  const auto ghostly = [](QColor ink) {
    ink.setAlpha(80);
    return ink;
  };
  if (newest) add(velocity_, step.curve.reference_rad_per_s, QPen(look.muted, 1, Qt::DashLine));
  add(velocity_, step.curve.velocity_rad_per_s,
      QPen(newest ? look.curve(1) : ghostly(look.curve(1)), newest ? 1.6 : 1.0));
  add(current_, step.curve.current_A, QPen(newest ? look.curve(2) : ghostly(look.curve(2)), newest ? 1.3 : 1.0));
}

void StepPlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (hint_ != nullptr && (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)) draw();
}

}  // namespace breakaway
