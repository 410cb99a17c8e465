// What the current's noise would be if the speed observer were slower or faster, the gains as they are set.
#pragma once

#include <QWidget>

#include "stability/loop_noise.h"

class QCustomPlot;

namespace breakaway {

class ObserverNoisePlot : public QWidget {
  Q_OBJECT

 public:
  explicit ObserverNoisePlot(QWidget* parent = nullptr);
  /// `most_A` is what the noise should stay below; 0: nothing is drawn for it.
  void show(const ObserverNoise& noise, double most_A);
  using QWidget::show;

 private:
  void draw();

  QCustomPlot* plot_ = nullptr;
  ObserverNoise noise_;
  double most_A_ = 0.0;
};

}  // namespace breakaway
