#include "widgets/locus_plot.h"

#include <qcustomplot.h>

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

namespace {
constexpr double shownPerCutoff = 5.0;  // of the plane, to either side
}  // namespace

LocusPlot::LocusPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName("locusPlot");
  columnIn(this)->addWidget(plot_);
  plot_->setAccessibleName(tr("Poles of the closed loop as the observer's cutoff grows"));
  plot_->setMinimumSize(160, 72);
  plot_->axisRect()->setMinimumMargins(QMargins(48, 4, 12, 4));
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->ticker()->setTickCount(4);
  onNewLook(this, [this] { draw(); });
  draw();
}

void LocusPlot::show(const RootLocus& locus, double cutoff_rad_per_s, double tick_s) {
  locus_ = locus;
  cutoff_rad_per_s_ = cutoff_rad_per_s;
  tick_s_ = tick_s;
  draw();
}

void LocusPlot::draw() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  plot_->clearPlottables();
  plot_->clearItems();
  plot_->axisRect()->setVisible(!locus_.branches.empty());
  if (!locus_.branches.empty() && tick_s_ > 0.0) {
    const double reach = shownPerCutoff * std::max(200.0, cutoff_rad_per_s_);
    plot_->xAxis->setRange(-reach, 0.25 * reach);
    plot_->yAxis->setRange(-0.625 * reach, 0.625 * reach);
    auto* unstable = new QCPItemRect(plot_);
    unstable->topLeft->setCoords(0.0, 2.0 * reach);
    unstable->bottomRight->setCoords(reach, -2.0 * reach);
    unstable->setPen(Qt::NoPen);
    unstable->setBrush(look.troubleBack);
    unstable->setLayer("background");
    auto* name = new QCPItemText(plot_);
    name->setText(tr("unstable"));
    name->setRotation(-90.0);
    name->setColor(look.trouble);
    name->setFont(typed(Type::caption, true));
    name->position->setCoords(0.125 * reach, 0.4 * reach);
    const auto nearest = std::min_element(
        locus_.cutoff_rad_per_s.begin(), locus_.cutoff_rad_per_s.end(),
        [this](double a, double b) { return std::abs(a - cutoff_rad_per_s_) < std::abs(b - cutoff_rad_per_s_); });
    const auto now = static_cast<size_t>(nearest - locus_.cutoff_rad_per_s.begin());
    auto* poles = new QCPCurve(plot_->xAxis, plot_->yAxis);
    poles->setLineStyle(QCPCurve::lsNone);
    poles->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCross, QPen(look.ink, 2), Qt::NoBrush, 9));
    for (const auto& branch : locus_.branches) {
      auto* curve = new QCPCurve(plot_->xAxis, plot_->yAxis);
      curve->setPen(QPen(look.curve(0), 1.6));
      for (size_t k = 0; k < branch.size(); ++k) {
        if (std::abs(branch[k]) < 1e-6) continue;
        const std::complex<double> s = std::log(branch[k]) / tick_s_;
        curve->addData(s.real(), s.imag());
        if (k == now) poles->addData(s.real(), s.imag());
      }
    }
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace breakaway
