#include "widgets/step_plot.h"

#include <qcustomplot.h>

#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr size_t mostDrawn = 4;
constexpr double longest_ms = 400.0, beforeShare = 0.06;
constexpr double pastSettling = 2.0;  // of the time axis, per time of settling

QVector<double> list(const std::vector<double>& values, double scale = 1.0) {
  QVector<double> scaled;
  scaled.reserve(static_cast<qsizetype>(values.size()));
  for (const double value : values) scaled << scale * value;
  return scaled;
}

/// When the speed has come near its end for good, in ms.
double settled_ms(const StepCurve& curve) {
  if (curve.time_s.empty()) return 0.0;
  const double end = curve.reference_rad_per_s.back(), band = 0.05 * std::abs(end);
  double last_s = 0.0;
  for (size_t k = 0; k < curve.time_s.size(); ++k)
    if (curve.time_s[k] > 0.0 && std::abs(curve.velocity_rad_per_s[k] - end) > band) last_s = curve.time_s[k];
  return 1e3 * last_s;
}

}  // namespace

int StepPlot::colourOf(size_t step) {
  constexpr int colours[] = {4, 2, 3, 1};
  return colours[step % std::size(colours)];
}

size_t StepPlot::firstDrawn(size_t steps) {
  return steps > mostDrawn ? steps - mostDrawn : 0;
}

StepPlot::StepPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName("stepPlot");
  columnIn(this)->addWidget(plot_);
  plot_->setAccessibleName(tr("Velocity steps and their current over time, measured and foretold"));
  plot_->setMinimumSize(200, 120);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->setRowSpacing(2);
  velocity_ = new QCPAxisRect(plot_);
  current_ = new QCPAxisRect(plot_);
  for (QCPTextElement*& title : titles_) {
    title = new QCPTextElement(plot_);
    title->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    title->setMargins(QMargins(4, 0, 4, 0));
  }
  head_ = new QCPLayoutGrid;
  head_->addElement(0, 0, titles_[0]);
  plot_->plotLayout()->addElement(0, 0, head_);
  plot_->plotLayout()->addElement(1, 0, velocity_);
  plot_->plotLayout()->addElement(2, 0, titles_[1]);
  titles_[1]->setText(tr("Current (A) over the time from the step (ms)"));
  plot_->plotLayout()->addElement(3, 0, current_);
  plot_->plotLayout()->setRowStretchFactors({0.001, 1.5, 0.001, 1.0});
  auto* left = new QCPMarginGroup(plot_);
  for (QCPAxisRect* rect : {velocity_, current_}) {
    rect->setMarginGroup(QCP::msLeft, left);
    rect->setMinimumMargins(QMargins(44, 7, 12, 4));
    rect->setRangeZoom(Qt::Horizontal);
    rect->setRangeDrag(Qt::Horizontal);
  }
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  velocity_->axis(QCPAxis::atBottom)->setTickLabels(false);
  current_->axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
  const auto follow = [](QCPAxis* from, QCPAxis* to) {
    connect(from, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), to,
            [to](const QCPRange& range) { to->setRange(range); });
  };
  follow(velocity_->axis(QCPAxis::atBottom), current_->axis(QCPAxis::atBottom));
  follow(current_->axis(QCPAxis::atBottom), velocity_->axis(QCPAxis::atBottom));
  hint_ = new QCPTextElement(plot_, tr("Connect a board:\nthe step that its settings make\nis foretold here"));
  velocity_->insetLayout()->addElement(hint_, Qt::AlignCenter);
  setQuantity(tr("Speed (%1)").arg(tr("rad/s")));
  draw();
  onNewLook(this, [this] { draw(); });
}

void StepPlot::setQuantity(const QString& title) {
  titles_[0]->setText(title);
}

void StepPlot::show(const std::vector<StepResult>& steps) {
  steps_ = steps;
  draw();
}

void StepPlot::foretell(const StepCurve& curve, const StepCurve& onBoard) {
  foretold_ = curve;
  onBoard_ = onBoard;
  draw();
}

void StepPlot::draw() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  hint_->setTextColor(look.muted);
  hint_->setFont(typed(Type::body));
  const bool some = !steps_.empty() || !foretold_.time_s.empty();
  hint_->setVisible(!some);
  for (QCPTextElement* title : titles_) {
    title->setTextColor(look.ink);
    title->setFont(typed(Type::caption));
    title->setVisible(some);
  }
  nameCurves();
  for (QCPAxisRect* rect : {velocity_, current_}) {
    for (QCPAxis* axis : rect->axes()) {
      axis->setVisible(some && (axis->axisType() == QCPAxis::atLeft || axis->axisType() == QCPAxis::atBottom));
      axis->grid()->setVisible(some);
    }
  }
  plot_->clearGraphs();
  double settled = std::max(settled_ms(foretold_), settled_ms(onBoard_));
  for (size_t k = firstDrawn(steps_.size()); k < steps_.size(); ++k) {
    drawCurve(steps_[k].curve, QPen(look.measured(colourOf(k)), 3.0));
    settled = std::max(settled, settled_ms(steps_[k].curve));
  }
  drawCurve(onBoard_, QPen(look.curve(3), 1.2, Qt::DashLine));
  drawCurve(foretold_, QPen(look.curve(0), 1.8));
  if (some) {
    for (QCPAxisRect* rect : {velocity_, current_}) {
      QCPAxis* values = rect->axis(QCPAxis::atLeft);
      values->rescale();
      values->scaleRange(1.12);
    }
    const double end_ms = std::clamp(pastSettling * settled, 20.0, longest_ms);
    velocity_->axis(QCPAxis::atBottom)->setRange(-beforeShare * end_ms, end_ms);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

/// At the right of the title, each in its colour, the newest next to what is foretold; the oldest have no name where
/// there is no room, as the table beneath has their colours, too.
void StepPlot::nameCurves() {
  const Look& look = Look::of(palette());
  while (head_->columnCount() > 1) {
    head_->removeAt(head_->rowColToIndex(0, head_->columnCount() - 1));
    head_->simplify();
  }
  constexpr int beside_px = 4, gap_px = 5;  // of a name, and what the layout puts between two
  const QFont font = typed(Type::caption, true);
  const QFontMetrics titleWidths(titles_[0]->font()), widths(font);
  int room_px = width() - titleWidths.horizontalAdvance(titles_[0]->text()) - 2 * beside_px;
  QList<double> stretch{1.0};
  const auto name = [&](const QString& text, const QColor& ink) {
    room_px -= widths.horizontalAdvance(text) + 2 * beside_px + gap_px;
    if (room_px < 0) return;
    auto* element = new QCPTextElement(plot_, text, font);
    element->setTextColor(ink);
    element->setMargins(QMargins(beside_px, 0, beside_px, 0));
    head_->addElement(0, head_->columnCount(), element);
    stretch << 1e-3;
  };
  if (!foretold_.time_s.empty()) name(onBoard_.time_s.empty() ? tr("foretold") : tr("edited"), look.curve(0));
  if (!onBoard_.time_s.empty()) name(tr("╌ on board"), look.curve(3));
  for (size_t k = steps_.size();
       k-- > firstDrawn(steps_.size());)  // "step 4 3 2 1": there isn't room for the word each time
    name(k + 1 == steps_.size() ? tr("step %1").arg(k + 1) : QString::number(k + 1), look.curve(colourOf(k)));
  head_->setColumnStretchFactors(stretch);
}

void StepPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  nameCurves();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void StepPlot::drawCurve(const StepCurve& curve, const QPen& pen) {
  const auto time_ms = list(curve.time_s, 1e3);
  const auto add = [&](QCPAxisRect* rect, const std::vector<double>& values, const QPen& with) {
    QCPGraph* graph = plot_->addGraph(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    graph->setData(time_ms, list(values), true);
    graph->setPen(with);
  };
  if (&curve == &foretold_ || (foretold_.time_s.empty() && &curve == &steps_.back().curve))
    add(velocity_, curve.reference_rad_per_s, QPen(Look::of(palette()).muted, 1, Qt::DashLine));
  add(velocity_, curve.velocity_rad_per_s, pen);
  add(current_, curve.current_A, pen);
}

}  // namespace breakaway
