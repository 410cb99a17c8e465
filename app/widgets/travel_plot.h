// Curves over a linear axis' travel, or over a turn laid flat: the place from the index, a quantity upwards with its 95
// % band; hover or arrow keys read a point.
#pragma once

#include <optional>

#include "experiment/travel.h"
#include "widgets/map_plot.h"

class QCPGraph;

namespace breakaway {

class TravelPlot : public MapPlot {
  Q_OBJECT

 public:
  enum class Places { travel, turn };
  /// `places`: over an axis' travel in mm, or over one turn in degrees.
  TravelPlot(const char* objectName, Places places, QWidget* parent = nullptr);
  /// What the axis of places shows, counted from the index.
  void setTravel(const std::optional<Travel>& travel) { travel_ = travel; }
  QPointF pixelOf(const MapPoint& point) const override;

 protected:
  void draw(const Look& look) override;
  void rescale() override;
  void mark(const MapPoint& point) override;
  QString placeOf(const MapPoint& point) const override;

 private:
  void drawBand(const MapCurve& curve, const Look& look);
  void drawCurve(const MapCurve& curve, const Look& look);

  double shown(double at) const;

  Places places_;
  std::optional<Travel> travel_;
  QCPGraph* mark_ = nullptr;
};

}  // namespace breakaway
