#include "widgets/live_trigger.h"

#include <qcustomplot.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>

#include "widgets/controls.h"
#include "widgets/look.h"
#include "widgets/number_text.h"

namespace breakaway {

namespace {

constexpr int levelWidth = 136;         // of "-1234.56 mm/s"
constexpr int stateWidth = 140;         // of "edge at 12345.6789 s", and in German
constexpr double beforePart = 0.25;     // of the view lies before the edge
constexpr double hysteresisPart = 0.5;  // of the least span of a channel
constexpr double patience = 2.0;        // views without an edge, then the picture runs on
enum Mode { off, automatic, single };

}  // namespace

LiveTrigger::LiveTrigger(QWidget* parent) : QWidget(parent) {
  rowIn(this, 4);
  mode_ = new QComboBox(this);
  mode_->setObjectName("triggerMode");
  mode_->setAccessibleName(tr("Trigger"));
  mode_->setToolTip(
      tr("Auto: the picture stands at the newest edge and runs on without one. Single: it waits for "
         "one edge and pauses there; Pause arms it again"));
  mode_->addItems({tr("Free run"), tr("Trigger: auto"), tr("Trigger: single")});
  channel_ = box("triggerChannel", tr("Channel of the trigger"), tr("What the trigger watches"));
  way_ = box("triggerEdge", tr("Edge of the trigger"), tr("Which way the channel crosses the level"));
  way_->addItems({tr("rising"), tr("falling")});
  level_ = new QDoubleSpinBox(this);
  level_->setObjectName("triggerLevel");
  level_->setAccessibleName(tr("Level of the trigger"));
  level_->setToolTip(tr("The level that the channel crosses, drawn over its plot"));
  level_->setRange(-1e6, 1e6);
  level_->setAlignment(Qt::AlignRight);
  level_->setFixedWidth(levelWidth);
  state_ = caption(this, {});
  state_->setObjectName("triggerState");
  state_->setFixedWidth(stateWidth);
  auto* row = static_cast<QHBoxLayout*>(layout());
  row->addWidget(new QLabel(tr("through"), this));
  row->addWidget(level_);
  row->addSpacing(8);
  row->addWidget(state_);
  row->addStretch(1);
  hide();
  for (const QComboBox* one : {mode_, channel_, way_})
    connect(one, &QComboBox::currentIndexChanged, this, &LiveTrigger::changed);
  connect(level_, &QDoubleSpinBox::valueChanged, this, &LiveTrigger::changed);
}

QComboBox* LiveTrigger::box(const char* objectName, const QString& name, const QString& tip) {
  auto* made = new QComboBox(this);
  made->setObjectName(objectName);
  made->setAccessibleName(name);
  made->setToolTip(tip);
  layout()->addWidget(made);
  return made;
}

void LiveTrigger::addTo(QCPAxisRect& rect) {
  if (rects_.empty()) {
    levelLine_ = new QCPItemStraightLine(rect.parentPlot());
    levelLine_->setVisible(false);
  }
  rects_.push_back(&rect);
  edge_.addTo(rect);
}

void LiveTrigger::nameChannels(const std::vector<LiveChannel>& channels) {
  const QSignalBlocker quiet(channel_);
  const int chosen = std::max(0, channel_->currentIndex());
  channels_ = channels;
  channel_->clear();
  for (const LiveChannel& channel : channels_) channel_->addItem(channel.name);
  channel_->setCurrentIndex(chosen);
}

size_t LiveTrigger::watched() const {
  return static_cast<size_t>(std::max(0, channel_->currentIndex()));
}

bool LiveTrigger::arm(double span_s) {
  const int mode = mode_->currentIndex();
  setVisible(mode != off);
  const LiveChannel& channel = channels_[watched()];
  level_->setSuffix(" " + channel.unit);
  trigger_.reset();
  edge_.show(false);
  levelLine_->setVisible(mode != off);
  state_->clear();
  if (mode == off) return false;
  TriggerOptions options;
  options.level = level_->value();
  options.rising = way_->currentIndex() == 0;
  options.hysteresis = hysteresisPart * channel.leastSpan;
  options.after_s = (1.0 - beforePart) * span_s;
  options.once = mode == single;
  trigger_.emplace(options);
  state_->setText(tr("waits for an edge"));
  showLevel(options.level);
  return true;
}

void LiveTrigger::showLevel(double level) {
  QCPAxisRect* rect = rects_[watched()];
  levelLine_->setClipAxisRect(rect);
  for (QCPItemPosition* position : levelLine_->positions()) {
    position->setAxisRect(rect);
    position->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    position->setTypeX(QCPItemPosition::ptAxisRectRatio);
    position->setTypeY(QCPItemPosition::ptPlotCoords);
  }
  levelLine_->point1->setCoords(0.0, level);
  levelLine_->point2->setCoords(1.0, level);
}

void LiveTrigger::take(const Sample& sample) {
  if (trigger_) trigger_->take(sample.time_s, channels_[watched()].of(sample));
}

double LiveTrigger::viewEnd_s(double span_s, double newest_s) {
  const bool found = trigger_ && trigger_->shown_s().has_value();
  const double edge_s = found ? *trigger_->shown_s() : 0.0;
  const bool stands = found && (trigger_->done() || newest_s - edge_s < (1.0 + patience) * span_s);
  edge_.show(stands);
  edge_.moveTo(edge_s);
  if (trigger_) state_->setText(stands ? tr("edge at %1 s").arg(fixedText(edge_s, 4)) : tr("waits for an edge"));
  return stands ? edge_s + (1.0 - beforePart) * span_s : newest_s;
}

void LiveTrigger::dress(const Look& look) {
  edge_.setPen(QPen(look.accentLine, 1, Qt::DashDotLine));
  levelLine_->setPen(QPen(look.accentLine, 1, Qt::DashDotLine));
}

}  // namespace breakaway
