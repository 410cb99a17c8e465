#include "widgets/polar_plot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "widgets/degree_ticker.h"
#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr double radiusAxisAngle_deg = -75.0, figureRadius_px = 52.0;

/// Of the radius: what would lie under the figure in the middle isn't told.
class RadiusTicker : public QCPAxisTicker {
 public:
  explicit RadiusTicker(const QCPPolarAxisAngular& axis) : axis_(axis) {}

 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    if (axis_.radialAxis()->coordToRadius(tick) < figureRadius_px) return {};
    return QCPAxisTicker::getTickLabel(tick, locale, format, precision);
  }

 private:
  const QCPPolarAxisAngular& axis_;
};

/// Every 30° but at the sides, where upright labels would take the circle's room.
class RimTicker : public DegreeTicker {
 public:
  RimTicker() : DegreeTicker(30.0) {}

 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    const bool side = std::abs(std::remainder(tick, 180.0)) < 1.0;
    return side ? QString() : DegreeTicker::getTickLabel(tick, locale, format, precision);
  }
};

constexpr int figureGap_px = 26, rim_px = 19, besideRim_px = 11;
constexpr double ringInner = 0.925, ringOuter = 0.985, ringRoom = 0.9;  // of the circle's radius
constexpr double roomForFigure = 0.6;  // of what the values span, in the middle where the radius begins above zero

/// The stretch between two curves around the rotor.
class Band : public QCPAbstractItem {
 public:
  Band(QCustomPlot* plot, QCPPolarAxisRadial* axis, const MapCurve& curve, const QColor& fill)
      : QCPAbstractItem(plot), axis_(axis), curve_(curve), fill_(fill) {}
  double selectTest(const QPointF&, bool, QVariant*) const override { return -1.0; }

 protected:
  void draw(QCPPainter* painter) override {
    QPolygonF outer, inner;
    for (const MapPoint& point : curve_.points) {
      const double half = normal95 * point.standardError, angle = point.at * 180.0 / std::numbers::pi;
      outer << axis_->coordToPixel(angle, point.value + half);
      inner << axis_->coordToPixel(angle, point.value - half);
    }
    QPainterPath path;
    path.addPolygon(outer);
    path.closeSubpath();
    path.addPolygon(inner);
    path.closeSubpath();
    path.setFillRule(Qt::OddEvenFill);
    painter->setPen(Qt::NoPen);
    painter->setBrush(fill_);
    painter->drawPath(path);
  }

 private:
  QCPPolarAxisRadial* axis_;
  MapCurve curve_;
  QColor fill_;
};

/// Around the rotor how much an earlier map differed: a cell for each place, the darker the more; pale within its
/// doubt.
class Ring : public QCPAbstractItem {
 public:
  Ring(QCustomPlot* plot, QCPPolarAxisAngular* axis, const MapCurve& curve, const Look& look)
      : QCPAbstractItem(plot), axis_(axis), curve_(curve), look_(look) {}
  double selectTest(const QPointF&, bool, QVariant*) const override { return -1.0; }

 protected:
  void draw(QCPPainter* painter) override {
    double most = 0.0;
    for (const MapPoint& point : curve_.points)
      if (std::isfinite(point.value)) most = std::max(most, std::abs(point.value - curve_.lifted));
    const double whole_deg = 360.0, step_deg = whole_deg / static_cast<double>(curve_.points.size());
    painter->setAntialiasing(true);
    painter->setPen(Qt::NoPen);
    for (const MapPoint& point : curve_.points) {
      const double by = point.value - curve_.lifted, at_deg = point.at * 180.0 / std::numbers::pi;
      if (!std::isfinite(by)) continue;
      const bool told = std::abs(by) > normal95 * point.standardError;
      painter->setBrush(told ? ringInk(look_, by, most) : look_.grid);
      QPainterPath cell;
      cell.arcMoveTo(circle(ringOuter), at_deg - 0.5 * step_deg);
      cell.arcTo(circle(ringOuter), at_deg - 0.5 * step_deg, step_deg);
      cell.arcTo(circle(ringInner), at_deg + 0.5 * step_deg, -step_deg);
      cell.closeSubpath();
      painter->drawPath(cell);
    }
  }

 private:
  QRectF circle(double share) const {
    const double radius = share * axis_->radius();
    return {axis_->center() - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius)};
  }

  QCPPolarAxisAngular* axis_;
  MapCurve curve_;
  const Look& look_;
};

double degrees(double angle_rad) {
  return angle_rad * 180.0 / std::numbers::pi;
}

}  // namespace

QColor ringInk(const Look& look, double by, double most) {
  constexpr double least = 0.15;  // of the colour, where the difference is just beyond its doubt
  const double share = most > 0.0 ? std::min(1.0, std::abs(by) / most) : 0.0;
  return mixed(look.surface, look.curve(by > 0.0 ? 3 : 2), least + (1.0 - least) * share);
}

PolarPlot::PolarPlot(const char* objectName, QWidget* parent)
    : MapPlot(objectName, tr("Polar plot around the rotor; arrow keys read the points"), {800, 800}, parent) {
  QCustomPlot* const plot = &canvas();
  // An item asks for the plot's first axis rectangle, which the polar axis is none of.
  for (QCPItemText*& text : figure_) text = new QCPItemText(plot);
  for (QCPItemText*& text : sides_) text = new QCPItemText(plot);
  plot->plotLayout()->clear();
  axis_ = new QCPPolarAxisAngular(plot);
  axis_->setRangeDrag(false);
  axis_->setRangeZoom(false);
  axis_->setRange(0.0, 360.0);
  axis_->setMinimumMargins(QMargins(rim_px, rim_px, rim_px, rim_px));
  axis_->setAngle(0.0);  // zero to the right and growing counter-clockwise, as on the dial
  axis_->setRangeReversed(true);
  axis_->setTicker(QSharedPointer<RimTicker>::create());
  axis_->setNumberFormat("gb");
  QCPPolarAxisRadial* radius = axis_->radialAxis();
  radius->setRangeDrag(false);
  radius->setRangeZoom(false);
  radius->setAngle(radiusAxisAngle_deg);
  radius->setTickLabelMode(QCPPolarAxisRadial::lmUpright);
  radius->setTicker(QSharedPointer<RadiusTicker>::create(*axis_));
  radius->ticker()->setTickCount(4);
  radius->setNumberFormat("gb");
  plot->plotLayout()->addElement(0, 0, axis_);
  for (size_t k = 0; k < figure_.size(); ++k) {
    figure_[k]->setLayer("overlay");  // over the axis of the radius
    figure_[k]->setPadding(QMargins(6, 3, 6, 3));
    figure_[k]->position->setType(QCPItemPosition::ptAbsolute);
    figure_[k]->setPositionAlignment(Qt::AlignCenter);
    figure_[k]->setClipToAxisRect(false);
    figure_[k]->setVisible(false);
  }
  for (size_t k = 0; k < sides_.size(); ++k) {
    sides_[k]->setText(k == 0 ? QString("0°") : QString("180°"));
    sides_[k]->setRotation(k == 0 ? 90.0 : -90.0);
    sides_[k]->position->setType(QCPItemPosition::ptAbsolute);
    sides_[k]->setPositionAlignment(Qt::AlignCenter);
    sides_[k]->setClipToAxisRect(false);
  }
  // The middle is known once the layout is.
  QObject::connect(plot, &QCustomPlot::afterLayout, this, [this] {
    const double beside_px = axis_->radius() + besideRim_px;
    sides_[0]->position->setCoords(axis_->center() + QPointF(beside_px, 0.0));
    sides_[1]->position->setCoords(axis_->center() - QPointF(beside_px, 0.0));
    for (size_t k = 0; k < figure_.size(); ++k)
      figure_[k]->position->setCoords(axis_->center() + QPointF(0.0, figureGap_px * (static_cast<double>(k) - 1.0)));
  });
}

void PolarPlot::setFigure(const QString& what, const QString& value, const QString& doubt) {
  const QString texts[] = {what, value, doubt};
  for (size_t k = 0; k < figure_.size(); ++k) {
    figure_[k]->setText(texts[k]);
    figure_[k]->setVisible(!value.isEmpty());
  }
  canvas().replot(QCustomPlot::rpQueuedReplot);
}

void PolarPlot::drawBand(const MapCurve& curve, const Look& look) {
  if (!hasBand(curve) || !curve.closed) return;
  bands_.push_back(new Band(&canvas(), axis_->radialAxis(), curve, look.band(curve.colour)));
}

void PolarPlot::draw(const Look& look) {
  dress(canvas(), look);
  dress(*axis_, look);
  for (QCPPolarGraph* graph : graphs_) axis_->removeGraph(graph);
  graphs_.clear();
  for (QCPAbstractItem* band : bands_) canvas().removeItem(band);
  bands_.clear();
  for (const MapCurve& curve : curves()) {
    if (curve.part == MapPart::difference) drawRing(curve, look);
    if (!ofDifference(curve)) drawBand(curve, look);
  }
  for (const MapCurve& curve : curves())
    if (!ofDifference(curve)) drawCurve(curve, look);
  for (size_t k = 0; k < figure_.size(); ++k) {
    figure_[k]->setFont(typed(k == 1 ? Type::figure : Type::caption));
    figure_[k]->setColor(k == 1 ? look.ink : look.muted);
    figure_[k]->setBrush(look.surface);
  }
  for (QCPItemText* side : sides_) {
    side->setFont(axis_->tickLabelFont());
    side->setColor(axis_->tickLabelColor());
  }
  axis_->radialAxis()->setVisible(!curves().empty());
  mark_ = addGraph();
  mark_->setLineStyle(QCPPolarGraph::lsNone);
  mark_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(look.ink, 2), Qt::NoBrush, 11));
  rescale();
}

void PolarPlot::drawRing(const MapCurve& curve, const Look& look) {
  bands_.push_back(new Ring(&canvas(), axis_, curve, look));
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
  line->setPen(penOf(curve, look, 1.8));
  if (!curve.closed) line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, look.curve(curve.colour), 3));
  if (outlierAngle_deg.isEmpty()) return;
  QCPPolarGraph* crosses = addGraph();
  crosses->setData(outlierAngle_deg, outlierValue, true);
  crosses->setLineStyle(QCPPolarGraph::lsNone);
  crosses->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCross, QPen(look.trouble, 1.6), Qt::NoBrush, 8));
}

void PolarPlot::rescale() {
  const auto [lower, upper] = valueRange(0.0, roomForFigure, false);
  const bool ring = std::any_of(curves().begin(), curves().end(), ofDifference);
  highest_ = upper;
  axis_->radialAxis()->setRange(lower, ring ? lower + (upper - lower) / ringRoom : upper);
}

QPointF PolarPlot::pixelOf(const MapPoint& point) const {
  return axis_->radialAxis()->coordToPixel(degrees(point.at), radiusOf(point));
}

/// What lies above all curves is in the ring's middle.
double PolarPlot::radiusOf(const MapPoint& point) const {
  const QCPRange range = axis_->radialAxis()->range();
  return point.value > highest_ ? range.lower + 0.5 * (ringInner + ringOuter) * range.size() : point.value;
}

void PolarPlot::mark(const MapPoint& point) {
  mark_->setData({degrees(point.at)}, {radiusOf(point)}, true);
}

QString PolarPlot::placeOf(const MapPoint& point) const {
  return tr("%1°").arg(degrees(point.at), 0, 'f', 1);
}

}  // namespace breakaway
