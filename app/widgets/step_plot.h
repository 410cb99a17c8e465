// A measured velocity step over time, earlier ones behind it as ghosts, and the current that it took beneath.
#pragma once

#include <QWidget>
#include <vector>

#include "session/run.h"

class QCPAxisRect;
class QCPGraph;
class QCPTextElement;
class QCustomPlot;

namespace breakaway {

class StepPlot : public QWidget {
  Q_OBJECT

 public:
  explicit StepPlot(QWidget* parent = nullptr);

  /// The last step is drawn in full, those before it as ghosts.
  void show(const std::vector<StepResult>& steps);
  using QWidget::show;
  void setSpeedUnit(const QString& unit);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void draw();
  void drawStep(const StepResult& step, bool newest);

  QCustomPlot* plot_ = nullptr;
  QCPAxisRect* velocity_ = nullptr;
  QCPAxisRect* current_ = nullptr;
  QCPTextElement* hint_ = nullptr;
  std::vector<StepResult> steps_;
};

}  // namespace breakaway
