#include "widgets/live_toolbar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <array>

#include "session/connection.h"
#include "session/live_samples.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr int recordWidth = 112;  // of "Finish (600 s)"
constexpr std::array<double, 5> spans_s{2.0, 5.0, 10.0, 20.0, 60.0};

}  // namespace

LiveToolbar::LiveToolbar(Connection& connection, LiveSamples& live, FileChooser& files, QComboBox* trigger,
                         QWidget* parent)
    : QWidget(parent), connection_(connection), live_(live), files_(files) {
  pause_ = toolButton(this, "pauseButton", tr("Pause"),
                      tr("Hold the picture still; samples keep coming in (P in the plot)"));
  pause_->setCheckable(true);
  cursors_ = toolButton(this, "cursorsButton", tr("Cursors"),
                        tr("Two cursors A and B over all plots (C in the plot): drag them, or move A with the "
                           "arrow keys and B with Shift"));
  spectrum_ = toolButton(this, "spectrumButton", tr("Spectrum"),
                         tr("The frequencies of what is visible, of any channel (S in the plot)"));
  large_ = toolButton(this, "largeLiveButton", tr("Large"),
                      tr("The plots take the page's place, until this is pressed again (L in the plot)"));
  for (QToolButton* button : {cursors_, spectrum_, large_}) button->setCheckable(true);
  span_ = new QComboBox(this);
  span_->setObjectName("spanBox");
  span_->setAccessibleName(tr("Visible time span"));
  span_->setToolTip(tr("Visible time span; while the picture is paused, the wheel zooms"));
  for (const double span : spans_s) span_->addItem(tr("%1 s").arg(span), span);
  span_->setCurrentIndex(2);
  connect(span_, &QComboBox::currentIndexChanged, this, &LiveToolbar::spanChanged);
  record_ = toolButton(this, "recordButton", tr("Record"), {});
  record_->setFixedWidth(recordWidth);
  connect(record_, &QToolButton::clicked, &live_,
          [this] { live_.recording() ? live_.finishRecording() : live_.startRecording(); });
  export_ = toolButton(this, "exportVisibleButton", tr("Export visible…"),
                       tr("Write the visible stretch as CSV, every sample of it"));
  connect(export_, &QToolButton::clicked, this, &LiveToolbar::exportAsked);
  save_ = toolButton(this, "saveRecordingButton", tr("Save recording…"), tr("Write the last recording as CSV"));
  connect(save_, &QToolButton::clicked, this, &LiveToolbar::saveRecording);
  difference_ = new ElidedLabel("cursorDifference", this);
  difference_->setFont(typed(Type::caption));
  difference_->setAlignment(Qt::AlignVCenter | Qt::AlignRight);
  auto* row = rowIn(this, 4);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{pause_, large_, cursors_, spectrum_, span_, trigger, record_, save_, export_})
    row->addWidget(widget);
  row->addWidget(difference_, 100);  // all that is left; where it is hidden, nothing else grows
  row->addStretch(1);
  connect(&connection_, &Connection::changed, this, &LiveToolbar::showAvailable);
  connect(&connection_, &Connection::linkChanged, this, &LiveToolbar::showAvailable);
  connect(&live_, &LiveSamples::recordingChanged, this, &LiveToolbar::showAvailable);
  showAvailable();
}

double LiveToolbar::span_s() const {
  return span_->currentData().toDouble();
}

void LiveToolbar::showAvailable() {
  setAvailable(record_, connection_.connected(),
               tr("Record every sample at the full rate, on the disk (R in the plot)"), tr("No board is connected"));
  setAvailable(export_, connection_.connected() || live_.history().newest(),
               tr("Write the visible stretch as CSV, every sample of it"), tr("No sample has come yet"));
  setAvailable(save_, !live_.lastRecording().isEmpty(), tr("Write the last recording as CSV"),
               tr("Nothing was recorded yet"));
  record_->setText(live_.recording() ? tr("Finish (%1 s)").arg(connection_.link().recorded_s, 0, 'f', 0)
                                     : tr("Record"));
}

void LiveToolbar::saveRecording() {
  files_.ask(this, {tr("Save the last recording"), tr("Recording (*.csv)"), "recording.csv", true},
             [this](const QString& path) { live_.saveLast(path); });
}

}  // namespace breakaway
