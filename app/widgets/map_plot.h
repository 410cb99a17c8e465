// What a polar plot around a rotor and a plot over a travel share: curves, reading by hover and arrow keys, pictures.
#pragma once

#include <QPen>
#include <QSize>
#include <QString>
#include <QWidget>
#include <utility>
#include <vector>

#include "widgets/map_curve.h"

class QCustomPlot;

namespace breakaway {

struct Look;

class MapPlot : public QWidget {
  Q_OBJECT

 public:
  /// `quantity` names the values with their unit ("breakaway torque (mNm)"), `unit` is the unit alone.
  void show(const std::vector<MapCurve>& curves, const QString& quantity, const QString& unit);
  using QWidget::show;
  /// Whether the scale of values begins at zero, or below the least value.
  void setFromZero(bool fromZero);
  const std::vector<MapCurve>& curves() const { return curves_; }
  /// What hovering at this point of the plot would say; empty when no point is near.
  QString readingAt(const QPointF& pixel);
  /// The pixel of a point, for tests and for the keyboard.
  virtual QPointF pixelOf(const MapPoint& point) const = 0;

  bool savePng(const QString& path) { return savePicture(path, false); }
  bool saveSvg(const QString& path) { return savePicture(path, true); }

 signals:
  void reading(const QString& text);

 protected:
  /// `picture`: in pixels, of what is saved.
  MapPlot(const char* objectName, const QString& accessibleName, QSize picture, QWidget* parent);
  bool eventFilter(QObject* watched, QEvent* event) override;

  virtual void draw(const Look& look) = 0;
  virtual void rescale() = 0;
  virtual void mark(const MapPoint& point) = 0;
  /// "123.4°"
  virtual QString placeOf(const MapPoint& point) const = 0;

  /// Least and highest value to show, of `doubt` times the standard errors, too. Where the scale doesn't begin at zero,
  /// `below` of the values' span stays free beneath them. Differences from an earlier map count only `withDifferences`.
  std::pair<double, double> valueRange(double doubt, double below, bool withDifferences) const;
  /// What its axis of values has to say by itself: nothing on the page, whose heading does.
  QString axisTitle() const { return inFile_ ? quantity_ : QString(); }
  QCustomPlot& canvas() const { return *plot_; }
  /// Of a curve's line; `width_px` where it is what is shown.
  static QPen penOf(const MapCurve& curve, const Look& look, double width_px);
  /// Whether the curve's interval is drawn.
  static bool hasBand(const MapCurve& curve);

 private:
  void redraw();
  void read(size_t curve, size_t point);
  void stepReading(int by);
  bool savePicture(const QString& path, bool svg);
  QString textOf(const MapCurve& curve, const MapPoint& point) const;

  QCustomPlot* plot_ = nullptr;
  QSize picture_;
  std::vector<MapCurve> curves_;
  QString quantity_;
  QString unit_;
  bool fromZero_ = true, inFile_ = false;
  size_t readCurve_ = 0;
  size_t readPoint_ = 0;
};

}  // namespace breakaway
