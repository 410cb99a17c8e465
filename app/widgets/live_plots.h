// What comes from the board, below the page: angle, velocity, current and disturbance over one shared axis of time.
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "session/trigger.h"
#include "widgets/envelope.h"
#include "widgets/file_chooser.h"
#include "widgets/live_channels.h"

class QCPAxisRect;
class QCPGraph;
class QCPItemStraightLine;
class QCPItemText;
class QCPTextElement;
class QCustomPlot;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace breakaway {

class Connection;
class LiveSamples;
class Messages;

class LivePlots : public QWidget {
  Q_OBJECT

 public:
  LivePlots(Connection& connection, LiveSamples& live, Messages& messages, FileChooser& files,
            QWidget* parent = nullptr);

  bool paused() const { return paused_; }
  double from_s() const;
  double to_s() const;

 public slots:
  void setPaused(bool paused);
  void showCursors(bool shown);
  /// Takes the new samples over and draws; called by a timer, and by whoever wants a picture at once.
  void refresh();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  static constexpr int channelCount = 4;
  struct Trace {
    QCPAxisRect* rect = nullptr;
    QCPGraph* graph = nullptr;
    QCPTextElement* title = nullptr;
    QCPTextElement* readout = nullptr;
    std::array<QCPItemStraightLine*, 2> cursors{};
    QCPItemStraightLine* edge = nullptr;  ///< of the trigger
    QCPItemStraightLine* loss = nullptr;  ///< of the link
    Envelope envelope{0.002, 0.01};
  };

  void buildStrip();
  void buildTrigger();
  void buildPlot();
  void addTrace(int channel);
  void linkTimeAxes();
  void applyLook();
  void consume();
  void meetBoard();
  void startOver();
  void follow();
  /// By what the trigger's controls say; a picture that stands at an edge is let go.
  void armTrigger();
  void wordTrigger();
  double viewEnd_s(double span_s);
  void scaleValues(Trace& trace) const;
  void placeCursors();
  void writeReadouts();
  bool cursorMouse(QEvent* event);
  bool cursorKey(int key, bool shift);
  void showConnection();
  void exportVisible();
  void saveRecording();
  void showRecording();

  Connection& connection_;
  LiveSamples& live_;
  Messages& messages_;
  FileChooser& files_;
  QCustomPlot* plot_ = nullptr;
  QToolButton* pause_ = nullptr;
  QToolButton* cursorButton_ = nullptr;
  QToolButton* record_ = nullptr;
  QToolButton* save_ = nullptr;
  QToolButton* export_ = nullptr;
  QComboBox* span_ = nullptr;
  QLabel* difference_ = nullptr;
  QComboBox* triggerMode_ = nullptr;
  QComboBox* triggerChannel_ = nullptr;
  QComboBox* triggerEdge_ = nullptr;
  QDoubleSpinBox* triggerLevel_ = nullptr;
  QLabel* triggerState_ = nullptr;
  QWidget* triggerRow_ = nullptr;
  QCPItemStraightLine* levelLine_ = nullptr;
  std::optional<Trigger> trigger_;
  QCPItemText* lossText_ = nullptr;
  std::array<LiveChannel, channelCount> channels_ = liveChannels(false);
  std::array<Trace, channelCount> traces_;
  std::array<double, 2> cursor_s_{};
  int dragged_ = -1;
  bool paused_ = false;
  bool stale_ = true;  ///< the picture isn't of what is chosen
  uint64_t consumed_ = 0;
};

}  // namespace breakaway
