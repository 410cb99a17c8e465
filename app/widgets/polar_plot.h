// Curves around the rotor: angle from the index in degrees, a quantity outwards; hover or arrow keys read a point.
#pragma once

#include <vector>

#include "widgets/map_plot.h"

class QCPPolarAxisAngular;
class QCPPolarGraph;

namespace breakaway {

class PolarPlot : public MapPlot {
  Q_OBJECT

 public:
  explicit PolarPlot(const char* objectName, QWidget* parent = nullptr);
  QPointF pixelOf(const MapPoint& point) const override;

 protected:
  void draw(const Look& look) override;
  void rescale() override;
  void mark(const MapPoint& point) override;
  QString placeOf(const MapPoint& point) const override;

 private:
  void drawCurve(const MapCurve& curve, const Look& look);
  QCPPolarGraph* addGraph();

  QCPPolarAxisAngular* axis_ = nullptr;
  QCPPolarGraph* mark_ = nullptr;
  std::vector<QCPPolarGraph*> graphs_;
};

}  // namespace breakaway
