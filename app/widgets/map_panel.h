// The friction map as it grows: around the rotor with its Cartesian twin and its harmonics, or over the travel; with
// chips for what is shown.
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "commission/known.h"
#include "widgets/map_curve.h"
#include "widgets/map_views.h"

class QBoxLayout;
class QSpacerItem;
class QAbstractButton;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace breakaway {

class HarmonicsPlot;
class MapPlot;
class PolarPlot;
class TravelPlot;

class MapPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MapPanel(QWidget* parent = nullptr);
  void show(const Commission& known);
  using QWidget::show;
  /// Whether a sweep runs whose first places haven't come yet.
  void setUnderWay(bool underWay);
  /// Lies beneath what is shown, dashed, as long as it is of the same kind of axis; nothing takes it away.
  void layBeneath(const std::optional<FrictionMap>& earlier);
  /// The picture of the chosen view; whether it could be written.
  bool savePicture(const QString& path, bool svg);

 signals:
  void reading(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void resizeEvent(QResizeEvent* event) override;
  QWidget* buildChips();
  QWidget* buildRotor();
  void showViews();
  void showMap();
  void showBeside(const MapPicture& picture);
  void showLegend(const std::vector<MapCurve>& curves);
  void showRingLegend(const MapPicture& picture);
  std::optional<Estimate> average() const;
  void showFigure(const MapPicture& picture);
  MapPlot& plot() const;

  Commission known_;
  std::optional<FrictionMap> earlier_;
  MapView view_ = MapView::turns;
  bool chosen_ = false;  ///< the view, by somebody
  bool underWay_ = false;
  std::vector<QPushButton*> views_;
  std::array<QPushButton*, 2> ways_{};  ///< ccw, cw
  QPushButton* fromZero_ = nullptr;
  QBoxLayout* chips_ = nullptr;    ///< kinds; ways and radius
  QSpacerItem* wayGap_ = nullptr;  ///< between them
  QStackedWidget* plots_ = nullptr;
  QWidget* side_ = nullptr;  ///< of the circle: its twin and its harmonics
  PolarPlot* polar_ = nullptr;
  TravelPlot* twin_ = nullptr;
  TravelPlot* travel_ = nullptr;
  HarmonicsPlot* harmonics_ = nullptr;
  QLabel* twinHint_ = nullptr;
  QLabel* harmonicsHint_ = nullptr;
  QLabel* quantity_ = nullptr;
  QLabel* twinQuantity_ = nullptr;
  QLabel* harmonicsTitle_ = nullptr;
  QLabel* travelQuantity_ = nullptr;
  QLabel *legend_ = nullptr, *ringLegend_ = nullptr;
  QLabel* travelLegend_ = nullptr;
};

}  // namespace breakaway
