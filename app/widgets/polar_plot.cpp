#include "widgets/polar_plot.h"

#include <qcustomplot.h>

#include <QKeyEvent>
#include <QSvgGenerator>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr double near_px = 12.0;
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

PolarPlot::PolarPlot(const char* objectName, QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName(objectName);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  plot_->setObjectName(QString(objectName) + "Canvas");
  plot_->setAccessibleName(tr("Polar plot around the rotor; arrow keys read the points"));
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMouseTracking(true);
  plot_->setMinimumSize(200, 200);
  plot_->plotLayout()->clear();
  axis_ = new QCPPolarAxisAngular(plot_);
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
  plot_->plotLayout()->addElement(0, 0, axis_);
  plot_->installEventFilter(this);
}

void PolarPlot::show(const std::vector<PolarCurve>& curves, const QString& quantity, const QString& unit) {
  curves_ = curves;
  quantity_ = quantity;
  unit_ = unit;
  draw(Look::of(palette()));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PolarPlot::setRadiusFromZero(bool fromZero) {
  fromZero_ = fromZero;
  scaleRadius();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PolarPlot::draw(const Look& look) {
  dress(*plot_, look);
  dress(*axis_, look);
  for (QCPPolarGraph* graph : graphs_) axis_->removeGraph(graph);
  graphs_.clear();
  for (const PolarCurve& curve : curves_) drawCurve(curve, look);
  mark_ = addGraph();
  mark_->setLineStyle(QCPPolarGraph::lsNone);
  mark_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(look.ink, 2), Qt::NoBrush, 11));
  scaleRadius();
}

QCPPolarGraph* PolarPlot::addGraph() {
  graphs_.push_back(new QCPPolarGraph(axis_, axis_->radialAxis()));
  return graphs_.back();
}

void PolarPlot::drawCurve(const PolarCurve& curve, const Look& look) {
  QVector<double> angle_deg, value, outlierAngle_deg, outlierValue;
  for (const PolarPoint& point : curve.points) {
    angle_deg << degrees(point.angle_rad);
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

void PolarPlot::scaleRadius() {
  double least = std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::lowest();
  for (const PolarCurve& curve : curves_) {
    for (const PolarPoint& point : curve.points) {
      if (!std::isfinite(point.value)) continue;
      least = std::min(least, point.value);
      most = std::max(most, point.value);
    }
  }
  if (least > most) {
    least = 0.0;
    most = 1.0;
  }
  const double span = std::max(most - least, 1e-9 + 0.01 * std::abs(most));
  const double lower = fromZero_ ? std::min(0.0, least - 0.05 * span) : least - 0.35 * span;
  axis_->radialAxis()->setRange(lower, most + 0.06 * (most - lower));
}

QPointF PolarPlot::pixelOf(const PolarPoint& point) const {
  return axis_->radialAxis()->coordToPixel(degrees(point.angle_rad), point.value);
}

QString PolarPlot::textOf(const PolarCurve& curve, const PolarPoint& point) const {
  QString text =
      tr("%1 at %2°: %3").arg(curve.name).arg(degrees(point.angle_rad), 0, 'f', 1).arg(point.value, 0, 'g', 4);
  if (point.standardError > 0.0) text += tr(" ± %1").arg(1.96 * point.standardError, 0, 'g', 2);
  text += " " + unit_;
  if (point.standardError > 0.0) text += tr(" (95 %)");
  if (point.outlier) text += tr(", outlier");
  return text;
}

QString PolarPlot::readingAt(const QPointF& pixel) {
  double nearest = near_px;
  QString text;
  for (size_t curve = 0; curve < curves_.size(); ++curve) {
    for (size_t point = 0; point < curves_[curve].points.size(); ++point) {
      const QPointF away = pixelOf(curves_[curve].points[point]) - pixel;
      const double distance = std::hypot(away.x(), away.y());
      if (distance >= nearest) continue;
      nearest = distance;
      readCurve_ = curve;
      readPoint_ = point;
      text = textOf(curves_[curve], curves_[curve].points[point]);
    }
  }
  return text;
}

void PolarPlot::read(size_t curve, size_t point) {
  readCurve_ = curve;
  readPoint_ = point;
  const PolarPoint& at = curves_[curve].points[point];
  mark_->setData({degrees(at.angle_rad)}, {at.value}, true);
  plot_->replot(QCustomPlot::rpQueuedReplot);
  emit reading(textOf(curves_[curve], at));
}

void PolarPlot::stepReading(int by) {
  if (readCurve_ >= curves_.size() || curves_[readCurve_].points.empty()) return;
  const auto count = static_cast<int>(curves_[readCurve_].points.size());
  read(readCurve_, static_cast<size_t>(((static_cast<int>(readPoint_) + by) % count + count) % count));
}

bool PolarPlot::eventFilter(QObject* watched, QEvent* event) {
  if (watched == plot_ && event->type() == QEvent::MouseMove) {
    if (!readingAt(static_cast<QMouseEvent*>(event)->position()).isEmpty()) read(readCurve_, readPoint_);
  } else if (watched == plot_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right) {
      stepReading(key == Qt::Key_Right ? 1 : -1);
      return true;
    }
    if ((key == Qt::Key_Up || key == Qt::Key_Down) && !curves_.empty()) {
      readCurve_ = (readCurve_ + (key == Qt::Key_Down ? 1 : curves_.size() - 1)) % curves_.size();
      if (readPoint_ >= curves_[readCurve_].points.size()) readPoint_ = 0;
      stepReading(0);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void PolarPlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (plot_ == nullptr || (event->type() != QEvent::PaletteChange && event->type() != QEvent::FontChange)) return;
  draw(Look::of(palette()));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

bool PolarPlot::savePicture(const QString& path, bool svg) {
  draw(Look::of(lightPalette()));  // a picture for paper, whatever the screen shows
  constexpr int side = 800;
  bool saved = true;
  if (svg) {
    QSvgGenerator generator;
    generator.setFileName(path);
    generator.setSize(QSize(side, side));
    generator.setViewBox(QRect(0, 0, side, side));
    generator.setTitle(quantity_);
    QCPPainter painter;
    saved = painter.begin(&generator);
    if (saved) {
      painter.setMode(QCPPainter::pmVectorized);
      painter.setMode(QCPPainter::pmNoCaching);
      plot_->toPainter(&painter, side, side);
      painter.end();
    }
  } else {
    saved = plot_->savePng(path, side, side, 2.0);
  }
  draw(Look::of(palette()));
  plot_->replot(QCustomPlot::rpQueuedReplot);
  return saved;
}

}  // namespace breakaway
