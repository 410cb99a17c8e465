#include "widgets/live_plots.h"

#include <qcustomplot.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QShortcut>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "recording/csv.h"
#include "session/connection.h"
#include "session/live_samples.h"
#include "session/messages.h"
#include "widgets/controls.h"
#include "widgets/look.h"
#include "widgets/while_shown.h"

using namespace std::chrono_literals;

namespace breakaway {

namespace {

constexpr int levelWidth = 112;
constexpr int recordWidth = 112;        // of "Finish (600 s)"
constexpr double beforePart = 0.25;     // of the view lies before the trigger's edge
constexpr double hysteresisPart = 0.5;  // of the least span of a channel
constexpr double patience = 2.0;        // views without an edge, then the picture runs on
enum TriggerMode { triggerOff, triggerAuto, triggerSingle };
constexpr std::array<double, 5> spans_s{2.0, 5.0, 10.0, 20.0, 60.0};

}  // namespace

LivePlots::LivePlots(Connection& connection, LiveSamples& live, Messages& messages, FileChooser& files, QWidget* parent)
    : QWidget(parent), connection_(connection), live_(live), messages_(messages), files_(files) {
  setObjectName("livePlots");
  auto* layout = columnIn(this, 4, {16, 4, 16, 4});
  buildStrip();
  buildTrigger();
  buildPlot();
  layout->addWidget(plot_, 1);
  applyLook();
  onNewLook(this, [this] { applyLook(); });
  connect(&connection_, &Connection::came, this, &LivePlots::meetBoard);
  connect(&connection_, &Connection::changed, this, &LivePlots::showConnection);
  connect(&live_, &LiveSamples::recordingChanged, this, &LivePlots::showRecording);
  connect(&connection_, &Connection::linkChanged, this, &LivePlots::showRecording);
  new WhileShown(this, 33ms, [this] { refresh(); });
  startOver();
}

void LivePlots::buildStrip() {
  auto* strip = new QHBoxLayout;
  strip->setSpacing(4);
  pause_ = toolButton(this, "pauseButton", tr("Pause"),
                      tr("Hold the picture still; samples keep coming in (P in the plot)"));
  pause_->setCheckable(true);
  connect(pause_, &QToolButton::toggled, this, &LivePlots::setPaused);
  cursorButton_ = toolButton(this, "cursorsButton", tr("Cursors"),
                             tr("Two cursors A and B over all plots (C in the plot): drag them, or move A with the "
                                "arrow keys and B with Shift"));
  cursorButton_->setCheckable(true);
  connect(cursorButton_, &QToolButton::toggled, this, &LivePlots::showCursors);
  span_ = new QComboBox(this);
  span_->setObjectName("spanBox");
  span_->setAccessibleName(tr("Visible time span"));
  span_->setToolTip(tr("Visible time span; while the picture is paused, the wheel zooms"));
  for (const double span : spans_s) span_->addItem(tr("%1 s").arg(span), span);
  span_->setCurrentIndex(2);
  connect(span_, &QComboBox::currentIndexChanged, this, [this] { armTrigger(); });
  triggerMode_ = new QComboBox(this);
  triggerMode_->setObjectName("triggerMode");
  triggerMode_->setAccessibleName(tr("Trigger"));
  triggerMode_->setToolTip(
      tr("Auto: the picture stands at the newest edge and runs on without one. Single: it waits for "
         "one edge and pauses there; Pause arms it again"));
  triggerMode_->addItems({tr("Free run"), tr("Trigger: auto"), tr("Trigger: single")});
  record_ = toolButton(this, "recordButton", tr("Record"), {});
  record_->setFixedWidth(recordWidth);
  connect(record_, &QToolButton::clicked, &live_,
          [this] { live_.recording() ? live_.finishRecording() : live_.startRecording(); });
  export_ = toolButton(this, "exportVisibleButton", tr("Export visible…"),
                       tr("Write the visible stretch as CSV, every sample of it"));
  connect(export_, &QToolButton::clicked, this, &LivePlots::exportVisible);
  save_ = toolButton(this, "saveRecordingButton", tr("Save recording…"), tr("Write the last recording as CSV"));
  connect(save_, &QToolButton::clicked, this, &LivePlots::saveRecording);
  difference_ = new QLabel(this);
  difference_->setObjectName("cursorDifference");
  difference_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{pause_, cursorButton_, span_, triggerMode_, record_, save_, export_})
    strip->addWidget(widget);
  strip->addStretch(1);
  strip->addWidget(difference_);
  static_cast<QVBoxLayout*>(layout())->addLayout(strip);
}

void LivePlots::buildTrigger() {
  triggerRow_ = new QWidget(this);
  auto* row = rowIn(triggerRow_, 4);
  const auto box = [&](const char* objectName, const QString& name, const QString& tip) {
    auto* made = new QComboBox(triggerRow_);
    made->setObjectName(objectName);
    made->setAccessibleName(name);
    made->setToolTip(tip);
    row->addWidget(made);
    return made;
  };
  triggerChannel_ = box("triggerChannel", tr("Channel of the trigger"), tr("What the trigger watches"));
  triggerEdge_ = box("triggerEdge", tr("Edge of the trigger"), tr("Which way the channel crosses the level"));
  triggerEdge_->addItems({tr("rising"), tr("falling")});
  auto* name = new QLabel(tr("through"), triggerRow_);
  triggerLevel_ = new QDoubleSpinBox(triggerRow_);
  triggerLevel_->setObjectName("triggerLevel");
  triggerLevel_->setAccessibleName(tr("Level of the trigger"));
  triggerLevel_->setToolTip(tr("The level that the channel crosses, drawn over its plot"));
  triggerLevel_->setRange(-1e6, 1e6);
  triggerLevel_->setAlignment(Qt::AlignRight);
  triggerLevel_->setFixedWidth(levelWidth);
  triggerState_ = caption(triggerRow_, {});
  triggerState_->setObjectName("triggerState");
  row->addWidget(name);
  row->addWidget(triggerLevel_);
  row->addSpacing(8);
  row->addWidget(triggerState_);
  row->addStretch(1);
  static_cast<QVBoxLayout*>(layout())->addWidget(triggerRow_);
  triggerRow_->hide();
  connect(triggerMode_, &QComboBox::currentIndexChanged, this, &LivePlots::armTrigger);
  connect(triggerChannel_, &QComboBox::currentIndexChanged, this, &LivePlots::armTrigger);
  connect(triggerEdge_, &QComboBox::currentIndexChanged, this, &LivePlots::armTrigger);
  connect(triggerLevel_, &QDoubleSpinBox::valueChanged, this, &LivePlots::armTrigger);
}

void LivePlots::wordTrigger() {
  const QSignalBlocker quiet(triggerChannel_);
  const int chosen = std::max(0, triggerChannel_->currentIndex());
  triggerChannel_->clear();
  for (const LiveChannel& channel : channels_) triggerChannel_->addItem(channel.name);
  triggerChannel_->setCurrentIndex(chosen);
}

void LivePlots::armTrigger() {
  stale_ = true;
  const int mode = triggerMode_->currentIndex();
  triggerRow_->setVisible(mode != triggerOff);
  const auto at = static_cast<size_t>(std::max(0, triggerChannel_->currentIndex()));
  triggerLevel_->setSuffix(" " + channels_[at].unit);
  trigger_.reset();
  for (const Trace& trace : traces_) trace.edge->setVisible(false);
  levelLine_->setVisible(mode != triggerOff);
  if (mode == triggerOff) return triggerState_->clear();
  TriggerOptions options;
  options.level = triggerLevel_->value();
  options.rising = triggerEdge_->currentIndex() == 0;
  options.hysteresis = hysteresisPart * channels_[at].leastSpan;
  options.after_s = (1.0 - beforePart) * span_->currentData().toDouble();
  options.once = mode == triggerSingle;
  trigger_.emplace(options);
  triggerState_->setText(tr("waits for an edge"));
  QCPAxisRect* rect = traces_[at].rect;
  levelLine_->setClipAxisRect(rect);
  for (QCPItemPosition* position : levelLine_->positions()) {
    position->setAxisRect(rect);
    position->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    position->setTypeX(QCPItemPosition::ptAxisRectRatio);
    position->setTypeY(QCPItemPosition::ptPlotCoords);
  }
  levelLine_->point1->setCoords(0.0, options.level);
  levelLine_->point2->setCoords(1.0, options.level);
  if (paused_) setPaused(false);
}

/// The newest sample, or so much after the trigger's edge that this stands at its place in the view.
double LivePlots::viewEnd_s(double span_s) {
  const auto newest = live_.history().newest();
  const double newest_s = newest ? newest->time_s : 0.0;
  const bool found = trigger_ && trigger_->shown_s().has_value();
  const double edge_s = found ? *trigger_->shown_s() : 0.0;
  const bool stands = found && (trigger_->done() || newest_s - edge_s < (1.0 + patience) * span_s);
  for (const Trace& trace : traces_) {
    trace.edge->setVisible(stands);
    trace.edge->point1->setCoords(edge_s, 0.0);
    trace.edge->point2->setCoords(edge_s, 1.0);
  }
  if (trigger_) triggerState_->setText(stands ? tr("edge at %1 s").arg(edge_s, 0, 'f', 4) : tr("waits for an edge"));
  return stands ? edge_s + (1.0 - beforePart) * span_s : newest_s;
}

void LivePlots::buildPlot() {
  plot_ = new QCustomPlot(this);
  plot_->setObjectName("livePlot");
  plot_->setAccessibleName(tr("Live plots of angle, velocity, current and estimated disturbance over time"));
  plot_->setToolTip(tr("P holds the picture still, C shows the cursors, R records"));
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMinimumSize(200, 120);
  plot_->setNoAntialiasingOnDrag(true);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->setRowSpacing(2);
  plot_->plotLayout()->setColumnSpacing(6);
  for (int channel = 0; channel < channelCount; ++channel) addTrace(channel);
  linkTimeAxes();
  plot_->plotLayout()->setRowStretchFactors({1.0, 1.45});  // the lower row also carries the labels of time
  plot_->installEventFilter(this);
  for (const auto& [key, button] : {std::pair{Qt::Key_P, pause_}, {Qt::Key_C, cursorButton_}, {Qt::Key_R, record_}}) {
    auto* shortcut = new QShortcut(key, plot_);
    shortcut->setContext(Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, button, &QToolButton::click);
  }
}

void LivePlots::addTrace(int channel) {
  Trace& trace = traces_[static_cast<size_t>(channel)];
  trace.rect = new QCPAxisRect(plot_);
  plot_->plotLayout()->addElement(channel / 2, channel % 2, trace.rect);
  trace.rect->setMinimumMargins(QMargins(44, 3, 8, 3));
  QCPAxis* time = trace.rect->axis(QCPAxis::atBottom);
  if (channel < 2) {
    time->setTickLabels(false);
  } else {
    time->setLabel(tr("time (s)"));
  }
  trace.rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
  time->ticker()->setTickCount(8);
  trace.graph = plot_->addGraph(time, trace.rect->axis(QCPAxis::atLeft));
  trace.graph->setAdaptiveSampling(true);
  const auto inset = [&](Qt::Alignment where) {
    auto* text = new QCPTextElement(plot_);
    trace.rect->insetLayout()->addElement(text, where);
    text->setMargins(QMargins(2, 0, 2, 0));
    return text;
  };
  trace.title = inset(Qt::AlignTop | Qt::AlignLeft);
  trace.title->setText(channels_[static_cast<size_t>(channel)].title());
  trace.readout = inset(Qt::AlignTop | Qt::AlignRight);
  const auto overTime = [&](QCPAbstractItem* item) {
    for (QCPItemPosition* position : item->positions()) {
      position->setAxes(time, trace.rect->axis(QCPAxis::atLeft));
      position->setAxisRect(trace.rect);
      position->setTypeX(QCPItemPosition::ptPlotCoords);
      position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    item->setClipAxisRect(trace.rect);
    item->setVisible(false);
  };
  for (QCPItemStraightLine*& cursor : trace.cursors) overTime(cursor = new QCPItemStraightLine(plot_));
  overTime(trace.edge = new QCPItemStraightLine(plot_));
  overTime(trace.loss = new QCPItemStraightLine(plot_));
  if (channel != 0) return;
  levelLine_ = new QCPItemStraightLine(plot_);
  levelLine_->setVisible(false);
  overTime(lossText_ = new QCPItemText(plot_));
  lossText_->setObjectName("linkLost");
  lossText_->setText(tr("link lost"));
  lossText_->setPositionAlignment(Qt::AlignRight | Qt::AlignVCenter);
  lossText_->setPadding(QMargins(4, 1, 4, 1));
}

void LivePlots::linkTimeAxes() {
  auto* left = new QCPMarginGroup(plot_);
  auto* right = new QCPMarginGroup(plot_);
  for (size_t channel = 0; channel < traces_.size(); ++channel) {
    traces_[channel].rect->setMarginGroup(QCP::msLeft, channel % 2 == 0 ? left : right);
    QCPAxis* time = traces_[channel].rect->axis(QCPAxis::atBottom);
    traces_[channel].rect->setRangeDragAxes(time, nullptr);
    traces_[channel].rect->setRangeZoomAxes(time, nullptr);
    for (const Trace& other : traces_) {
      QCPAxis* otherTime = other.rect->axis(QCPAxis::atBottom);
      if (otherTime == time) continue;
      connect(time, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), otherTime,
              [otherTime](const QCPRange& range) { otherTime->setRange(range); });
    }
  }
}

void LivePlots::applyLook() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  for (size_t channel = 0; channel < traces_.size(); ++channel) {
    const Trace& trace = traces_[channel];
    const QColor ink = look.curve(static_cast<int>(channel));
    trace.graph->setPen(QPen(ink, 1));
    trace.title->setTextColor(ink);
    trace.title->setFont(typed(Type::caption, true));
    trace.readout->setTextColor(look.ink);
    trace.readout->setFont(typed(Type::caption));
    trace.cursors[0]->setPen(QPen(look.ink, 1));
    trace.cursors[1]->setPen(QPen(look.ink, 1, Qt::DashLine));
    trace.edge->setPen(QPen(look.accentLine, 1, Qt::DashDotLine));
    trace.loss->setPen(QPen(look.trouble, 2));
  }
  levelLine_->setPen(QPen(look.accentLine, 1, Qt::DashDotLine));
  lossText_->setColor(look.trouble);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

double LivePlots::from_s() const {
  return traces_[0].rect->axis(QCPAxis::atBottom)->range().lower;
}
double LivePlots::to_s() const {
  return traces_[0].rect->axis(QCPAxis::atBottom)->range().upper;
}

void LivePlots::setPaused(bool paused) {
  paused_ = paused;
  pause_->setChecked(paused);
  plot_->setInteractions(paused ? QCP::iRangeDrag | QCP::iRangeZoom : QCP::Interactions());
  stale_ = true;
  if (paused) return;
  if (trigger_ && trigger_->done()) armTrigger();
  follow();
}

void LivePlots::showCursors(bool shown) {
  cursorButton_->setChecked(shown);
  const double span = to_s() - from_s();
  cursor_s_ = {from_s() + 0.4 * span, from_s() + 0.6 * span};
  for (const Trace& trace : traces_) {
    for (QCPItemStraightLine* cursor : trace.cursors) cursor->setVisible(shown);
    trace.readout->setVisible(shown);
  }
  if (shown) plot_->setFocus();
  placeCursors();
  writeReadouts();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

/// A picture in which nothing would move isn't drawn again.
void LivePlots::refresh() {
  const uint64_t before = consumed_;
  consume();
  if (paused_ || (consumed_ == before && !stale_)) return;
  stale_ = false;
  follow();
  if (trigger_ && trigger_->done()) setPaused(true);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void LivePlots::consume() {
  const LiveHistory& history = live_.history();
  if (consumed_ < history.first()) consumed_ = history.first();
  if (consumed_ == history.end()) return;
  std::array<std::vector<TracePoint>, channelCount> points;
  const auto watched = static_cast<size_t>(std::max(0, triggerChannel_->currentIndex()));
  for (; consumed_ < history.end(); ++consumed_) {
    const Sample& sample = history.at(consumed_);
    if (trigger_) trigger_->take(sample.time_s, channels_[watched].of(sample));
    for (size_t channel = 0; channel < traces_.size(); ++channel) {
      traces_[channel].envelope.add(sample.time_s, channels_[channel].of(sample), points[channel]);
    }
  }
  const double oldest_s = history.at(history.first()).time_s;
  for (size_t channel = 0; channel < traces_.size(); ++channel) {
    QVector<QCPGraphData> fresh;
    fresh.reserve(static_cast<qsizetype>(points[channel].size()));
    for (const TracePoint& point : points[channel]) fresh.append(QCPGraphData(point.time_s, point.value));
    traces_[channel].graph->data()->add(fresh, true);
    traces_[channel].graph->data()->removeBefore(oldest_s);
  }
}

/// The same board after a lost link goes on where its history does, with a gap.
void LivePlots::meetBoard() {
  if (!live_.lost_s()) return startOver();
  showConnection();
}

void LivePlots::startOver() {
  consumed_ = live_.history().first();
  channels_ = liveChannels(live_.board().axis == Axis::linear);
  const double period_s = connection_.connected() ? 1.0 / std::max(1.0, connection_.identity().loopRate_Hz) : 0.001;
  for (size_t channel = 0; channel < traces_.size(); ++channel) {
    Trace& trace = traces_[channel];
    trace.title->setText(channels_[channel].title());
    trace.graph->data()->clear();
    trace.envelope = Envelope(0.002, 3.5 * period_s);
  }
  wordTrigger();
  armTrigger();
  setPaused(false);
  showConnection();
}

/// What can be done now; and where the link was lost, over the samples that stay.
void LivePlots::showConnection() {
  setAvailable(record_, connection_.connected(),
               tr("Record every sample at the full rate, on the disk (R in the plot)"), tr("No board is connected"));
  setAvailable(export_, connection_.connected() || live_.history().newest(),
               tr("Write the visible stretch as CSV, every sample of it"), tr("No sample has come yet"));
  setAvailable(save_, !live_.lastRecording().isEmpty(), tr("Write the last recording as CSV"),
               tr("Nothing was recorded yet"));
  const auto lost_s = live_.lost_s();
  for (const Trace& trace : traces_) {
    trace.loss->setVisible(lost_s.has_value());
    trace.loss->point1->setCoords(lost_s.value_or(0.0), 0.0);
    trace.loss->point2->setCoords(lost_s.value_or(0.0), 1.0);
  }
  lossText_->setVisible(lost_s.has_value());
  lossText_->position->setCoords(lost_s.value_or(0.0), 0.5);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void LivePlots::follow() {
  const double span_s = span_->currentData().toDouble();
  const double end_s = viewEnd_s(span_s);
  const double shift_s = end_s - to_s();
  traces_[0].rect->axis(QCPAxis::atBottom)->setRange(end_s - span_s, end_s);
  for (double& cursor : cursor_s_) cursor += shift_s;
  for (Trace& trace : traces_) scaleValues(trace);
  placeCursors();
  writeReadouts();
}

void LivePlots::scaleValues(Trace& trace) const {
  bool found = false;
  QCPRange values = trace.graph->getValueRange(found, QCP::sdBoth, trace.rect->axis(QCPAxis::atBottom)->range());
  if (!found) return;
  const double least = channels_[static_cast<size_t>(&trace - traces_.data())].leastSpan;
  const double span = std::max(least, values.size()) * 1.15;
  trace.rect->axis(QCPAxis::atLeft)->setRange(values.center() - 0.5 * span, values.center() + 0.62 * span);
}

void LivePlots::placeCursors() {
  for (const Trace& trace : traces_) {
    for (size_t which = 0; which < trace.cursors.size(); ++which) {
      trace.cursors[which]->point1->setCoords(cursor_s_[which], 0.0);
      trace.cursors[which]->point2->setCoords(cursor_s_[which], 1.0);
    }
  }
}

void LivePlots::writeReadouts() {
  const bool shown = cursorButton_->isChecked();
  const auto a = live_.history().nearest(cursor_s_[0]);
  const auto b = live_.history().nearest(cursor_s_[1]);
  difference_->setVisible(shown && a && b);
  if (!shown || !a || !b) return;
  const double delta_s = b->time_s - a->time_s;
  difference_->setText(
      tr("A %1 s   B %2 s   Δt %3 s").arg(a->time_s, 0, 'f', 4).arg(b->time_s, 0, 'f', 4).arg(delta_s, 0, 'f', 4));
  for (size_t channel = 0; channel < traces_.size(); ++channel) {
    const LiveChannel& shownAs = channels_[channel];
    const double atA = shownAs.of(*a);
    const double atB = shownAs.of(*b);
    const auto text = [&](double value) { return QString::number(value, 'f', shownAs.decimals); };
    traces_[channel].readout->setText(tr("A %1   B %2   Δy %3").arg(text(atA), text(atB), text(atB - atA)));
  }
}

bool LivePlots::cursorMouse(QEvent* event) {
  if (!cursorButton_->isChecked()) return false;
  const auto* mouse = static_cast<QMouseEvent*>(event);
  const QPointF at = mouse->position();
  QCPAxisRect* rect = plot_->axisRectAt(at);
  if (event->type() == QEvent::MouseButtonRelease) {
    const bool was = dragged_ >= 0;
    dragged_ = -1;
    return was;
  }
  if (rect == nullptr) return false;
  QCPAxis* time = rect->axis(QCPAxis::atBottom);
  if (event->type() == QEvent::MouseButtonPress) {
    for (size_t which = 0; which < cursor_s_.size(); ++which) {
      if (std::abs(time->coordToPixel(cursor_s_[which]) - at.x()) < 6.0) dragged_ = static_cast<int>(which);
    }
    return dragged_ >= 0;
  }
  if (dragged_ < 0) return false;
  cursor_s_[static_cast<size_t>(dragged_)] = time->pixelToCoord(at.x());
  placeCursors();
  writeReadouts();
  plot_->replot(QCustomPlot::rpQueuedReplot);
  return true;
}

bool LivePlots::cursorKey(int key, bool shift) {
  if (!cursorButton_->isChecked() || (key != Qt::Key_Left && key != Qt::Key_Right)) return false;
  cursor_s_[shift ? 1 : 0] += (key == Qt::Key_Left ? -0.005 : 0.005) * (to_s() - from_s());
  placeCursors();
  writeReadouts();
  plot_->replot(QCustomPlot::rpQueuedReplot);
  return true;
}

bool LivePlots::eventFilter(QObject* watched, QEvent* event) {
  if (watched != plot_) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
      return cursorMouse(event);
    case QEvent::KeyPress: {
      const auto* key = static_cast<QKeyEvent*>(event);
      return cursorKey(key->key(), key->modifiers().testFlag(Qt::ShiftModifier));
    }
    default:
      return false;
  }
}

void LivePlots::exportVisible() {
  const auto recording = live_.stretch(from_s(), to_s());
  if (!recording) {
    messages_.warn(tr("Nothing to export: no sample is visible"));
    return;
  }
  files_.ask(this, {tr("Export the visible stretch"), tr("Recording (*.csv)"), "visible.csv", true},
             [this, recording](const QString& path) {
               const auto written = writeCsv(*recording, path.toStdString());
               messages_.say(written, tr("%1 samples written to %2").arg(recording->rows()).arg(path));
             });
}

void LivePlots::saveRecording() {
  files_.ask(this, {tr("Save the last recording"), tr("Recording (*.csv)"), "recording.csv", true},
             [this](const QString& path) { live_.saveLast(path); });
}

void LivePlots::showRecording() {
  setAvailable(save_, !live_.lastRecording().isEmpty(), tr("Write the last recording as CSV"),
               tr("Nothing was recorded yet"));
  record_->setText(live_.recording() ? tr("Finish (%1 s)").arg(connection_.link().recorded_s, 0, 'f', 0)
                                     : tr("Record"));
}

}  // namespace breakaway
