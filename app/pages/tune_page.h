// Tune: gains and observer cutoff. What they will make of the motor is foretold while they move; nothing is sent before
// Apply. Measured steps lie over the foretold one.
#pragma once

#include <QTimer>
#include <optional>
#include <vector>

#include "experiment/identity.h"
#include "experiment/position_step.h"
#include "pages/page.h"
#include "session/tuning_preview.h"

class QPushButton;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;

namespace breakaway {

class BenchRuns;
class BodePlot;
class Connection;
class FigureChip;
class LocusPlot;
class ObserverNoisePlot;
class QuantitySlider;
class SettingsEdits;
class StepPlot;
class StepTable;

class TunePage : public Page {
  Q_OBJECT

 public:
  TunePage(Connection& connection, BenchRuns& bench, SettingsEdits& edits, QWidget* parent = nullptr);
  /// Beside the parameters the step is left of its plots.
  /// Of what is set on the page, as far as it was computed.
  const TuningPreview& preview() const { return preview_; }

 protected:
  bool staysBeside() const override { return true; }
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Slider {
    QuantitySlider* widget;
    double ControllerSettings::*field;
  };

  QWidget* buildControls();
  QWidget* buildTuning();
  QWidget* buildUndo();
  QWidget* buildChips();
  QWidget* buildPlots();
  QWidget* buildLoops();
  QWidget* buildLocusOrNoise(QWidget* parent);
  QWidget* buildStep();
  QuantitySlider* addSlider(const QString& objectName, double ControllerSettings::*field);
  void showLoop(bool position);
  void showCurve();
  void wordForAxis();
  void meetBoard();
  void showSliders();
  void showEdits();
  void foretell();
  void showChips();
  void arrangeChips(int columns);
  void showSteps();
  void showMotion();
  void measure();
  VelocityStepOptions step() const;
  PositionStepOptions positionStep() const;

  Connection& connection_;
  BenchRuns& bench_;
  SettingsEdits& edits_;
  TuningPreview preview_, onBoard_;
  FrictionSource frictionSource_ = FrictionSource::none;  ///< of what is foretold
  std::vector<Slider> sliders_;
  std::vector<QPushButton*> stiffness_;
  QDoubleSpinBox* height_ = nullptr;
  QDoubleSpinBox* travel_ = nullptr;  ///< the position loop's step, in ° or mm
  QPushButton* velocityLoop_ = nullptr;
  QPushButton* positionLoop_ = nullptr;
  bool position_ = false;       ///< which loop is shown
  std::optional<Axis> worded_;  ///< the axis that the page speaks of
  QPushButton* apply_ = nullptr;
  QPushButton* measure_ = nullptr;
  QPushButton* forget_ = nullptr;
  QPushButton* undo_ = nullptr;
  QPushButton* redo_ = nullptr;
  QPushButton* revert_ = nullptr;
  FigureChip* phase_ = nullptr;
  FigureChip* gain_ = nullptr;
  FigureChip* rule_ = nullptr;
  FigureChip* noise_ = nullptr;
  QWidget* loops_ = nullptr;  ///< Bode plot and root locus
  bool whole_ = true;         ///< there is room for them
  StepPlot* plot_ = nullptr;
  BodePlot* bode_ = nullptr;
  LocusPlot* locus_ = nullptr;
  ObserverNoisePlot* observerNoise_ = nullptr;
  StepTable* table_ = nullptr;
  QLabel* source_ = nullptr;
  QGridLayout* chips_ = nullptr;
  QTimer soon_;
};

}  // namespace breakaway
