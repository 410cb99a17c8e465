// Where the closed loop's poles go as the observer's cutoff grows, and where they are now.
#pragma once

#include <QWidget>
#include <complex>
#include <vector>

#include "stability/root_locus.h"

class QCustomPlot;

namespace breakaway {

class LocusPlot : public QWidget {
  Q_OBJECT

 public:
  explicit LocusPlot(QWidget* parent = nullptr);
  /// `cutoff_rad_per_s` is where the poles are now; `tick_s` takes them from the z plane to the s plane. `onBoard` and
  /// its cutoff: of the board's settings where these are others, else empty.
  void show(const RootLocus& locus, double cutoff_rad_per_s, double tick_s, const RootLocus& onBoard = {},
            double boardCutoff_rad_per_s = 0.0);
  using QWidget::show;

 private:
  void draw();
  void drawDamping(double reach);
  void drawPoles(const std::vector<std::complex<double>>& poles, const QColor& ink);
  /// In the s plane, 1/s.
  std::vector<std::complex<double>> polesAt(const RootLocus& locus, double cutoff_rad_per_s) const;
  double reachOf(const std::vector<std::complex<double>>& poles) const;

  QCustomPlot* plot_ = nullptr;
  RootLocus locus_, onBoard_;
  double cutoff_rad_per_s_ = 0.0, boardCutoff_rad_per_s_ = 0.0, tick_s_ = 0.0;
};

}  // namespace breakaway
