// A linear axis as a strip: its ends, its index, and where it stands.
#pragma once

#include <QWidget>
#include <optional>

#include "experiment/travel.h"

namespace breakaway {

class TravelStrip : public QWidget {
  Q_OBJECT

 public:
  explicit TravelStrip(QWidget* parent = nullptr);

  /// Positions as the board gives them; without a travel the strip follows what it has seen of the axis.
  void show(std::optional<double> position_m, const std::optional<Travel>& travel, std::optional<double> index_m);
  using QWidget::show;
  QSize sizeHint() const override { return {420, 220}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Scale {
    double low_m, high_m, left_px, width_px;
    double x(double position_m) const { return left_px + width_px * (position_m - low_m) / (high_m - low_m); }
  };
  Scale scale() const;
  void paintRail(QPainter& painter, const Scale& scale, double y) const;
  void paintTicks(QPainter& painter, const Scale& scale, double y) const;
  void paintCarriage(QPainter& painter, const Scale& scale, double y) const;

  std::optional<double> position_m_, index_m_;
  std::optional<Travel> travel_;
  double seenLow_m_ = 0.0, seenHigh_m_ = 0.0;
};

}  // namespace breakaway
