// The trigger of the live plots: its controls, its edge and its level in the picture, and where that then stands.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "session/trigger.h"
#include "widgets/live_channels.h"
#include "widgets/time_mark.h"

class QCPAxisRect;
class QCPItemStraightLine;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace breakaway {

struct Look;

class LiveTrigger : public QWidget {
  Q_OBJECT

 public:
  explicit LiveTrigger(QWidget* parent = nullptr);

  /// Off, auto, single: for a row of its own choice of place. What else there is to set stands in this widget, which is
  /// hidden while it is off.
  QComboBox* modeBox() const { return mode_; }
  void addTo(QCPAxisRect& rect);
  /// What the plots show, in the order in which they were added.
  void nameChannels(const std::vector<LiveChannel>& channels);
  /// By what the controls say; `span_s` of time are seen at once. False where it is off.
  bool arm(double span_s);
  void take(const Sample& sample);
  /// What it has seen so far; nothing while it is off.
  const std::optional<Trigger>& state() const { return trigger_; }
  void goOnFrom(const std::optional<Trigger>& state) { trigger_ = state; }
  /// The one edge that was asked for is shown.
  bool done() const { return trigger_ && trigger_->done(); }
  /// The newest sample, or so much after the edge that this stands at its place in the view.
  double viewEnd_s(double span_s, double newest_s);
  void dress(const Look& look);

 signals:
  /// What is asked for has changed: it must be armed again.
  void changed();

 private:
  QComboBox* box(const char* objectName, const QString& name, const QString& tip);
  size_t watched() const;
  void showLevel(double level);

  std::optional<Trigger> trigger_;
  std::vector<LiveChannel> channels_;
  std::vector<QCPAxisRect*> rects_;
  TimeMark edge_;
  QCPItemStraightLine* levelLine_ = nullptr;
  QComboBox* mode_ = nullptr;
  QComboBox* channel_ = nullptr;
  QComboBox* way_ = nullptr;
  QDoubleSpinBox* level_ = nullptr;
  QLabel* state_ = nullptr;
};

}  // namespace breakaway
