#include "widgets/travel_plot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "widgets/degree_ticker.h"
#include "widgets/look.h"
#include "widgets/number_text.h"

namespace breakaway {

namespace {

constexpr double mm = 1e3;
constexpr double unknown_mm = 100.0;  // either way from the index, before the travel is known

}  // namespace

TravelPlot::TravelPlot(const char* objectName, Places places, QWidget* parent)
    : MapPlot(objectName,
              places == Places::travel ? tr("Plot over the travel; arrow keys read the points")
                                       : tr("Plot over the rotor's angle; arrow keys read the points"),
              {1000, 560}, parent),
      places_(places) {
  if (places == Places::travel) {
    canvas().xAxis->setLabel(TravelPlot::tr("position from the index (mm)"));
    return;
  }
  canvas().setMinimumSize(120, 80);
  canvas().xAxis->setTicker(QSharedPointer<DegreeTicker>::create(90.0));
  canvas().yAxis->ticker()->setTickCount(4);
}

double TravelPlot::shown(double at) const {
  if (places_ == Places::travel) return mm * at;
  const double angle = std::fmod(at * 180.0 / std::numbers::pi, 360.0);
  return angle < 0.0 ? angle + 360.0 : angle;
}

void TravelPlot::draw(const Look& look) {
  canvas().clearGraphs();
  dress(canvas(), look);
  canvas().yAxis->setLabel(axisTitle());
  for (const MapCurve& curve : curves()) drawBand(curve, look);
  for (const MapCurve& curve : curves()) drawCurve(curve, look);
  mark_ = canvas().addGraph();
  mark_->setLineStyle(QCPGraph::lsNone);
  mark_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(look.ink, 2), Qt::NoBrush, 11));
  rescale();
}

void TravelPlot::drawBand(const MapCurve& curve, const Look& look) {
  if (!hasBand(curve)) return;
  QCPGraph *low = canvas().addGraph(), *high = canvas().addGraph();
  for (const MapPoint& point : curve.points) {
    low->addData(shown(point.at), point.value - normal95 * point.standardError);
    high->addData(shown(point.at), point.value + normal95 * point.standardError);
  }
  for (QCPGraph* edge : {low, high}) edge->setPen(Qt::NoPen);
  high->setBrush(look.band(curve.colour));
  high->setChannelFillGraph(low);
}

void TravelPlot::drawCurve(const MapCurve& curve, const Look& look) {
  QCPGraph* line = canvas().addGraph();
  QCPGraph* crosses = nullptr;
  for (const MapPoint& point : curve.points) {
    line->addData(shown(point.at), point.value);
    if (!point.outlier) continue;
    if (crosses == nullptr) crosses = canvas().addGraph();
    crosses->addData(shown(point.at), point.value);
  }
  line->setPen(penOf(curve, look, 1.6));
  if (!curve.closed) line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, look.curve(curve.colour), 3));
  if (crosses == nullptr) return;
  crosses->setLineStyle(QCPGraph::lsNone);
  crosses->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCross, QPen(look.trouble, 1.6), Qt::NoBrush, 8));
}

void TravelPlot::rescale() {
  const auto [lower, upper] = valueRange(normal95, 0.08, true);
  canvas().yAxis->setRange(lower, upper);
  for (QCPAxis* axis : {canvas().xAxis, canvas().yAxis}) {
    axis->setVisible(!curves().empty());
    axis->grid()->setVisible(!curves().empty());
  }
  if (places_ == Places::turn) {
    canvas().xAxis->setRange(0.0, 360.0);
    return;
  }
  double from = -unknown_mm, to = unknown_mm;
  if (travel_) {
    from = mm * travel_->low_m;
    to = mm * travel_->high_m;
  }
  canvas().xAxis->setRange(from, to);
}

QPointF TravelPlot::pixelOf(const MapPoint& point) const {
  return {canvas().xAxis->coordToPixel(shown(point.at)), canvas().yAxis->coordToPixel(point.value)};
}

void TravelPlot::mark(const MapPoint& point) {
  mark_->data()->clear();
  mark_->addData(shown(point.at), point.value);
}

QString TravelPlot::placeOf(const MapPoint& point) const {
  return (places_ == Places::travel ? tr("%1 mm") : tr("%1°")).arg(fixedText(shown(point.at), 1));
}

}  // namespace breakaway
