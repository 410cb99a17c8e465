// What comes from the board, below the page: angle, velocity, current and disturbance over one shared axis of time.
#pragma once

#include <QVariant>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "session/live_history.h"
#include "session/trigger.h"
#include "widgets/envelope.h"
#include "widgets/file_chooser.h"
#include "widgets/live_channels.h"
#include "widgets/time_mark.h"

class QCPAxisRect;
class QCPGraph;
class QCPItemText;
class QCPTextElement;
class QCustomPlot;

namespace breakaway {

class Connection;
class LiveCursors;
class LiveSamples;
class LiveSpectrum;
class LiveToolbar;
class LiveTrigger;
class Messages;

class LivePlots : public QWidget {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  LivePlots(Connection& connection, LiveSamples& live, Messages& messages, FileChooser& files,
            QWidget* parent = nullptr);

  bool paused() const { return paused_; }
  /// What it takes below a page: more where settings of trigger or spectrum stand above the plots.
  int openHeight_px() const;
  double from_s() const;
  double to_s() const;

  /// Where the picture stands, its cursors, and how far the trigger has come.
  QVariant kept() const;
  void take(const QVariant& kept);

 signals:
  /// Whether it takes the page's place.
  void largeAsked(bool large);
  /// It asks for another height.
  void heightChanged();

 public slots:
  void setPaused(bool paused);
  void showCursors(bool shown);
  void showSpectrum(bool shown);
  /// Says so alone: the window makes the room.
  void setLarge(bool large);
  /// Takes the new samples over and draws; called by a timer, and by whoever wants a picture at once.
  bool refresh();

 private:
  static constexpr int channelCount = 4;
  struct Trace {
    QCPAxisRect* rect = nullptr;
    QCPGraph* graph = nullptr;
    QCPTextElement* title = nullptr;
    Envelope envelope{0.002, 0.01};
  };

  struct View {
    double from_s = 0.0, to_s = 0.0;
    std::array<double, 2> cursors_s{};
    std::optional<Trigger> trigger;
    uint64_t consumed = 0;
    LiveHistory shown;
  };

  void buildPlot();
  void addTrace(int channel);
  void linkTimeAxes();
  void applyLook();
  void consume();
  void draw(const LiveHistory& history);
  void emptyTraces();
  void meetBoard();
  void startOver();
  void follow();
  /// A picture that stands at an edge is let go.
  void armTrigger();
  void scaleValues(Trace& trace) const;
  void showLoss();
  void exportVisible();

  Connection& connection_;
  LiveSamples& live_;
  Messages& messages_;
  FileChooser& files_;
  QCustomPlot* plot_ = nullptr;
  LiveToolbar* bar_ = nullptr;
  LiveTrigger* trigger_ = nullptr;
  LiveCursors* cursors_ = nullptr;
  LiveSpectrum* spectrum_ = nullptr;
  TimeMark loss_;  ///< of the link
  QCPItemText* lossText_ = nullptr;
  std::array<LiveChannel, channelCount> channels_ = liveChannels(false);
  std::array<Trace, channelCount> traces_;
  LiveHistory shown_;  ///< of what is seen: as it goes on, or as it was when the picture was paused
  bool paused_ = false;
  bool stale_ = true;  ///< the picture isn't of what is chosen
  uint64_t consumed_ = 0;
  uint64_t watchedFrom_ = 0;  ///< the trigger has seen the samples before
};

}  // namespace breakaway
