// What the motor was identified from, as a whole or step by step: points as measured, lines as identified. The
// standing motor's current over its voltage, whose slope is the resistance; the turning motor's back-EMF over its
// speed, whose slope is its constant; and each test's own course.
#pragma once

#include <QVariant>
#include <QWidget>
#include <array>
#include <vector>

class QCPAxisRect;
class QCPGraph;
class QCPTextElement;
class QCustomPlot;
class QPushButton;

namespace breakaway {

struct Commission;
struct TestCurve;

class MotorTestsPlot : public QWidget {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  explicit MotorTestsPlot(QWidget* parent = nullptr);
  /// Draws what of it is known; tests that were made in another window aren't.
  void show(const Commission& known);
  using QWidget::show;

  /// Which step is shown.
  QVariant kept() const { return chosen_; }
  void take(const QVariant& kept) { choose(kept.toInt()); }

 signals:
  /// Another step is to be shown.
  void chosen();

 private:
  enum View { all, winding, spin, reversal, views };
  struct Half {
    QCPTextElement* title = nullptr;
    QCPAxisRect* rect = nullptr;
    QCPGraph *points = nullptr, *line = nullptr;
    bool drawn = false;
  };

  void build(Half& half, int column);
  QWidget* buildChips();
  void choose(int view);
  static bool isThere(const Commission& known, int view);
  void showChips(const Commission& known);
  void drawStanding(const Commission& known);
  void drawTurning(const Commission& known);
  /// As measured: single points, or a course.
  void put(Half& half, const QString& title, const TestCurve& curve, bool course);
  void applyLook();

  QCustomPlot* plot_ = nullptr;
  std::array<Half, 2> halves_;
  std::array<QPushButton*, views> chips_{};
  QCPTextElement* hint_ = nullptr;
  int chosen_ = all;
};

}  // namespace breakaway
