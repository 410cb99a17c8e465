// What a diagnosis rests on, as pictures: the evidence over the finding's own axis, and the motion with its residual.
// Both stand there where both are high enough to be read; else one, and chips say which.
#pragma once

#include <QString>
#include <QWidget>
#include <utility>

class QComboBox;
class QPushButton;
class QResizeEvent;

namespace breakaway {

class Comparison;
class ResidualPlots;

class ComparedPlots : public QWidget {
  Q_OBJECT

 public:
  explicit ComparedPlots(Comparison& comparison, QWidget* parent = nullptr);

  /// Shows the residual over this axis, named as in Place::axis.
  void showResidualOver(const QString& axis);
  /// Shows what a finding rests on.
  void showEvidenceOf(const QString& effect);
  /// From when to when the measurement is shown, in s.
  std::pair<double, double> visible_s() const;
  /// Whether what is visible can be kept, else why not.
  void setKeepObstacle(const QString& reason);

 signals:
  void visibleChanged();
  void keepAsked();
  /// What is read off under the cursor.
  void reading(const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* buildRow();
  void choose(bool evidence);
  void arrange();

  Comparison& comparison_;
  QPushButton* evidenceChip_ = nullptr;
  QPushButton* motionChip_ = nullptr;
  QComboBox* axis_ = nullptr;
  QPushButton* keep_ = nullptr;
  QWidget* evidence_ = nullptr;
  QWidget* motion_ = nullptr;
  ResidualPlots* plots_ = nullptr;
  bool evidenceWanted_ = true;
};

}  // namespace breakaway
