#include "widgets/observer_noise_plot.h"

#include <qcustomplot.h>

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/controls.h"
#include "widgets/look.h"
#include "widgets/number_text.h"

namespace breakaway {

ObserverNoisePlot::ObserverNoisePlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName("observerNoisePlot");
  columnIn(this)->addWidget(plot_);
  plot_->setAccessibleName(tr("Noise of the current over the speed observer's bandwidth"));
  plot_->setMinimumSize(160, 72);
  plot_->axisRect()->setMinimumMargins(QMargins(48, 4, 12, 4));
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
    axis->setNumberFormat("g");
    axis->setNumberPrecision(6);  // thousands in full, as beside it
  }
  onNewLook(this, [this] { draw(); });
  draw();
}

void ObserverNoisePlot::show(const ObserverNoise& noise, double most_A) {
  noise_ = noise;
  most_A_ = most_A;
  draw();
}

void ObserverNoisePlot::draw() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  plot_->clearGraphs();
  plot_->clearItems();
  QVector<double> bandwidth, noise_mA;
  double inUse_mA = 0.0;
  for (size_t k = 0; k < noise_.bandwidth_rad_per_s.size(); ++k) {
    if (!(noise_.current_A[k] > 0.0)) continue;  // unstable, or no noise at all
    bandwidth << noise_.bandwidth_rad_per_s[k];
    noise_mA << 1e3 * noise_.current_A[k];
    if (noise_.bandwidth_rad_per_s[k] <= noise_.inUse_rad_per_s) inUse_mA = noise_mA.back();
  }
  plot_->axisRect()->setVisible(bandwidth.size() > 1);
  if (bandwidth.size() > 1) {
    plot_->addGraph();
    plot_->graph()->setData(bandwidth, noise_mA, true);
    plot_->graph()->setPen(QPen(look.curve(0), 1.8));
    const auto [low, high] = std::minmax_element(noise_mA.begin(), noise_mA.end());
    const double top = std::max(*high, 1e3 * most_A_);
    plot_->xAxis->setRange(noise_.bandwidth_rad_per_s.front(), noise_.bandwidth_rad_per_s.back());
    plot_->yAxis->setRange(0.7 * *low, 1.5 * top);
    if (most_A_ > 0.0) {
      auto* most = new QCPItemLine(plot_);
      most->start->setCoords(plot_->xAxis->range().lower, 1e3 * most_A_);
      most->end->setCoords(plot_->xAxis->range().upper, 1e3 * most_A_);
      most->setPen(QPen(look.trouble, 1.2, Qt::DashLine));
    }
    auto* inUse = new QCPItemLine(plot_);
    inUse->start->setCoords(noise_.inUse_rad_per_s, plot_->yAxis->range().lower);
    inUse->end->setCoords(noise_.inUse_rad_per_s, inUse_mA);
    inUse->setPen(QPen(look.good, 2.4));
    auto* name = new QCPItemText(plot_);
    name->setText(tr("board: %1 rad/s").arg(numberText(noise_.inUse_rad_per_s)));
    name->setColor(look.good);
    name->setFont(typed(Type::caption, true));
    name->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
    name->setPadding(QMargins(5, 0, 5, 2));
    name->position->setCoords(noise_.inUse_rad_per_s, plot_->yAxis->range().lower);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace breakaway
