#include "widgets/locus_plot.h"

#include <qcustomplot.h>

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

namespace {
constexpr double shownPerCutoff = 5.0, leastPerCutoff = 1.5;  // of the plane, to the left
constexpr double roomBeside = 1.3;                            // times the furthest pole
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

void LocusPlot::show(const RootLocus& locus, double cutoff_rad_per_s, double tick_s, const RootLocus& onBoard,
                     double boardCutoff_rad_per_s) {
  locus_ = locus;
  cutoff_rad_per_s_ = cutoff_rad_per_s;
  tick_s_ = tick_s;
  onBoard_ = onBoard;
  boardCutoff_rad_per_s_ = boardCutoff_rad_per_s;
  draw();
}

/// Poles to the left of both rays are damped by 1/√2 at least.
void LocusPlot::drawDamping(double reach) {
  const Look& look = Look::of(palette());
  for (const double way : {-1.0, 1.0}) {
    auto* ray = new QCPItemLine(plot_);
    ray->start->setCoords(0.0, 0.0);
    ray->end->setCoords(-reach, way * reach);
    ray->setPen(QPen(look.border, 1, Qt::DashLine));
    ray->setLayer("grid");
  }
  auto* name = new QCPItemText(plot_);
  name->setText(tr("ζ 0.7"));
  name->setColor(look.muted);
  name->setFont(typed(Type::caption));
  name->setBrush(look.surface);
  name->position->setCoords(-0.5 * reach, 0.5 * reach);
}

std::vector<std::complex<double>> LocusPlot::polesAt(const RootLocus& locus, double cutoff_rad_per_s) const {
  const auto nearest = std::min_element(locus.cutoff_rad_per_s.begin(), locus.cutoff_rad_per_s.end(),
                                        [cutoff_rad_per_s](double a, double b) {
                                          return std::abs(a - cutoff_rad_per_s) < std::abs(b - cutoff_rad_per_s);
                                        });
  std::vector<std::complex<double>> poles;
  const auto now = static_cast<size_t>(nearest - locus.cutoff_rad_per_s.begin());
  for (const auto& branch : locus.branches)
    if (now < branch.size() && std::abs(branch[now]) > 1e-6) poles.push_back(std::log(branch[now]) / tick_s_);
  return poles;
}

void LocusPlot::drawPoles(const std::vector<std::complex<double>>& poles, const QColor& ink) {
  auto* crosses = new QCPCurve(plot_->xAxis, plot_->yAxis);
  crosses->setLineStyle(QCPCurve::lsNone);
  crosses->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCross, QPen(ink, 2), Qt::NoBrush, 9));
  for (const std::complex<double>& s : poles) crosses->addData(s.real(), s.imag());
}

/// As far as the poles that matter beside the cutoff: what dies out much faster needs no room.
double LocusPlot::reachOf(const std::vector<std::complex<double>>& poles) const {
  const double cutoff = std::max(200.0, cutoff_rad_per_s_);
  double most = leastPerCutoff * cutoff;
  for (const std::complex<double>& s : poles)
    if (std::abs(s) < shownPerCutoff * cutoff) most = std::max(most, roomBeside * std::abs(s));
  return std::min(most, shownPerCutoff * cutoff);
}

void LocusPlot::draw() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  plot_->clearPlottables();
  plot_->clearItems();
  plot_->axisRect()->setVisible(!locus_.branches.empty());
  if (!locus_.branches.empty() && tick_s_ > 0.0) {
    const auto now = polesAt(locus_, cutoff_rad_per_s_);
    const double reach = reachOf(now);
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
    drawDamping(reach);
    for (const auto& branch : locus_.branches) {
      auto* curve = new QCPCurve(plot_->xAxis, plot_->yAxis);
      curve->setPen(QPen(look.curve(0), 1.6));
      for (size_t k = 0; k < branch.size(); ++k) {
        if (std::abs(branch[k]) < 1e-6) continue;
        const std::complex<double> s = std::log(branch[k]) / tick_s_;
        curve->addData(s.real(), s.imag());
      }
    }
    drawPoles(polesAt(onBoard_, boardCutoff_rad_per_s_), look.curve(3));
    drawPoles(now, look.ink);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace breakaway
