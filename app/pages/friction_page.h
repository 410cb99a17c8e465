// Friction: sweeps around the rotor, the polar map growing, the averages, and the files they end in.
#pragma once

#include <optional>

#include "base/axis.h"
#include "commission/known.h"
#include "pages/page.h"
#include "widgets/file_chooser.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace breakaway {

class BenchRuns;
class Connection;
class FactsTable;
class MapPanel;
class Messages;
class RunPanel;

class FrictionPage : public Page {
  Q_OBJECT

 public:
  FrictionPage(Connection& connection, BenchRuns& bench, Messages& messages, FileChooser& files,
               QWidget* parent = nullptr);

 private:
  QWidget* buildControls();
  QWidget* buildVelocityGroup();
  QWidget* buildBreakawayGroup();
  SweepSettings sweeps() const;
  void showConnection();
  void wordForRotor();
  void wordForTravel();
  void showMotion();
  void showKnown();
  void showAverages();

  Connection& connection_;
  BenchRuns& bench_;
  Messages& messages_;
  FileChooser& files_;
  QDoubleSpinBox* highest_ = nullptr;
  QSpinBox* speeds_ = nullptr;
  QDoubleSpinBox* duration_ = nullptr;
  QSpinBox* bins_ = nullptr;
  QSpinBox* turns_ = nullptr;
  QPushButton* velocity_ = nullptr;
  QPushButton* breakaway_ = nullptr;
  QPushButton* trial_ = nullptr;
  RunPanel* run_ = nullptr;
  FactsTable* averages_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* speedsCaption_ = nullptr;
  MapPanel* map_ = nullptr;
  std::optional<Axis> worded_;  ///< the axis that the page speaks of
};

}  // namespace breakaway
