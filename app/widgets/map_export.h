// The row that writes what was measured to a file: the map, its picture, all breakaways.
#pragma once

#include <QWidget>

#include "widgets/file_chooser.h"

class QComboBox;
class QPushButton;

namespace breakaway {

class MapPanel;
class Session;

class MapExport : public QWidget {
  Q_OBJECT

 public:
  /// `picture`: what is saved as a picture.
  MapExport(Session& session, FileChooser& files, MapPanel& picture, QWidget* parent = nullptr);

 private:
  void showExport();
  void exportChosen();
  bool writeExport(const QString& format, const QString& path);

  Session& session_;
  FileChooser& files_;
  MapPanel& picture_;
  QComboBox* format_ = nullptr;
  QPushButton* export_ = nullptr;
};

}  // namespace breakaway
