// What the motor was identified from: the current of the standing motor over its voltage, whose slope is the
// resistance, and the turning motor's back-EMF over its speed, whose slope is its constant; points as measured, lines
// as identified.
#pragma once

#include <QWidget>
#include <array>

class QCPAxisRect;
class QCPGraph;
class QCPTextElement;
class QCustomPlot;

namespace breakaway {

struct Commission;

class MotorTestsPlot : public QWidget {
  Q_OBJECT

 public:
  explicit MotorTestsPlot(QWidget* parent = nullptr);
  /// Draws what of it is known; tests that were made in another window aren't.
  void show(const Commission& known);
  using QWidget::show;

 private:
  struct Half {
    QCPTextElement* title = nullptr;
    QCPAxisRect* rect = nullptr;
    QCPGraph *points = nullptr, *line = nullptr;
  };

  void build(Half& half, int column);
  void drawStanding(const Commission& known);
  void drawTurning(const Commission& known);
  void applyLook();

  QCustomPlot* plot_ = nullptr;
  std::array<Half, 2> halves_;  ///< standing, turning
  QCPTextElement* hint_ = nullptr;
};

}  // namespace breakaway
