// The friction map as it grows, in one of its views: around the rotor or over the travel, with legend and reading.
#pragma once

#include <QWidget>

#include "commission/known.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QStackedWidget;

namespace breakaway {

class MapPlot;

class MapPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MapPanel(QWidget* parent = nullptr);

  void show(const Commission& known);
  using QWidget::show;
  /// The picture of the chosen view; whether it could be written.
  bool savePicture(const QString& path, bool svg);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showViews();
  void showMap();
  void showLegend();
  MapPlot& plot() const;

  Commission known_;
  bool chosen_ = false;  ///< the view, by somebody
  QComboBox* view_ = nullptr;
  QCheckBox* fromZero_ = nullptr;
  QStackedWidget* plots_ = nullptr;
  QLabel* legend_ = nullptr;
  QLabel* reading_ = nullptr;
  QLabel* quantity_ = nullptr;
};

}  // namespace breakaway
