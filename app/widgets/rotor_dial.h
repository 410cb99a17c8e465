// The rotor as a dial: where it stands, and where its index is once that is known.
#pragma once

#include <QWidget>
#include <optional>

namespace breakaway {

class RotorDial : public QWidget {
  Q_OBJECT

 public:
  explicit RotorDial(QWidget* parent = nullptr);

  /// Angles as the board gives them; without an index the dial's zero is the board's own.
  void show(std::optional<double> angle_rad, std::optional<double> index_rad);
  using QWidget::show;
  /// The way since a homing began, as an arc; how far it may still go before the index must have come, in words.
  void showWay(std::optional<double> begin_rad, std::optional<double> most_rad);
  QSize sizeHint() const override { return {300, 300}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintScale(QPainter& painter, double radius) const;
  void paintWay(QPainter& painter, double radius) const;
  void paintHand(QPainter& painter, double radius) const;

  std::optional<double> angle_rad_;
  std::optional<double> index_rad_;
  std::optional<double> begin_rad_, most_rad_;
};

}  // namespace breakaway
