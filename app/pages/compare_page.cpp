#include "pages/compare_page.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>
#include <cmath>

#include "session/bench_runs.h"
#include "session/comparison.h"
#include "session/live_samples.h"
#include "session/resource_folder.h"
#include "widgets/controls.h"
#include "widgets/facts_table.h"
#include "widgets/findings_list.h"
#include "widgets/residual_axis.h"
#include "widgets/residual_plots.h"

namespace breakaway {

namespace {

QString fileName(const std::string& path) {
  return QFileInfo(QString::fromStdString(path)).fileName();
}

/// "4.53 mm" or "0.217 mrad", whatever reads well.
QString lengthText(double value, bool linear) {
  const QString unit = linear ? "m" : "rad";
  if (value >= 1.0) return QString("%1 %2").arg(value, 0, 'g', 3).arg(unit);
  if (value >= 1e-3) return QString("%1 m%2").arg(1e3 * value, 0, 'g', 3).arg(unit);
  return QString("%1 µ%2").arg(1e6 * value, 0, 'g', 3).arg(unit);
}

}  // namespace

ComparePage::ComparePage(const BenchRuns& bench, const LiveSamples& live, Comparison& comparison, FileChooser& files,
                         QWidget* parent)
    : Page("comparePage", tr("Compare"), "compare", parent),
      bench_(bench),
      live_(live),
      comparison_(comparison),
      files_(files) {
  setAcceptDrops(true);
  auto* column = columnIn(this, 5, {16, 8, 16, 4});
  column->addWidget(buildInputs());
  auto* row = new QHBoxLayout;
  row->setSpacing(14);
  row->addWidget(buildPlots(), 1);
  row->addWidget(buildVerdict());
  column->addLayout(row, 1);
  connect(&comparison_, &Comparison::inputsChanged, this, &ComparePage::showInputs);
  connect(&comparison_, &Comparison::progressChanged, this, &ComparePage::showProgress);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &ComparePage::showProof);
  connect(&comparison_, &Comparison::tracesChanged, this, &ComparePage::showProof);
  connect(&live_, &LiveSamples::recordingChanged, this, &ComparePage::showInputs);
  showInputs();
  showProof();
}

QWidget* ComparePage::buildInputs() {
  auto* strip = new QWidget(this);
  auto* row = rowIn(strip, 6);
  openBench_ = pushButton(strip, "openBenchButton", tr("Bench…"),
                          tr("What is believed of the rig: NAME.bench.json. Dropping the file here does the same."));
  openRecording_ =
      pushButton(strip, "openRecordingButton", tr("Recording…"), tr("NAME.csv. Dropping the file here does the same."));
  openHeldout_ =
      pushButton(strip, "openHeldoutButton", tr("Held-out…"),
                 tr("A second recording to prove the findings on; without it, parts of the first are held out"));
  takeLive_ = pushButton(strip, "takeLiveButton", tr("Last live"));
  openExample_ = pushButton(strip, "openExampleButton", tr("Example"));
  diagnose_ = pushButton(strip, "diagnoseButton", tr("Diagnose"));
  cancel_ = pushButton(strip, "cancelButton", tr("Cancel"));
  progress_ = new QProgressBar(strip);
  progress_->setObjectName("diagnoseProgress");
  progress_->setAccessibleName(tr("Progress of the diagnosis"));
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedSize(110, 10);
  activity_ = new QLabel(strip);
  activity_->setObjectName("diagnoseActivity");
  activity_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{openBench_, openRecording_, openHeldout_, takeLive_, openExample_})
    row->addWidget(widget);
  row->addSpacing(10);
  for (QWidget* widget : std::initializer_list<QWidget*>{diagnose_, cancel_, progress_}) row->addWidget(widget);
  row->addWidget(activity_, 1);
  connect(openBench_, &QPushButton::clicked, this, [this] {
    ask(tr("Open a bench"), tr("Bench (*.bench.json *.json)"),
        [this](const QString& path) { comparison_.openBench(path); });
  });
  connect(openRecording_, &QPushButton::clicked, this, [this] {
    ask(tr("Open a recording"), tr("Recording (*.csv)"),
        [this](const QString& path) { comparison_.openRecording(path); });
  });
  connect(openHeldout_, &QPushButton::clicked, this, [this] {
    ask(tr("Open a held-out recording"), tr("Recording (*.csv)"),
        [this](const QString& path) { comparison_.openHeldout(path); });
  });
  connect(takeLive_, &QPushButton::clicked, this, &ComparePage::takeLive);
  connect(openExample_, &QPushButton::clicked, this, &ComparePage::openExample);
  connect(diagnose_, &QPushButton::clicked, &comparison_, &Comparison::diagnose);
  connect(cancel_, &QPushButton::clicked, &comparison_, &Comparison::cancel);
  return strip;
}

QWidget* ComparePage::buildPlots() {
  auto* side = new QWidget(this);
  auto* column = columnIn(side, 4);
  plots_ = new ResidualPlots(comparison_, side);
  auto* strip = new QHBoxLayout;
  axis_ = new QComboBox(side);
  axis_->setObjectName("residualAxis");
  axis_->setAccessibleName(tr("Axis of the residual"));
  for (const QString& axis : residualAxes())
    axis_->addItem(tr("Residual over %1")
                       .arg(axis == "current"    ? tr("motor torque or force")
                            : axis == "reversal" ? tr("travel since reversal")
                                                 : axis),
                   axis);
  auto* legend = new QLabel(tr("Bands: where they part. Green line: held out. Drag and wheel zoom in time."), side);
  legend->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  strip->addWidget(axis_);
  strip->addWidget(legend, 1);
  column->addWidget(plots_, 1);
  column->addLayout(strip);
  connect(axis_, &QComboBox::currentIndexChanged, this, [this] { plots_->setAxis(axis_->currentData().toString()); });
  return side;
}

QWidget* ComparePage::buildVerdict() {
  auto* side = new QWidget(this);
  side->setFixedWidth(420);
  auto* column = columnIn(side, 6);
  proof_ = new FactsTable("proof", side);
  findings_ = new FindingsList(comparison_, side);
  column->addWidget(proof_);
  column->addWidget(rule(side));
  column->addWidget(findings_, 1);
  connect(findings_, &FindingsList::axisChosen, this,
          [this](const QString& axis) { axis_->setCurrentIndex(axis_->findData(axis)); });
  return side;
}

void ComparePage::ask(const QString& title, const QString& filter, const FileChooser::Answer& open) {
  files_.ask(this, {title, filter, {}, false}, open);
}

void ComparePage::openExample() {
  for (const QString& path : resourceFiles("examples", ".bench.json")) {
    const QString recording = path.chopped(QString(".bench.json").size()) + ".csv";
    if (!QFileInfo::exists(recording)) continue;
    comparison_.openBench(path);
    comparison_.openRecording(recording);
    return;
  }
}

void ComparePage::takeLive() {
  if (!live_.lastRecording()) return;
  comparison_.takeRecording(*live_.lastRecording());
  if (bench_.bench() && !comparison_.bench()) comparison_.takeBench(*bench_.bench());
}

void ComparePage::showInputs() {
  const auto& bench = comparison_.bench();
  openBench_->setText(bench ? tr("Bench: %1").arg(QString::fromStdString(bench->name).left(24)) : tr("Bench…"));
  const auto& recording = comparison_.recording();
  openRecording_->setText(recording ? tr("Recording: %1").arg(fileName(recording->name()).left(24)) : tr("Recording…"));
  const auto& heldout = comparison_.heldout();
  openHeldout_->setText(heldout ? tr("Held-out: %1").arg(fileName(heldout->name()).left(20)) : tr("Held-out…"));
  setAvailable(takeLive_, live_.lastRecording().has_value(),
               tr("Take the last recording that was made in the live plots"),
               tr("Nothing was recorded yet: Record, below the page, begins one"));
  setAvailable(openExample_, !resourceFiles("examples", ".bench.json").isEmpty(),
               tr("A recording of a simulated rig with concealed physics"), tr("The examples are not installed"));
  showProgress();
}

void ComparePage::showProgress() {
  const bool running = comparison_.diagnosing();
  setAvailable(diagnose_,
               tr("Fits the declared physics, searches for what is missing, and decides on data that was held out"),
               comparison_.obstacle());
  setAvailable(cancel_, running, tr("End the diagnosis"), tr("No diagnosis is running"));
  progress_->setVisible(running);
  progress_->setValue(static_cast<int>(std::lround(1000.0 * comparison_.progress())));
  activity_->setText(running ? comparison_.activity() : QString());
}

void ComparePage::showProof() {
  const auto& diagnosis = comparison_.diagnosis();
  if (!diagnosis) {
    proof_->show({{tr("Held-out error"), tr("not diagnosed yet"), {}}});
    return;
  }
  const FitScore& fit = diagnosis->fit;
  const bool linear = diagnosis->base.axis == Axis::linear;
  const auto change = [linear](double before, double after) {
    return tr("%1 → %2").arg(lengthText(before, linear), lengthText(after, linear));
  };
  std::vector<Fact> facts{
      {tr("Held-out error"), change(fit.heldoutBefore, fit.heldoutAfter),
       tr("RMS error of the position over windows of %1 s, with the base model and with the extended one; %2")
           .arg(fit.window_s)
           .arg(fit.separateRecording ? tr("on a separate recording") : tr("on held-out parts of the recording"))},
      {tr("Better by"),
       tr("%1 % (95 %: %2 to %3 %)")
           .arg(100.0 * (1.0 - fit.heldoutAfter / std::max(fit.heldoutBefore, 1e-300)), 0, 'f', 0)
           .arg(100.0 * fit.improvementLow95, 0, 'f', 0)
           .arg(100.0 * fit.improvementHigh95, 0, 'f', 0),
       {}},
      {tr("Training error"), change(fit.trainBefore, fit.trainAfter), {}},
      {tr("A perfect model"), lengthText(fit.floor, linear),
       tr("What noise of the sensors, and the unknown start of each window, leave even to a perfect model")}};
  if (!comparison_.shownTrace().position.empty()) {
    facts.push_back({tr("As ticked below"), lengthText(comparison_.shownRmse(), linear),
                     tr("RMS error of the position as the drawn simulation has it, over the held-out rows")});
  }
  proof_->show(facts);
}

void ComparePage::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void ComparePage::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls()) comparison_.open(url.toLocalFile());
}

}  // namespace breakaway
