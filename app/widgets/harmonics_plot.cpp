#include "widgets/harmonics_plot.h"

#include <qcustomplot.h>

#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls.h"
#include "widgets/look.h"
#include "widgets/map_harmonics.h"

namespace breakaway {

namespace {
constexpr int mostOrder = 12;
constexpr size_t mostCurves = 2;
constexpr double barsShare = 0.8;  // of the room of an order
}  // namespace

HarmonicsPlot::HarmonicsPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName("harmonicsPlot");
  columnIn(this)->addWidget(plot_);
  plot_->setAccessibleName(tr("Orders of the turn"));
  plot_->setMinimumSize(120, 80);
  plot_->axisRect()->setMinimumMargins(QMargins(36, 4, 8, 4));
  plot_->yAxis->ticker()->setTickCount(3);
  QSharedPointer<QCPAxisTickerFixed> ticker(new QCPAxisTickerFixed);
  ticker->setTickStep(1.0);
  ticker->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  plot_->xAxis->setTicker(ticker);
  plot_->xAxis->setLabel(tr("order of the turn"));
  plot_->xAxis->grid()->setVisible(false);
  onNewLook(this, [this] { draw(); });
  draw();
}

void HarmonicsPlot::show(const std::vector<MapCurve>& curves) {
  curves_.clear();
  for (const MapCurve& curve : meansByColour(curves))
    if (curves_.size() < mostCurves && !ordersShownBy(curve, mostOrder).empty()) curves_.push_back(curve);
  draw();
}

void HarmonicsPlot::draw() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  plot_->clearPlottables();
  double most = 0.0;
  const double width = barsShare / static_cast<double>(std::max<size_t>(1, curves_.size()));
  for (size_t k = 0; k < curves_.size(); ++k) {
    const std::vector<double> amplitudes = ordersShownBy(curves_[k], mostOrder);
    auto* bars = new QCPBars(plot_->xAxis, plot_->yAxis);
    bars->setWidth(width);
    bars->setPen(Qt::NoPen);
    bars->setBrush(look.curve(curves_[k].colour));
    for (size_t order = 0; order < amplitudes.size(); ++order) {
      bars->addData(static_cast<double>(order + 1) + width * (static_cast<double>(k) - 0.5 * (curves_.size() - 1.0)),
                    amplitudes[order]);
      most = std::max(most, amplitudes[order]);
    }
  }
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->setVisible(!curves_.empty());
  plot_->yAxis->grid()->setVisible(!curves_.empty());
  plot_->xAxis->setRange(0.4, mostOrder + 0.6);
  plot_->yAxis->setRange(0.0, most > 0.0 ? 1.1 * most : 1.0);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace breakaway
