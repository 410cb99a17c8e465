// Two cursors A and B over all live plots: by mouse and arrow keys, with what each channel was there and the
// differences.
#pragma once

#include <QObject>
#include <array>
#include <vector>

#include "widgets/live_channels.h"
#include "widgets/time_mark.h"

class QCPAxisRect;
class QCPTextElement;
class QCustomPlot;

namespace breakaway {

class ElidedLabel;
class LiveHistory;
struct Look;

class LiveCursors : public QObject {
  Q_OBJECT

 public:
  /// Times and their difference go to `difference`.
  LiveCursors(QCustomPlot& plot, const LiveHistory& history, ElidedLabel& difference);

  /// One plot over time, with the text that holds its values.
  void addTo(QCPAxisRect& rect, QCPTextElement& readout);
  /// What the plots show, in the order in which they were added.
  void nameChannels(const std::vector<LiveChannel>& channels) { channels_ = channels; }
  void show(bool shown);
  bool shown() const { return shown_; }
  std::array<double, 2> times_s() const { return {marks_[0].time_s(), marks_[1].time_s()}; }
  void moveTo(const std::array<double, 2>& times_s);
  /// They stay at their places in the picture while it moves on.
  void shift(double by_s);
  void dress(const Look& look);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void write();
  void changed();
  bool mouse(QEvent* event);
  bool key(int key, bool shift);

  QCustomPlot& plot_;
  const LiveHistory& history_;
  ElidedLabel& difference_;
  std::vector<QCPTextElement*> readouts_;
  std::vector<LiveChannel> channels_;
  std::array<TimeMark, 2> marks_;
  int dragged_ = -1;
  bool shown_ = false;
};

}  // namespace breakaway
