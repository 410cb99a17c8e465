// What a finding, others in its place, the base model and a perfect one err by on unseen data: bars with intervals.
#pragma once

#include <QWidget>
#include <vector>

#include "report/error_bars.h"

namespace breakaway {

class RivalBars : public QWidget {
  Q_OBJECT

 public:
  RivalBars(const Diagnosis& diagnosis, const Finding& finding, QWidget* parent);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// A row: what it is called, its error, and how that compares with the finding's.
  struct Row {
    ErrorBar::Of of = ErrorBar::Of::base;
    QString name, value;
    double error = 0.0, low95 = 0.0, high95 = 0.0;
    bool alike = false;  ///< held-out data can't tell it from the finding
  };
  int valueWidth() const;

  std::vector<Row> rows_;
  double most_ = 0.0;  ///< the largest that is drawn
};

}  // namespace breakaway
