#include "widgets/travel_plot.h"

#include <qcustomplot.h>

#include <algorithm>

#include "base/numbers.h"
#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr double mm = 1e3;
constexpr double bandOpacity = 0.22;
constexpr double unknown_mm = 100.0;  // either way from the index, before the travel is known

}  // namespace

TravelPlot::TravelPlot(const char* objectName, QWidget* parent)
    : MapPlot(objectName, tr("Plot over the travel; arrow keys read the points"), {1000, 560}, parent) {
  canvas().xAxis->setLabel(tr("position from the index (mm)"));
}

void TravelPlot::draw(const Look& look) {
  canvas().clearGraphs();
  dress(canvas(), look);
  canvas().yAxis->setLabel(quantity());
  for (const MapCurve& curve : curves()) drawBand(curve, look);
  for (const MapCurve& curve : curves()) drawCurve(curve, look);
  mark_ = canvas().addGraph();
  mark_->setLineStyle(QCPGraph::lsNone);
  mark_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(look.ink, 2), Qt::NoBrush, 11));
  rescale();
}

void TravelPlot::drawBand(const MapCurve& curve, const Look& look) {
  const bool known = std::any_of(curve.points.begin(), curve.points.end(),
                                 [](const MapPoint& point) { return point.standardError > 0.0; });
  if (!known) return;
  QCPGraph *low = canvas().addGraph(), *high = canvas().addGraph();
  for (const MapPoint& point : curve.points) {
    low->addData(mm * point.at, point.value - normal95 * point.standardError);
    high->addData(mm * point.at, point.value + normal95 * point.standardError);
  }
  QColor fill = look.curve(curve.colour);
  fill.setAlphaF(static_cast<float>(bandOpacity));
  for (QCPGraph* edge : {low, high}) edge->setPen(Qt::NoPen);
  high->setBrush(fill);
  high->setChannelFillGraph(low);
}

void TravelPlot::drawCurve(const MapCurve& curve, const Look& look) {
  QCPGraph* line = canvas().addGraph();
  QCPGraph* crosses = nullptr;
  for (const MapPoint& point : curve.points) {
    line->addData(mm * point.at, point.value);
    if (!point.outlier) continue;
    if (crosses == nullptr) crosses = canvas().addGraph();
    crosses->addData(mm * point.at, point.value);
  }
  line->setPen(QPen(look.curve(curve.colour), curve.dashed ? 1.2 : 1.6, curve.dashed ? Qt::DashLine : Qt::SolidLine));
  if (!curve.closed) line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, look.curve(curve.colour), 3));
  if (crosses == nullptr) return;
  crosses->setLineStyle(QCPGraph::lsNone);
  crosses->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCross, QPen(look.trouble, 1.6), Qt::NoBrush, 8));
}

void TravelPlot::rescale() {
  const auto [lower, upper] = valueRange(normal95);
  canvas().yAxis->setRange(lower, upper);
  double from = -unknown_mm, to = unknown_mm;
  if (travel_) {
    from = mm * travel_->low_m;
    to = mm * travel_->high_m;
  }
  canvas().xAxis->setRange(from, to);
}

QPointF TravelPlot::pixelOf(const MapPoint& point) const {
  return {canvas().xAxis->coordToPixel(mm * point.at), canvas().yAxis->coordToPixel(point.value)};
}

void TravelPlot::mark(const MapPoint& point) {
  mark_->data()->clear();
  mark_->addData(mm * point.at, point.value);
}

QString TravelPlot::placeOf(const MapPoint& point) const {
  return tr("%1 mm").arg(mm * point.at, 0, 'f', 1);
}

}  // namespace breakaway
