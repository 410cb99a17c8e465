// Curves around the rotor: angle from the index in degrees, a quantity outwards; hover or arrow keys read a point.
#pragma once

#include <array>
#include <vector>

#include "widgets/map_plot.h"

class QCPPolarAxisAngular;
class QCPPolarGraph;
class QCPAbstractItem;
class QCPItemText;

namespace breakaway {

/// Of a cell of the ring of differences: `by` in the plot's unit, `most` the largest of them.
QColor ringInk(const Look& look, double by, double most);

class PolarPlot : public MapPlot {
  Q_OBJECT

 public:
  explicit PolarPlot(const char* objectName, QWidget* parent = nullptr);
  /// The one number, in the middle: what it is, its value, its doubt and unit. Without a value there is none.
  void setFigure(const QString& what, const QString& value, const QString& doubt);
  QPointF pixelOf(const MapPoint& point) const override;

 protected:
  void draw(const Look& look) override;
  void rescale() override;
  void mark(const MapPoint& point) override;
  QString placeOf(const MapPoint& point) const override;

 private:
  double radiusOf(const MapPoint& point) const;
  void drawCurve(const MapCurve& curve, const Look& look);
  void drawBand(const MapCurve& curve, const Look& look);
  void drawRing(const MapCurve& curve, const Look& look);
  QCPPolarGraph* addGraph();

  QCPPolarAxisAngular* axis_ = nullptr;
  QCPPolarGraph* mark_ = nullptr;
  std::vector<QCPPolarGraph*> graphs_;
  std::vector<QCPAbstractItem*> bands_;
  double highest_ = 0.0;                 ///< of what is drawn as a curve: what lies above is the ring's
  std::array<QCPItemText*, 2> sides_{};  ///< what 0° and 180° are called
  std::array<QCPItemText*, 3> figure_{};
};

}  // namespace breakaway
