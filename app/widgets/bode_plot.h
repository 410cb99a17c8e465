// The open loop's gain and phase over frequency, with both margins marked; what the board has, dashed.
#pragma once

#include <QWidget>

#include "stability/margins.h"

class QCPAxisRect;
class QCPTextElement;
class QCustomPlot;

namespace breakaway {

class BodePlot : public QWidget {
  Q_OBJECT

 public:
  explicit BodePlot(QWidget* parent = nullptr);
  void show(const LoopResponse& edited, const LoopMargins& margins, const LoopResponse& onBoard);
  using QWidget::show;

 private:
  void draw();
  void drawResponse(const LoopResponse& response, const QPen& pen);
  void drawMargins();

  QCustomPlot* plot_ = nullptr;
  QCPAxisRect* gain_ = nullptr;
  QCPAxisRect* phase_ = nullptr;
  QCPTextElement* titles_[2]{};
  LoopResponse edited_, onBoard_;
  LoopMargins margins_;
};

}  // namespace breakaway
