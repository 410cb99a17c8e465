#include "widgets/live_plots.h"

#include <qcustomplot.h>

#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include "recording/csv.h"
#include "session/connection.h"
#include "session/live_samples.h"
#include "session/messages.h"
#include "widgets/controls.h"
#include "widgets/live_cursors.h"
#include "widgets/live_spectrum.h"
#include "widgets/live_toolbar.h"
#include "widgets/live_trigger.h"
#include "widgets/look.h"
#include "widgets/seconds_ticker.h"
#include "widgets/while_shown.h"

using namespace std::chrono_literals;

namespace breakaway {

namespace {
constexpr double gapAfterHeld_s = 0.01;          // the last points of what is held stand at most a bucket after it
constexpr int plain_px = 208, settings_px = 32;  // with the strip below it, 240; and a row of settings
}  // namespace

LivePlots::LivePlots(Connection& connection, LiveSamples& live, Messages& messages, FileChooser& files, QWidget* parent)
    : QWidget(parent), connection_(connection), live_(live), messages_(messages), files_(files) {
  setObjectName("livePlots");
  auto* layout = columnIn(this, 4, {16, 4, 16, 4});
  trigger_ = new LiveTrigger(this);
  bar_ = new LiveToolbar(connection_, live_, files_, trigger_->modeBox(), this);
  buildPlot();
  spectrum_ = new LiveSpectrum(shown_, this);
  layout->addWidget(bar_);
  auto* settings = new QHBoxLayout;
  settings->setSpacing(24);
  settings->addWidget(trigger_);
  settings->addWidget(spectrum_->controls(), 1);
  layout->addLayout(settings);
  auto* pictures = new QHBoxLayout;
  pictures->setSpacing(8);
  pictures->addWidget(plot_, 5);
  pictures->addWidget(spectrum_, 4);
  layout->addLayout(pictures, 1);
  showSpectrum(false);
  connect(bar_->pauseButton(), &QToolButton::toggled, this, &LivePlots::setPaused);
  connect(bar_->cursorsButton(), &QToolButton::toggled, this, &LivePlots::showCursors);
  connect(bar_->spectrumButton(), &QToolButton::toggled, this, &LivePlots::showSpectrum);
  connect(bar_->largeButton(), &QToolButton::toggled, this, &LivePlots::largeAsked);
  connect(traces_[0].rect->axis(QCPAxis::atBottom), qOverload<const QCPRange&>(&QCPAxis::rangeChanged), spectrum_,
          [this] { spectrum_->show(from_s(), to_s()); });
  connect(bar_, &LiveToolbar::spanChanged, this, &LivePlots::armTrigger);
  connect(bar_, &LiveToolbar::exportAsked, this, &LivePlots::exportVisible);
  connect(trigger_, &LiveTrigger::changed, this, &LivePlots::armTrigger);
  applyLook();
  onNewLook(this, [this] { applyLook(); });
  connect(&connection_, &Connection::came, this, &LivePlots::meetBoard);
  connect(&connection_, &Connection::changed, this, &LivePlots::showLoss);
  new WhileShown(this, 33ms, [this] { return refresh(); });
  startOver();
}

void LivePlots::armTrigger() {
  stale_ = true;
  const bool hidden = trigger_->isHidden();
  if (trigger_->arm(bar_->span_s()) && paused_) setPaused(false);
  if (hidden != trigger_->isHidden()) emit heightChanged();
}

int LivePlots::openHeight_px() const {
  return plain_px + (trigger_->isHidden() && spectrum_->isHidden() ? 0 : settings_px);
}

void LivePlots::buildPlot() {
  plot_ = new QCustomPlot(this);
  plot_->setObjectName("livePlot");
  plot_->setAccessibleName(tr("Live plots of angle, velocity, current and estimated disturbance over time"));
  plot_->setToolTip(tr("P holds the picture still, C shows the cursors, S the spectrum, L enlarges, R records"));
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMinimumSize(200, 120);
  plot_->setNoAntialiasingOnDrag(true);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->setRowSpacing(2);
  plot_->plotLayout()->setColumnSpacing(6);
  cursors_ = new LiveCursors(*plot_, shown_, bar_->difference());
  for (int channel = 0; channel < channelCount; ++channel) addTrace(channel);
  linkTimeAxes();
  // Lines of titles are as high as their text; the lower plots also carry the labels of time.
  plot_->plotLayout()->setRowStretchFactors({1e-3, 1.0, 1e-3, 1.3});
  for (const auto& [key, button] : {std::pair{Qt::Key_P, bar_->pauseButton()},
                                    {Qt::Key_C, bar_->cursorsButton()},
                                    {Qt::Key_S, bar_->spectrumButton()},
                                    {Qt::Key_L, bar_->largeButton()},
                                    {Qt::Key_R, bar_->recordButton()}}) {
    auto* shortcut = new QShortcut(key, plot_);
    shortcut->setContext(Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, button, &QToolButton::click);
  }
}

void LivePlots::addTrace(int channel) {
  Trace& trace = traces_[static_cast<size_t>(channel)];
  trace.rect = new QCPAxisRect(plot_);
  auto* head = new QCPLayoutGrid;
  plot_->plotLayout()->addElement(channel / 2 * 2, channel % 2, head);
  plot_->plotLayout()->addElement(channel / 2 * 2 + 1, channel % 2, trace.rect);
  trace.rect->setMinimumMargins(QMargins(44, 6, 8, 3));
  QCPAxis* time = trace.rect->axis(QCPAxis::atBottom);
  time->setTicker(QSharedPointer<SecondsTicker>::create());
  time->setTickLabels(channel >= 2);
  trace.rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
  time->ticker()->setTickCount(8);
  trace.graph = plot_->addGraph(time, trace.rect->axis(QCPAxis::atLeft));
  trace.graph->setAdaptiveSampling(true);
  const auto words = [&](int column, Qt::Alignment side) {
    auto* text = new QCPTextElement(plot_);
    text->setTextFlags(static_cast<int>(side | Qt::AlignVCenter));
    text->setMargins(QMargins(column == 0 ? 8 : 0, 0, 8, 0));
    head->addElement(0, column, text);
    return text;
  };
  trace.title = words(0, Qt::AlignLeft);
  trace.title->setText(channels_[static_cast<size_t>(channel)].title());
  cursors_->addTo(*trace.rect, *words(1, Qt::AlignRight));
  trigger_->addTo(*trace.rect);
  loss_.addTo(*trace.rect);
  if (channel != 0) return;
  placeOverTime(*(lossText_ = new QCPItemText(plot_)), *trace.rect);
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
  }
  cursors_->dress(look);
  trigger_->dress(look);
  loss_.setPen(QPen(look.trouble, 2));
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
  if (!paused_) shown_ = live_.history();
  paused_ = paused;
  bar_->pauseButton()->setChecked(paused);
  plot_->setInteractions(paused ? QCP::iRangeDrag | QCP::iRangeZoom : QCP::Interactions());
  stale_ = true;
  if (paused) return;
  shown_ = live_.history();
  if (trigger_->done()) armTrigger();
  follow();
}

void LivePlots::showCursors(bool shown) {
  bar_->cursorsButton()->setChecked(shown);
  cursors_->show(shown);
}

void LivePlots::setLarge(bool large) {
  bar_->largeButton()->setChecked(large);
}

void LivePlots::showSpectrum(bool shown) {
  bar_->spectrumButton()->setChecked(shown);
  spectrum_->setVisible(shown);
  spectrum_->controls()->setVisible(shown);
  for (const Trace& trace : traces_) trace.rect->axis(QCPAxis::atBottom)->ticker()->setTickCount(shown ? 4 : 8);
  if (shown) spectrum_->show(from_s(), to_s());
  plot_->replot(QCustomPlot::rpQueuedReplot);
  emit heightChanged();
}

/// A picture in which nothing would move isn't drawn again.
bool LivePlots::refresh() {
  const uint64_t before = consumed_;
  consume();
  const bool came = consumed_ != before;
  if (paused_ || (!came && !stale_)) return came;
  shown_ = live_.history();
  stale_ = false;
  follow();
  if (trigger_->done()) setPaused(true);
  plot_->replot(QCustomPlot::rpQueuedReplot);
  return true;
}

void LivePlots::consume() {
  const LiveHistory& history = live_.history();
  if (consumed_ < history.first()) consumed_ = history.first();
  if (consumed_ == history.end()) return;
  draw(history);
  // What is older than the history goes, but for what is held.
  const double oldest_s = history.at(history.first()).time_s;
  const bool holds = paused_ && shown_.newest().has_value();
  for (Trace& trace : traces_) {
    trace.graph->data()->removeBefore(holds ? std::min(oldest_s, shown_.at(shown_.first()).time_s) : oldest_s);
    if (holds) trace.graph->data()->remove(shown_.newest()->time_s + gapAfterHeld_s, oldest_s);
  }
}

/// What of it isn't drawn yet.
void LivePlots::draw(const LiveHistory& history) {
  std::array<std::vector<TracePoint>, channelCount> points;
  for (; consumed_ < history.end(); ++consumed_) {
    const Sample& sample = history.at(consumed_);
    if (consumed_ >= watchedFrom_) trigger_->take(sample);
    for (size_t channel = 0; channel < traces_.size(); ++channel) {
      traces_[channel].envelope.add(sample.time_s, channels_[channel].of(sample), points[channel]);
    }
  }
  for (size_t channel = 0; channel < traces_.size(); ++channel) {
    QVector<QCPGraphData> fresh;
    fresh.reserve(static_cast<qsizetype>(points[channel].size()));
    for (const TracePoint& point : points[channel]) fresh.append(QCPGraphData(point.time_s, point.value));
    traces_[channel].graph->data()->add(fresh, true);
  }
}

/// The same board after a lost link goes on where its history does, with a gap.
void LivePlots::meetBoard() {
  if (!live_.lost_s()) return startOver();
  showLoss();
}

void LivePlots::startOver() {
  consumed_ = live_.history().first();
  watchedFrom_ = 0;
  channels_ = liveChannels(live_.board().axis == Axis::linear);
  for (size_t channel = 0; channel < traces_.size(); ++channel)
    traces_[channel].title->setText(channels_[channel].title());
  emptyTraces();
  const std::vector<LiveChannel> shown(channels_.begin(), channels_.end());
  trigger_->nameChannels(shown);
  cursors_->nameChannels(shown);
  spectrum_->nameChannels(live_.board().axis == Axis::linear);
  armTrigger();
  setPaused(false);
  showLoss();
}

void LivePlots::emptyTraces() {
  const double period_s = connection_.connected() ? 1.0 / std::max(1.0, connection_.identity().loopRate_Hz) : 0.001;
  for (Trace& trace : traces_) {
    trace.graph->data()->clear();
    trace.envelope = Envelope(0.002, 3.5 * period_s);
  }
}

/// Where the link was lost, over the samples that stay.
void LivePlots::showLoss() {
  const auto lost_s = live_.lost_s();
  loss_.show(lost_s.has_value());
  loss_.moveTo(lost_s.value_or(0.0));
  lossText_->setVisible(lost_s.has_value());
  lossText_->position->setCoords(lost_s.value_or(0.0), 0.5);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

QVariant LivePlots::kept() const {
  return QVariant::fromValue(View{from_s(), to_s(), cursors_->times_s(), trigger_->state(), consumed_, shown_});
}

void LivePlots::take(const QVariant& kept) {
  const View view = kept.value<View>();
  trigger_->goOnFrom(view.trigger);
  watchedFrom_ = view.consumed;
  traces_[0].rect->axis(QCPAxis::atBottom)->setRange(view.from_s, view.to_s);
  cursors_->moveTo(view.cursors_s);
  if (!paused_) return;
  if (view.shown.newest()) {
    shown_ = view.shown;
    emptyTraces();
    consumed_ = shown_.first();
    draw(shown_);
  }
  consume();
  trigger_->viewEnd_s(bar_->span_s(), view.to_s);
  for (Trace& trace : traces_) scaleValues(trace);
}

void LivePlots::follow() {
  const double span_s = bar_->span_s();
  const auto newest = live_.history().newest();
  const double end_s = trigger_->viewEnd_s(span_s, newest ? newest->time_s : 0.0);
  const double shift_s = end_s - to_s();
  traces_[0].rect->axis(QCPAxis::atBottom)->setRange(end_s - span_s, end_s);
  for (Trace& trace : traces_) scaleValues(trace);
  cursors_->shift(shift_s);
}

void LivePlots::scaleValues(Trace& trace) const {
  bool found = false;
  QCPRange values = trace.graph->getValueRange(found, QCP::sdBoth, trace.rect->axis(QCPAxis::atBottom)->range());
  if (!found) return;
  const double least = channels_[static_cast<size_t>(&trace - traces_.data())].leastSpan;
  const double span = std::max(least, values.size()) * 1.15;
  trace.rect->axis(QCPAxis::atLeft)->setRange(values.center() - 0.5 * span, values.center() + 0.5 * span);
}

void LivePlots::exportVisible() {
  const auto recording = live_.stretch(shown_, from_s(), to_s());
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

}  // namespace breakaway
