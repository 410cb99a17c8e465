// The residual torque over the finding's own axis, before and after the finding is in, with 95 % bands.
#pragma once

#include <QWidget>
#include <array>

class QCPTextElement;
class QCustomPlot;

namespace breakaway {

class Comparison;
struct ResidualMap;

/// Whether a line may lead from this cell to the next one: both have a mean, and lie as near as most cells do.
bool leadsOn(const ResidualMap& map, size_t cell);

/// Means of cells with their intervals as a band, which joins only neighbours; the law of the findings is a line
/// through what the base model leaves.
class EvidencePlot : public QWidget {
  Q_OBJECT

 public:
  explicit EvidencePlot(Comparison& comparison, QWidget* parent = nullptr);

 signals:
  void reading(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void draw();
  void showTitle();
  void drawLaw();
  void drawMap(const ResidualMap& map, int colour);
  void read(double x);

  Comparison& comparison_;
  QCustomPlot* plot_ = nullptr;
  QCPTextElement* title_ = nullptr;
  std::array<QCPTextElement*, 3> names_{};  ///< before, the law in it, after
  QCPTextElement* hint_ = nullptr;
};

}  // namespace breakaway
