// The orders of the turn as bars, one colour a curve.
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/map_curve.h"

class QCustomPlot;

namespace breakaway {

class HarmonicsPlot : public QWidget {
  Q_OBJECT

 public:
  explicit HarmonicsPlot(QWidget* parent = nullptr);
  void show(const std::vector<MapCurve>& curves);
  using QWidget::show;
  /// No curve is whole yet.
  bool isEmpty() const { return curves_.empty(); }

 private:
  void draw();

  QCustomPlot* plot_ = nullptr;
  std::vector<MapCurve> curves_;
};

}  // namespace breakaway
