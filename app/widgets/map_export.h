// The row that writes what was measured to a file: the map, its picture, all breakaways.
#pragma once

#include <QWidget>

#include "commission/known.h"
#include "widgets/file_chooser.h"

class QComboBox;
class QPushButton;

namespace breakaway {

class MapPanel;
class Messages;

class MapExport : public QWidget {
  Q_OBJECT

 public:
  /// `picture`: what is saved as a picture.
  MapExport(Messages& messages, FileChooser& files, MapPanel& picture, QWidget* parent = nullptr);
  /// What is written.
  void show(const Commission& known);
  using QWidget::show;

 private:
  void showExport();
  void exportChosen();
  void writeExport(const QString& format, const QString& path);

  Commission known_;
  Messages& messages_;
  FileChooser& files_;
  MapPanel& picture_;
  QComboBox* format_ = nullptr;
  QPushButton* export_ = nullptr;
};

}  // namespace breakaway
