// Tune: gains and observer cutoff, applied while they move, and the velocity step that they make.
#pragma once

#include <optional>

#include "experiment/drive.h"
#include "pages/page.h"

class QLabel;
class QPushButton;
class QTableWidget;
class QDoubleSpinBox;

namespace breakaway {

class BenchRuns;
class Connection;
class QuantitySlider;
class StepPlot;

class TunePage : public Page {
  Q_OBJECT

 public:
  TunePage(Connection& connection, BenchRuns& bench, QWidget* parent = nullptr);

 private:
  QWidget* buildControls();
  QWidget* buildTuning();
  QWidget* buildResults();
  QuantitySlider* addSlider(const QString& objectName, const QString& title, const QString& unit, const QString& help,
                            double ControllerSettings::*field);
  void wordForAxis();
  void scaleSliders();
  void showSettings();
  void showMargins();
  void showSteps();
  void showMotion();
  void measure();

  Connection& connection_;
  BenchRuns& bench_;
  struct Slider {
    QuantitySlider* widget;
    double ControllerSettings::*field;
  };
  std::vector<Slider> sliders_;
  std::vector<QPushButton*> stiffness_;
  QLabel* margins_ = nullptr;
  QDoubleSpinBox* height_ = nullptr;
  std::optional<Axis> worded_;  ///< the axis that the page speaks of
  QPushButton* measure_ = nullptr;
  QPushButton* forget_ = nullptr;
  StepPlot* plot_ = nullptr;
  QTableWidget* table_ = nullptr;
};

}  // namespace breakaway
