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
class MapExport;
class MapPanel;
class Messages;
class RunPanel;
class ShownMaps;

class FrictionPage : public Page {
  Q_OBJECT

 public:
  FrictionPage(Connection& connection, BenchRuns& bench, ShownMaps& maps, Messages& messages, FileChooser& files,
               QWidget* parent = nullptr);

 private:
  void buildSettings();
  QWidget* buildSweep();
  SweepSettings sweeps() const;
  void setSweeps(const SweepSettings& sweeps);
  void showConnection();
  void wordFor(Axis axis);
  void showHead();
  void showMotion();
  void showKnown();
  void showState();
  void showAverages(const Commission& known);
  void showMaps();
  Commission shown() const;

  Connection& connection_;
  BenchRuns& bench_;
  ShownMaps& maps_;
  Messages& messages_;
  FileChooser& files_;
  QDoubleSpinBox* highest_ = nullptr;
  QSpinBox* speeds_ = nullptr;
  QDoubleSpinBox* duration_ = nullptr;
  QSpinBox* bins_ = nullptr;
  QSpinBox* turns_ = nullptr;
  QPushButton* velocity_ = nullptr;
  QPushButton* breakaway_ = nullptr;
  QPushButton* continue_ = nullptr;
  QPushButton* anew_ = nullptr;
  QPushButton* trial_ = nullptr;
  RunPanel* run_ = nullptr;
  FactsTable* averages_ = nullptr;
  QLabel* binsName_ = nullptr;
  QLabel* turnsName_ = nullptr;
  MapPanel* map_ = nullptr;
  MapExport* export_ = nullptr;
  std::optional<Axis> worded_;  ///< the axis that the page speaks of
};

}  // namespace breakaway
