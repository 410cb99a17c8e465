#include "widgets/bode_plot.h"

#include <qcustomplot.h>

#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "session/tuning_preview.h"
#include "widgets/controls.h"
#include "widgets/look.h"
#include "widgets/number_text.h"

namespace breakaway {

namespace {

constexpr double phaseDegree = 180.0 / std::numbers::pi;

/// Without jumps from one side to the other, beginning between −360° and 0.
QVector<double> unwrapped(const std::vector<std::complex<double>>& loop) {
  QVector<double> phase;
  double last = 0.0;
  for (const auto& one : loop) {
    double now = phaseDegree * std::arg(one);
    if (phase.isEmpty()) {
      while (now > 0.0) now -= 360.0;
    } else {
      now -= 360.0 * std::round((now - last) / 360.0);
    }
    phase << now;
    last = now;
  }
  return phase;
}

}  // namespace

BodePlot::BodePlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName("bodePlot");
  columnIn(this)->addWidget(plot_);
  plot_->setAccessibleName(tr("Gain and phase of the open loop over frequency"));
  plot_->setMinimumSize(160, 84);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->setRowSpacing(0);
  gain_ = new QCPAxisRect(plot_);
  phase_ = new QCPAxisRect(plot_);
  for (const int row : {0, 1}) {
    titles_[row] = new QCPTextElement(plot_);
    titles_[row]->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    titles_[row]->setMargins(QMargins(4, 0, 4, 0));
    plot_->plotLayout()->addElement(2 * row, 0, titles_[row]);
    plot_->plotLayout()->addElement(2 * row + 1, 0, row == 0 ? gain_ : phase_);
  }
  titles_[0]->setText(tr("Gain of the open loop (dB)"));
  titles_[1]->setText(tr("Its phase (°) over rad/s"));
  plot_->plotLayout()->setRowStretchFactors({1e-3, 1.0, 1e-3, 1.3});  // the lower one has the labels
  auto* left = new QCPMarginGroup(plot_);
  for (QCPAxisRect* rect : {gain_, phase_}) {
    rect->setMarginGroup(QCP::msLeft, left);
    rect->setMinimumMargins(QMargins(40, 7, 12, 4));
    QCPAxis* frequency = rect->axis(QCPAxis::atBottom);
    frequency->setScaleType(QCPAxis::stLogarithmic);
    frequency->setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
    frequency->setNumberFormat("f");
    frequency->setNumberPrecision(0);
    rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
  }
  gain_->axis(QCPAxis::atBottom)->setTickLabels(false);
  onNewLook(this, [this] { draw(); });
  draw();
}

void BodePlot::show(const LoopResponse& edited, const LoopMargins& margins, const LoopResponse& onBoard) {
  edited_ = edited;
  margins_ = margins;
  onBoard_ = onBoard;
  draw();
}

void BodePlot::draw() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  plot_->clearGraphs();
  plot_->clearItems();
  const bool some = !edited_.frequency_rad_per_s.empty();
  for (QCPAxisRect* rect : {gain_, phase_}) rect->setVisible(some);
  for (QCPTextElement* title : titles_) {
    title->setTextColor(look.ink);
    title->setFont(typed(Type::caption));
  }
  if (some) {
    drawResponse(onBoard_, QPen(look.curve(3), 1.2, Qt::DashLine));
    drawResponse(edited_, QPen(look.curve(0), 1.8));
    drawMargins();
    for (QCPAxisRect* rect : {gain_, phase_})
      rect->axis(QCPAxis::atBottom)->setRange(edited_.frequency_rad_per_s.front(), edited_.frequency_rad_per_s.back());
    gain_->axis(QCPAxis::atLeft)->setRange(-40.0, 50.0);
    phase_->axis(QCPAxis::atLeft)->setRange(-300.0, -60.0);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void BodePlot::drawResponse(const LoopResponse& response, const QPen& pen) {
  QVector<double> frequency(response.frequency_rad_per_s.begin(), response.frequency_rad_per_s.end()), gain_dB;
  for (const auto& one : response.loop) gain_dB << 20.0 * std::log10(std::max(1e-12, std::abs(one)));
  const auto add = [&](QCPAxisRect* rect, const QVector<double>& values) {
    QCPGraph* graph = plot_->addGraph(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    graph->setData(frequency, values, true);
    graph->setPen(pen);
  };
  add(gain_, gain_dB);
  add(phase_, unwrapped(response.loop));
}

void BodePlot::drawMargins() {
  if (!margins_.stable) return;
  const Look& look = Look::of(palette());
  const auto on = [](QCPAbstractItem* item, QCPAxisRect* rect) {
    for (QCPItemPosition* position : item->positions())
      position->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    item->setClipAxisRect(rect);
  };
  // The curves fall: beside the one mark they pass at the left, beside the other at the right.
  const auto mark = [&](QCPAxisRect* rect, double frequency, double from, double to, const QString& figure, Grade grade,
                        Qt::AlignmentFlag side) {
    const QColor ink = grade == Grade::good ? look.good : grade == Grade::warning ? look.warning : look.trouble;
    auto* line = new QCPItemLine(plot_);
    on(line, rect);
    line->start->setCoords(frequency, from);
    line->end->setCoords(frequency, to);
    line->setPen(QPen(ink, 2.4));
    auto* text = new QCPItemText(plot_);
    on(text, rect);
    text->position->setCoords(frequency, 0.5 * (from + to));
    text->setPositionAlignment(side | Qt::AlignVCenter);
    text->setPadding(QMargins(5, 0, 5, 0));
    text->setText(figure);
    text->setColor(ink);
    text->setFont(typed(Type::caption, true));
  };
  if (margins_.phaseCrossover_rad_per_s > 0.0 && std::isfinite(margins_.gainMargin))
    mark(gain_, margins_.phaseCrossover_rad_per_s, -20.0 * std::log10(margins_.gainMargin), 0.0,
         numberText(margins_.gainMargin), gradeOfGain(margins_), Qt::AlignLeft);
  if (margins_.gainCrossover_rad_per_s > 0.0 && std::isfinite(margins_.phaseMargin_rad))
    mark(phase_, margins_.gainCrossover_rad_per_s, -180.0, -180.0 + phaseDegree * margins_.phaseMargin_rad,
         tr("%1°").arg(fixedText(phaseDegree * margins_.phaseMargin_rad, 1)), gradeOfPhase(margins_), Qt::AlignRight);
}

}  // namespace breakaway
