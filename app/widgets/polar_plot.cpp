#include "widgets/polar_plot.h"

#include <qcustomplot.h>

#include <numbers>

#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr double radiusAxisAngle_deg = -75.0;

class DegreeTicker : public QCPAxisTickerFixed {
 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return QCPAxisTickerFixed::getTickLabel(tick, locale, format, precision) + QChar(0xb0);
  }
};

double degrees(double angle_rad) {
  return angle_rad * 180.0 / std::numbers::pi;
}

}  // namespace

PolarPlot::PolarPlot(const char* objectName, QWidget* parent)
    : MapPlot(objectName, tr("Polar plot around the rotor; arrow keys read the points"), {800, 800}, parent) {
  QCustomPlot* const plot = &canvas();
  plot->plotLayout()->clear();
  axis_ = new QCPPolarAxisAngular(plot);
  axis_->setRangeDrag(false);
  axis_->setRangeZoom(false);
  axis_->setRange(0.0, 360.0);
  axis_->setMinimumMargins(QMargins(34, 22, 34, 22));
  axis_->setAngle(0.0);  // zero to the right and growing counter-clockwise, as on the dial
  axis_->setRangeReversed(true);
  QSharedPointer<DegreeTicker> ticker(new DegreeTicker);
  ticker->setTickStep(30.0);
  axis_->setTicker(ticker);
  axis_->setNumberFormat("gb");
  QCPPolarAxisRadial* radius = axis_->radialAxis();
  radius->setRangeDrag(false);
  radius->setRangeZoom(false);
  radius->setAngle(radiusAxisAngle_deg);
  radius->setTickLabelMode(QCPPolarAxisRadial::lmUpright);
  radius->ticker()->setTickCount(4);
  radius->setNumberFormat("gb");
  plot->plotLayout()->addElement(0, 0, axis_);
}

void PolarPlot::draw(const Look& look) {
  dress(canvas(), look);
  dress(*axis_, look);
  for (QCPPolarGraph* graph : graphs_) axis_->removeGraph(graph);
  graphs_.clear();
  for (const MapCurve& curve : curves()) drawCurve(curve, look);
  mark_ = addGraph();
  mark_->setLineStyle(QCPPolarGraph::lsNone);
  mark_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(look.ink, 2), Qt::NoBrush, 11));
  rescale();
}

QCPPolarGraph* PolarPlot::addGraph() {
  graphs_.push_back(new QCPPolarGraph(axis_, axis_->radialAxis()));
  return graphs_.back();
}

void PolarPlot::drawCurve(const MapCurve& curve, const Look& look) {
  QVector<double> angle_deg, value, outlierAngle_deg, outlierValue;
  for (const MapPoint& point : curve.points) {
    angle_deg << degrees(point.at);
    value << point.value;
    if (point.outlier) {
      outlierAngle_deg << angle_deg.back();
      outlierValue << point.value;
    }
  }
  if (curve.closed && !angle_deg.isEmpty()) {
    angle_deg << angle_deg.front() + 360.0;
    value << value.front();
  }
  QCPPolarGraph* line = addGraph();
  line->setData(angle_deg, value, true);
  line->setPen(QPen(look.curve(curve.colour), curve.dashed ? 1.2 : 1.6, curve.dashed ? Qt::DashLine : Qt::SolidLine));
  if (!curve.closed) line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, look.curve(curve.colour), 3));
  if (outlierAngle_deg.isEmpty()) return;
  QCPPolarGraph* crosses = addGraph();
  crosses->setData(outlierAngle_deg, outlierValue, true);
  crosses->setLineStyle(QCPPolarGraph::lsNone);
  crosses->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCross, QPen(look.trouble, 1.6), Qt::NoBrush, 8));
}

void PolarPlot::rescale() {
  const auto [lower, upper] = valueRange(0.0);
  axis_->radialAxis()->setRange(lower, upper);
}

QPointF PolarPlot::pixelOf(const MapPoint& point) const {
  return axis_->radialAxis()->coordToPixel(degrees(point.at), point.value);
}

void PolarPlot::mark(const MapPoint& point) {
  mark_->setData({degrees(point.at)}, {point.value}, true);
}

QString PolarPlot::placeOf(const MapPoint& point) const {
  return tr("%1°").arg(degrees(point.at), 0, 'f', 1);
}

}  // namespace breakaway
