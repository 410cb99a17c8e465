// Friction: sweeps around the rotor, the polar map growing, the averages, and the files they end in.
#pragma once

#include "pages/page.h"
#include "widgets/file_chooser.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace breakaway {

class FactsTable;
class PolarPlot;
class RunPanel;
class Session;

class FrictionPage : public Page {
  Q_OBJECT

 public:
  FrictionPage(Session& session, FileChooser& files, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* buildControls();
  QWidget* buildVelocityGroup();
  QWidget* buildBreakawayGroup();
  QWidget* buildExport();
  QWidget* buildMap();
  void showConnection();
  void showMotion();
  void showSurvey();
  void showAverages();
  void showMap();
  void showLegend();
  void showExport();
  void exportChosen();
  bool writeExport(const QString& format, const QString& path);

  Session& session_;
  FileChooser& files_;
  QDoubleSpinBox* highest_ = nullptr;
  QSpinBox* speeds_ = nullptr;
  QDoubleSpinBox* duration_ = nullptr;
  QSpinBox* bins_ = nullptr;
  QSpinBox* turns_ = nullptr;
  QPushButton* velocity_ = nullptr;
  QPushButton* breakaway_ = nullptr;
  RunPanel* run_ = nullptr;
  FactsTable* averages_ = nullptr;
  QComboBox* format_ = nullptr;
  QPushButton* export_ = nullptr;
  QComboBox* view_ = nullptr;
  QCheckBox* fromZero_ = nullptr;
  PolarPlot* plot_ = nullptr;
  QLabel* legend_ = nullptr;
  QLabel* reading_ = nullptr;
  QLabel* quantity_ = nullptr;
};

}  // namespace breakaway
