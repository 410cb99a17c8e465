// Velocity steps over time, and the current that each takes beneath: measured ones thick and pale, the one that is
// foretold thin and full.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "session/run.h"

class QCPAxisRect;
class QCPLayoutGrid;
class QCPTextElement;
class QCustomPlot;

namespace breakaway {

class StepPlot : public QWidget {
  Q_OBJECT

 public:
  explicit StepPlot(QWidget* parent = nullptr);
  void show(const std::vector<StepResult>& steps);
  using QWidget::show;
  /// What the settings on the page would make, and those on the board where they are others; empty: nothing is
  /// foretold.
  void foretell(const StepCurve& curve, const StepCurve& onBoard = {});
  /// What steps, with its unit.
  void setQuantity(const QString& title);
  const StepCurve& foretold() const { return foretold_; }
  const StepCurve& onBoard() const { return onBoard_; }

  /// The colour in which a measured step is drawn, its number counted from 0.
  static int colourOf(size_t step);
  /// The first of so many that is still drawn.
  static size_t firstDrawn(size_t steps);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void draw();
  void nameCurves();
  void drawCurve(const StepCurve& curve, const QPen& pen);

  QCustomPlot* plot_ = nullptr;
  QCPAxisRect* velocity_ = nullptr;
  QCPAxisRect* current_ = nullptr;
  QCPTextElement* hint_ = nullptr;
  QCPTextElement* titles_[2]{};
  QCPLayoutGrid* head_ = nullptr;  ///< title, and what each curve is
  QString speedUnit_;
  std::vector<StepResult> steps_;
  StepCurve foretold_, onBoard_;
};

}  // namespace breakaway
