// Curves around the rotor: angle from the index in degrees, a quantity outwards; hover or arrow keys read a point.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QCPPolarAxisAngular;
class QCPPolarGraph;
class QCustomPlot;

namespace breakaway {

struct Look;

struct PolarPoint {
  double angle_rad = 0.0;
  double value = 0.0;          ///< in the plot's unit
  double standardError = 0.0;  ///< 0: not known
  bool outlier = false;
};

struct PolarCurve {
  QString name;
  int colour = 0;  ///< of Look::curve
  bool dashed = false;
  bool closed = false;             ///< all around: the last point joins the first
  std::vector<PolarPoint> points;  ///< by growing angle
};

class PolarPlot : public QWidget {
  Q_OBJECT

 public:
  explicit PolarPlot(const char* objectName, QWidget* parent = nullptr);

  /// `quantity` names the radius with its unit ("breakaway torque (mNm)"), `unit` is the unit alone.
  void show(const std::vector<PolarCurve>& curves, const QString& quantity, const QString& unit);
  using QWidget::show;
  void setRadiusFromZero(bool fromZero);
  const std::vector<PolarCurve>& curves() const { return curves_; }
  /// What hovering at this point of the plot would say; empty when no point is near.
  QString readingAt(const QPointF& pixel);
  /// The pixel of a point, for tests and for the keyboard.
  QPointF pixelOf(const PolarPoint& point) const;

  bool savePng(const QString& path) { return savePicture(path, false); }
  bool saveSvg(const QString& path) { return savePicture(path, true); }

 signals:
  void reading(const QString& text);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void draw(const Look& look);
  void drawCurve(const PolarCurve& curve, const Look& look);
  QCPPolarGraph* addGraph();
  void scaleRadius();
  void read(size_t curve, size_t point);
  void stepReading(int by);
  bool savePicture(const QString& path, bool svg);
  QString textOf(const PolarCurve& curve, const PolarPoint& point) const;

  QCustomPlot* plot_ = nullptr;
  QCPPolarAxisAngular* axis_ = nullptr;
  QCPPolarGraph* mark_ = nullptr;
  std::vector<QCPPolarGraph*> graphs_;
  std::vector<PolarCurve> curves_;
  QString quantity_;
  QString unit_;
  bool fromZero_ = true;
  size_t readCurve_ = 0;
  size_t readPoint_ = 0;
};

}  // namespace breakaway
