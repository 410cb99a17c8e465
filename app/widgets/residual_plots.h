// Measurement over simulation, and beneath it the residual, over time or over the axis on which the two part.
#pragma once

#include <QString>
#include <QWidget>
#include <array>
#include <vector>

class QCPAxisRect;
class QCPGraph;
class QCPItemRect;
class QCPTextElement;
class QCustomPlot;

namespace breakaway {

class Comparison;

class ResidualPlots : public QWidget {
  Q_OBJECT

 public:
  ResidualPlots(Comparison& comparison, QWidget* parent = nullptr);

  /// The residual's horizontal axis: "time", "angle" or "velocity", as in Place::axis.
  void setAxis(const QString& axis);
  /// Axes that have highlighted bands, most important first.
  QStringList axes() const;
  QSize sizeHint() const override { return {600, 360}; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void buildPlot();
  void applyLook();
  void draw();
  void drawOverTime();
  void drawOverOther(const std::vector<double>& abscissa);
  void drawResidual(QCPGraph& graph, const std::vector<double>& abscissa, const std::vector<double>& position, bool line);
  void drawBands();
  std::vector<double> abscissa() const;
  double scale() const;

  Comparison& comparison_;
  QString axis_ = "time";
  QCustomPlot* plot_ = nullptr;
  QCPAxisRect* above_ = nullptr;
  QCPAxisRect* below_ = nullptr;
  QCPGraph* measured_ = nullptr;
  QCPGraph* simulated_ = nullptr;
  std::array<QCPGraph*, 2> residual_{};  ///< base, shown
  std::array<QCPTextElement*, 5> names_{};
  std::vector<QCPItemRect*> bands_;
};

}  // namespace breakaway
