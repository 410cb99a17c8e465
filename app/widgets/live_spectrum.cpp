#include "widgets/live_spectrum.h"

#include <qcustomplot.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QScopedValueRollback>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/look.h"
#include "widgets/number_text.h"

using namespace std::chrono_literals;

namespace breakaway {

namespace {

constexpr auto anew = 150ms;
constexpr double decades = 5.0;  // of amplitude at most, below the highest line
constexpr double leastOrders = 0.05;

QString words(SpectrumWindow window) {
  switch (window) {
    case SpectrumWindow::hann:
      return LiveSpectrum::tr("Hann");
    case SpectrumWindow::blackmanHarris:
      return LiveSpectrum::tr("Blackman-Harris");
    case SpectrumWindow::flatTop:
      return LiveSpectrum::tr("Flat top");
    case SpectrumWindow::rectangular:
      break;
  }
  return LiveSpectrum::tr("Rectangle");
}

}  // namespace

LiveSpectrum::LiveSpectrum(const LiveHistory& history, QWidget* parent) : QWidget(parent), history_(history) {
  setObjectName("liveSpectrum");
  pool_.setMaxThreadCount(1);
  next_.setSingleShot(true);
  next_.setInterval(anew);
  connect(&next_, &QTimer::timeout, this, &LiveSpectrum::compute);
  buildControls();
  buildPlot();
  columnIn(this)->addWidget(plot_);
  applyLook();
  onNewLook(this, [this] { applyLook(); });
}

LiveSpectrum::~LiveSpectrum() {
  pool_.waitForDone();
}

void LiveSpectrum::buildControls() {
  controls_ = new QWidget(this);
  auto* row = rowIn(controls_, 4);
  channelBox_ = new QComboBox(controls_);
  channelBox_->setObjectName("spectrumChannel");
  channelBox_->setAccessibleName(tr("Channel of the spectrum"));
  channelBox_->setToolTip(tr("Of which channel the spectrum is"));
  windowBox_ = new QComboBox(controls_);
  windowBox_->setObjectName("spectrumWindow");
  windowBox_->setAccessibleName(tr("Window function of the spectrum"));
  windowBox_->setToolTip(
      tr("Hann: for most. Blackman-Harris: weak lines beside strong ones. Flat top: heights as they are without "
         "reading between lines. Rectangle: lines as narrow as they can be, with much beside them"));
  for (const auto window :
       {SpectrumWindow::hann, SpectrumWindow::blackmanHarris, SpectrumWindow::flatTop, SpectrumWindow::rectangular})
    windowBox_->addItem(words(window), static_cast<int>(window));
  reading_ = new ElidedLabel("spectrumReading", controls_);
  reading_->setAccessibleName(tr("Highest line of the spectrum"));
  row->addWidget(channelBox_);
  row->addWidget(windowBox_);
  row->addSpacing(8);
  row->addWidget(reading_, 1);
  for (const QComboBox* box : {channelBox_, windowBox_})
    connect(box, &QComboBox::currentIndexChanged, this, &LiveSpectrum::choose);
}

void LiveSpectrum::buildPlot() {
  plot_ = new QCustomPlot(this);
  plot_->setObjectName("spectrumPlot");
  plot_->setAccessibleName(tr("Amplitude spectrum of what the live plots show"));
  plot_->setToolTip(tr("Wheel and mouse choose the frequencies, a double click shows all of them"));
  plot_->setMinimumSize(160, 100);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  QCPAxisRect* rect = plot_->axisRect();
  rect->setRangeDrag(Qt::Horizontal);
  rect->setRangeZoom(Qt::Horizontal);
  rect->setMinimumMargins(QMargins(44, 20, 8, 3));
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    axis->setNumberFormat("gb");
    axis->setNumberPrecision(4);
    axis->grid()->setSubGridVisible(false);
  }
  plot_->xAxis->setNumberFormat("g");
  plot_->xAxis->setLabel(tr("frequency (Hz)"));
  graph_ = plot_->addGraph();
  mark_ = new QCPItemStraightLine(plot_);
  connect(plot_, &QCustomPlot::mouseDoubleClick, this, [this] {
    zoomed_ = false;
    draw();
  });
  connect(plot_, &QCustomPlot::mouseWheel, this, &LiveSpectrum::draw, Qt::QueuedConnection);
  connect(plot_->xAxis, qOverload<const QCPRange&, const QCPRange&>(&QCPAxis::rangeChanged), this,
          [this](const QCPRange&, const QCPRange&) {
            if (!drawing_) zoomed_ = true;
          });
  connect(plot_, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton && zoomed_) draw();
  });
}

void LiveSpectrum::applyLook() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  graph_->setPen(QPen(look.curve(0), 1));
  mark_->setPen(QPen(look.accentLine, 1, Qt::DashLine));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

const LiveChannel& LiveSpectrum::channel() const {
  return channels_[static_cast<size_t>(std::max(0, channelBox_->currentIndex()))];
}

void LiveSpectrum::nameChannels(bool linear) {
  const QSignalBlocker quiet(channelBox_);
  const int chosen = std::max(0, channels_.empty() ? 2 : channelBox_->currentIndex());  // the current at first
  linear_ = linear;
  channels_ = boardChannels(linear);
  channelBox_->clear();
  for (const LiveChannel& one : channels_) channelBox_->addItem(one.name);
  channelBox_->setCurrentIndex(chosen);
  choose();
}

/// What is on its way is of another choice.
void LiveSpectrum::choose() {
  ++wanted_;
  spectrum_.reset();
  draw();
  compute();
}

void LiveSpectrum::show(double from_s, double to_s) {
  if (from_s == from_s_ && to_s == to_s_ && spectrum_) return;
  from_s_ = from_s;
  to_s_ = to_s;
  if (!next_.isActive()) next_.start();
}

/// One at a time; the newest stretch that was asked for meanwhile is next.
void LiveSpectrum::compute() {
  again_ = running_;
  if (running_ || !isVisible()) return;
  const LiveChannel& shown = channel();
  auto stretch = std::make_shared<EvenStretch>(
      evenStretch(history_, from_s_, to_s_, [&shown](const Sample& sample) { return shown.of(sample); }));
  running_ = true;
  pool_.start([this, mine = wanted_, stretch, window = static_cast<SpectrumWindow>(windowBox_->currentData().toInt())] {
    const auto spectrum = std::make_shared<const VisibleSpectrum>(spectrumOf(*stretch, window));
    QMetaObject::invokeMethod(
        this,
        [this, mine, spectrum] {
          running_ = false;
          if (mine == wanted_) take(spectrum);
          if (again_) compute();
        },
        Qt::QueuedConnection);
  });
}

void LiveSpectrum::take(std::shared_ptr<const VisibleSpectrum> spectrum) {
  spectrum_ = std::move(spectrum);
  draw();
}

/// From what fits into the stretch some times to half the rate.
void LiveSpectrum::showAll() {
  const AmplitudeSpectrum& lines = spectrum_->lines;
  plot_->xAxis->setRange(static_cast<double>(lines.halfWidth()) * lines.step_Hz,
                         static_cast<double>(lines.amplitude.size() - 1) * lines.step_Hz);
}

void LiveSpectrum::draw() {
  const QScopedValueRollback<bool> drawing(drawing_, true);
  const bool has = spectrum_ && !spectrum_->lines.amplitude.empty();
  plot_->yAxis->setLabel({});
  graph_->data()->clear();
  mark_->setVisible(false);
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setVisible(has);
    axis->grid()->setVisible(has);
  }
  if (has) {
    if (!zoomed_) showAll();
    const QCPRange range = plot_->xAxis->range();
    QVector<QCPGraphData> points;
    double highest = 0.0;
    for (const SpectrumPoint& point : drawnLines(spectrum_->lines, range.lower, range.upper,
                                                 static_cast<size_t>(std::max(100, plot_->axisRect()->width())))) {
      points.append(QCPGraphData(point.frequency_Hz, point.amplitude));
      highest = std::max(highest, point.amplitude);
    }
    double lowest = highest * std::pow(10.0, -decades);
    for (QCPGraphData& point : points) point.value = std::max(point.value, lowest);
    graph_->data()->set(points, true);
    plot_->yAxis->setLabel(tr("amplitude (%1)").arg(channel().unit));
    bool found = false;
    const QCPRange values = graph_->getValueRange(found, QCP::sdPositive);
    if (found) plot_->yAxis->setRange(0.7 * values.lower, 2.0 * values.upper);
  }
  read();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

QVariant LiveSpectrum::kept() const {
  if (!zoomed_) return {};
  return QVariantList{plot_->xAxis->range().lower, plot_->xAxis->range().upper};
}

void LiveSpectrum::take(const QVariant& kept) {
  zoomed_ = true;
  plot_->xAxis->setRange(kept.toList().value(0).toDouble(), kept.toList().value(1).toDouble());
}

std::optional<SpectrumPeak> LiveSpectrum::peak() const {
  if (!spectrum_) return {};
  return highestPeak(spectrum_->lines, plot_->xAxis->range().lower, plot_->xAxis->range().upper);
}

QString LiveSpectrum::reading() const {
  return reading_->text();
}

void LiveSpectrum::read() {
  if (!spectrum_ || spectrum_->lines.amplitude.empty()) return reading_->setText(tr("Waits for samples"));
  const auto highest = peak();
  if (!highest) return reading_->setText(tr("Nothing but zero in %1 s").arg(spectrum_->length_s, 0, 'f', 1));
  mark_->setVisible(true);
  mark_->point1->setCoords(highest->frequency_Hz, plot_->yAxis->range().lower);
  mark_->point2->setCoords(highest->frequency_Hz, plot_->yAxis->range().upper);
  QString text = tr("Highest %1 Hz: %2 %3")
                     .arg(numberText(highest->frequency_Hz, 4), numberText(highest->amplitude, 3), channel().unit);
  const double orders = spectrum_->turns_Hz > 0.0 && !linear_ ? highest->frequency_Hz / spectrum_->turns_Hz : 0.0;
  if (orders > leastOrders)
    text += tr(", order %1 of the rotor at %2 turns/s").arg(numberText(orders, 3), numberText(spectrum_->turns_Hz, 3));
  reading_->setText(text);
}

}  // namespace breakaway
