// What can be done with the live plots and what they show: the row above them.
#pragma once

#include <QWidget>

#include "widgets/file_chooser.h"

class QComboBox;
class QToolButton;

namespace breakaway {

class Connection;
class ElidedLabel;
class LiveSamples;

class LiveToolbar : public QWidget {
  Q_OBJECT

 public:
  /// `trigger` stands beside the visible span.
  LiveToolbar(Connection& connection, LiveSamples& live, FileChooser& files, QComboBox* trigger,
              QWidget* parent = nullptr);

  /// The first four are checkable.
  QToolButton* pauseButton() const { return pause_; }
  QToolButton* cursorsButton() const { return cursors_; }
  QToolButton* spectrumButton() const { return spectrum_; }
  QToolButton* largeButton() const { return large_; }
  QToolButton* recordButton() const { return record_; }
  /// The times of the cursors, at the right end.
  ElidedLabel& difference() const { return *difference_; }
  double span_s() const;
  /// What can be done now.
  void showAvailable();

 signals:
  void spanChanged();
  void exportAsked();

 private:
  void saveRecording();

  Connection& connection_;
  LiveSamples& live_;
  FileChooser& files_;
  QToolButton* pause_ = nullptr;
  QToolButton* cursors_ = nullptr;
  QToolButton* spectrum_ = nullptr;
  QToolButton* large_ = nullptr;
  QToolButton* record_ = nullptr;
  QToolButton* save_ = nullptr;
  QToolButton* export_ = nullptr;
  QComboBox* span_ = nullptr;
  ElidedLabel* difference_ = nullptr;
};

}  // namespace breakaway
