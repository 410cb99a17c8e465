// Measurement over simulation, and beneath it the residual, over time or over the axis on which the two part.
#pragma once

#include <QString>
#include <QVariant>
#include <QVector>
#include <QWidget>
#include <array>
#include <utility>
#include <vector>

class QCPAxisRect;
class QCPGraph;
class QCPGraphData;
class QCPItemRect;
class QCPTextElement;
class QCustomPlot;

namespace breakaway {

class Comparison;
class Recording;

class ResidualPlots : public QWidget {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  explicit ResidualPlots(Comparison& comparison, QWidget* parent = nullptr);

  /// The residual's horizontal axis, named as in Place::axis.
  void setAxis(const QString& axis);
  const QString& axis() const { return axis_; }
  /// From when to when the measurement is shown, in s.
  std::pair<double, double> visible_s() const;
  /// Highlighted stretches that are drawn now.
  size_t bands() const { return bands_.size(); }
  /// Whether what is drawn beneath is torque.
  bool inTorque() const;

  /// Which axis is chosen, and the parts that are visible.
  QVariant kept() const;
  void take(const QVariant& kept);

 signals:
  void visibleChanged();

 private:
  void buildPlot();
  void addHead(size_t plot);
  void applyLook();
  void draw();
  void showAll();
  void showAllOf(QCPAxisRect& rect);
  bool linear() const;
  double scale() const;  ///< shown position = scale · SI
  void nameParts();
  void drawMeasured();
  void drawBeneath();
  void drawSmooth(QCPGraph& graph, const QVector<QCPGraphData>& points);
  size_t mostParts() const;
  void drawMeasurement(const Recording& recording);
  void drawResiduals(const Recording& recording);
  void drawTorques(const Recording& recording);
  void drawPoints(QCPGraph& graph, const QVector<QCPGraphData>& points);
  void scaleResiduals();
  void drawBands();

  Comparison& comparison_;
  QString axis_ = "time";
  QCustomPlot* plot_ = nullptr;
  QCPAxisRect* above_ = nullptr;
  QCPAxisRect* below_ = nullptr;
  QCPGraph* measured_ = nullptr;
  QCPGraph* simulated_ = nullptr;
  std::array<QCPGraph*, 2> residual_{};  ///< base, with findings
  QCPGraph* beneath_ = nullptr;          ///< another recording
  std::array<QCPTextElement*, 2> titles_{};
  std::array<QCPTextElement*, 4> names_{};  ///< measured, simulated, base, with findings
  QCPTextElement* hint_ = nullptr;
  QCPTextElement* wanderName_ = nullptr;
  QCPItemRect* wander_ = nullptr;  ///< within which a perfect model's torque would stay
  std::vector<QCPItemRect*> bands_;
};

}  // namespace breakaway
