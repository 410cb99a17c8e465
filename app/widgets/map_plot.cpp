#include "widgets/map_plot.h"

#include <qcustomplot.h>

#include <QBuffer>
#include <QImage>
#include <QKeyEvent>
#include <QSvgGenerator>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/atomic_file.h"
#include "base/made.h"
#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr double near_px = 12.0;

}  // namespace

MapPlot::MapPlot(const char* objectName, const QString& accessibleName, QSize picture, QWidget* parent)
    : QWidget(parent), plot_(new QCustomPlot(this)), picture_(picture) {
  setObjectName(objectName);
  auto* layout = columnIn(this);
  layout->addWidget(plot_);
  plot_->setObjectName(QString(objectName) + "Canvas");
  plot_->setAccessibleName(accessibleName);
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setToolTip(tr("Point at it, or use the arrow keys, to read a value"));
  plot_->setMouseTracking(true);
  plot_->setMinimumSize(200, 200);
  plot_->installEventFilter(this);
  onNewLook(this, [this] { redraw(); });
}

void MapPlot::show(const std::vector<MapCurve>& curves, const QString& quantity, const QString& unit) {
  curves_ = curves;
  quantity_ = quantity;
  unit_ = unit;
  redraw();
}

void MapPlot::redraw() {
  draw(Look::of(palette()));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void MapPlot::setFromZero(bool fromZero) {
  fromZero_ = fromZero;
  rescale();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

std::pair<double, double> MapPlot::valueRange(double doubt, double below, bool withDifferences) const {
  double least = std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::lowest();
  for (const MapCurve& curve : curves_) {
    if (!withDifferences && ofDifference(curve)) continue;
    for (const MapPoint& point : curve.points) {
      if (!std::isfinite(point.value)) continue;
      least = std::min(least, point.value - doubt * point.standardError);
      most = std::max(most, point.value + doubt * point.standardError);
    }
  }
  if (least > most) return {0.0, 1.0};
  const double span = std::max(most - least, 1e-9 + 0.01 * std::abs(most));
  const double lower = fromZero_ ? std::min(0.0, least - 0.05 * span) : least - below * span;
  return {lower, most + 0.06 * (most - lower)};
}

QString MapPlot::textOf(const MapCurve& curve, const MapPoint& point) const {
  MapPoint read = point;
  read.value -= curve.lifted;
  return tr("%1 at %2: %3").arg(curve.name, placeOf(point), readingOf(read, unit_));
}

QPen MapPlot::penOf(const MapCurve& curve, const Look& look, double width_px) {
  switch (curve.part) {
    case MapPart::earlier:
      return {look.measured(curve.colour), 1.6, Qt::DashLine};
    case MapPart::noDifference:
      return {look.border, 1.0, Qt::DashLine};
    case MapPart::difference:
    case MapPart::shown:
      break;
  }
  return {look.curve(curve.colour), curve.dashed ? 0.8 * width_px : width_px,
          curve.dashed ? Qt::DashLine : Qt::SolidLine};
}

bool MapPlot::hasBand(const MapCurve& curve) {
  const bool known = std::any_of(curve.points.begin(), curve.points.end(),
                                 [](const MapPoint& point) { return point.standardError > 0.0; });
  return known && (curve.part == MapPart::shown || curve.part == MapPart::difference);
}

QString MapPlot::readingAt(const QPointF& pixel) {
  double nearest = near_px;
  QString text;
  for (size_t curve = 0; curve < curves_.size(); ++curve) {
    if (curves_[curve].part == MapPart::noDifference) continue;  // says nothing of the motor
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

void MapPlot::read(size_t curve, size_t point) {
  readCurve_ = curve;
  readPoint_ = point;
  const MapPoint& at = curves_[curve].points[point];
  mark(at);
  plot_->replot(QCustomPlot::rpQueuedReplot);
  emit reading(textOf(curves_[curve], at));
}

void MapPlot::stepReading(int by) {
  if (readCurve_ >= curves_.size() || curves_[readCurve_].points.empty()) return;
  const auto count = static_cast<int>(curves_[readCurve_].points.size());
  read(readCurve_, static_cast<size_t>(((static_cast<int>(readPoint_) + by) % count + count) % count));
}

bool MapPlot::eventFilter(QObject* watched, QEvent* event) {
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

bool MapPlot::savePicture(const QString& path, bool svg) {
  inFile_ = true;
  draw(Look::light());  // a picture for paper, whatever the screen shows
  bool saved = true;
  if (svg) {
    QBuffer drawn;
    drawn.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&drawn);
    generator.setSize(picture_);
    generator.setViewBox(QRect(QPoint(0, 0), picture_));
    generator.setTitle(quantity_);
    QCPPainter painter;
    saved = painter.begin(&generator);
    if (saved) {
      painter.setMode(QCPPainter::pmVectorized);
      painter.setMode(QCPPainter::pmNoCaching);
      plot_->toPainter(&painter, picture_.width(), picture_.height());
      painter.end();
      saved = writeFile(path.toStdString(), svgWithMade(drawn.data().toStdString())).ok();
    }
  } else {
    QImage drawn = plot_->toPixmap(picture_.width(), picture_.height(), 2.0).toImage();
    drawn.setText("made", QString::fromStdString(madeJson()));
    saved = drawn.save(path, "PNG");
  }
  inFile_ = false;
  redraw();
  return saved;
}

}  // namespace breakaway
