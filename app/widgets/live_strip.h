// The strip below everything: four live numbers with what they did in the last seconds, the way to the plots, and the
// way to the log.
#pragma once

#include <QWidget>
#include <array>

#include "widgets/live_channels.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace breakaway {

class Connection;
class LiveSamples;
class Messages;

class LiveStrip : public QWidget {
  Q_OBJECT

 public:
  static constexpr int height_px = 32;

  LiveStrip(const Connection& connection, const LiveSamples& live, const Messages& messages, QWidget* parent = nullptr);
  void showOpen(bool open);
  bool refresh();

 signals:
  void plotsAsked(bool open);
  void logAsked();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  class Sparkline;
  struct Number {
    QLabel* name = nullptr;
    QLabel* value = nullptr;
    QLabel* unit = nullptr;
    Sparkline* line = nullptr;
  };

  void nameChannels();
  void countUnread();

  const Connection& connection_;
  const LiveSamples& live_;
  const Messages& messages_;
  std::array<LiveChannel, 4> channels_;
  std::array<Number, 4> numbers_;
  QToolButton* open_ = nullptr;
  QPushButton* log_ = nullptr;
};

}  // namespace breakaway
