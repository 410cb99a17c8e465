#include "pages/compare_page.h"

#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "base/uuid.h"
#include "recording/csv.h"
#include "recording/stretch.h"
#include "session/bench_project.h"
#include "session/bench_runs.h"
#include "session/comparison.h"
#include "session/experiment_run.h"
#include "session/live_samples.h"
#include "session/resource_folder.h"
#include "session/trial_run.h"
#include "widgets/compared_plots.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/facts_table.h"
#include "widgets/file_slot.h"
#include "widgets/findings_list.h"
#include "widgets/log_panel.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/parameter_words.h"
#include "widgets/trial_strip.h"
#include "widgets/verdict_card.h"

namespace breakaway {

namespace {

constexpr int shortValue = 14;  // characters that have room beside the longest name

QString fileName(const std::string& path) {
  return QFileInfo(QString::fromStdString(path)).fileName();
}

}  // namespace

ComparePage::ComparePage(const BenchRuns& bench, const LiveSamples& live, Comparison& comparison,
                         ExperimentRun& experiment, TrialRun& trial, BenchProject& project, FileChooser& files,
                         QWidget* parent)
    : Page("comparePage", tr("Compare"), parent),
      bench_(bench),
      project_(project),
      live_(live),
      comparison_(comparison),
      experiment_(experiment),
      trial_(trial),
      files_(files) {
  setAcceptDrops(true);
  setHead(tr("Compare"), tr("Which physics a bench file leaves out, and the proof."));
  diagnose_ = addPrimary("diagnoseButton", tr("Diagnose"));
  cancel_ = addSecondary("cancelButton", tr("Cancel"), 104);
  finish_ = addSecondary("finishButton", tr("Finish now"), 120);
  sealedTrial_ = addSecondary("sealedTrialButton", tr("Sealed trial"), 168);
  buildInputs();
  buildFindings();
  buildBase();
  settings()->addStretch(1);
  compared_ = new QWidget(this);
  auto* column = columnIn(compared_, 8);
  column->addWidget(new VerdictCard(comparison_, compared_));
  column->addWidget(new TrialStrip(trial_, compared_));
  plots_ = new ComparedPlots(comparison_, compared_);
  column->addWidget(plots_, 1);
  log_ = new LogPanel(comparison_.log(), this);
  picture()->addWidget(log_, 1);
  picture()->addWidget(compared_, 1);
  addReading("compareReading");
  connect(plots_, &ComparedPlots::reading, this, &ComparePage::read);
  connect(plots_, &ComparedPlots::visibleChanged, this, &ComparePage::showKeep);
  connect(plots_, &ComparedPlots::keepAsked, this, &ComparePage::keepVisible);
  connect(&comparison_.log(), &LogOpening::changed, this, &ComparePage::showLog);
  connect(&comparison_, &Comparison::inputsChanged, this, &ComparePage::showInputs);
  connect(&comparison_, &Comparison::progressChanged, this, &ComparePage::showProgress);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &ComparePage::showProof);
  connect(&comparison_, &Comparison::tracesChanged, this, &ComparePage::showProof);
  connect(&live_, &LiveSamples::recordingChanged, this, &ComparePage::showInputs);
  showInputs();
  showBeneath();
  showProof();
  showLog();
}

void ComparePage::buildInputs() {
  auto* group = new QWidget(this);
  auto* column = columnIn(group, 6);
  openBench_ =
      new FileSlot("openBenchButton", tr("Bench"),
                   tr("What is believed of the rig: NAME.bench.json. Dropping the file here does the same."), group);
  openRecording_ = new FileSlot(
      "openRecordingButton", tr("Recording"),
      tr("NAME.csv, or another tool's log, which is shown as it is understood before it is opened. Dropping the file "
         "here does the same."),
      group);
  openHeldout_ = new FileSlot(
      "openHeldoutButton", tr("Held-out"),
      tr("A second recording to prove the findings on; without it, parts of the first are held out"), group);
  openBeneath_ = new FileSlot("openBeneathButton", tr("Beneath"),
                              tr("Another recording that is drawn dashed beneath this one, from where both begin to "
                                 "move; Runs lays a kept one there"),
                              group);
  takeBeneathAway_ = toolButton(group, "takeBeneathAwayButton", "×", tr("Takes away what lies beneath"));
  takeBeneathAway_->setAccessibleName(tr("Take away what lies beneath"));
  for (QWidget* slot : {openBench_, openRecording_, openHeldout_}) column->addWidget(slot);
  auto* beneath = new QHBoxLayout;
  beneath->setSpacing(8);
  beneath->addWidget(openBeneath_, 1);
  beneath->addWidget(takeBeneathAway_);
  column->addLayout(beneath);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  takeLive_ = pushButton(group, "takeLiveButton", tr("Last recording"));
  openExample_ = pushButton(group, "openExampleButton", tr("Example"));
  row->addWidget(takeLive_, 1);
  row->addWidget(openExample_, 1);
  column->addLayout(row);
  settings()->addWidget(group);
  connect(openBench_, &QPushButton::clicked, this, [this] {
    ask(tr("Open a bench"), tr("Bench (*.bench.json *.json)"),
        [this](const QString& path) { comparison_.openBench(path); });
  });
  connect(openRecording_, &QPushButton::clicked, this, [this] {
    ask(tr("Open a recording"), tr("Recordings and logs (*)"),
        [this](const QString& path) { comparison_.openRecording(path); });
  });
  connect(openHeldout_, &QPushButton::clicked, this, [this] {
    ask(tr("Open a held-out recording"), tr("Recordings and logs (*)"),
        [this](const QString& path) { comparison_.openHeldout(path); });
  });
  connect(openBeneath_, &QPushButton::clicked, this, [this] {
    ask(tr("Lay a recording beneath"), tr("Recordings (*.csv *.blocks)"),
        [this](const QString& path) { comparison_.layBeneath(path); });
  });
  connect(takeBeneathAway_, &QToolButton::clicked, this, [this] { comparison_.layBeneath({}); });
  connect(&comparison_, &Comparison::beneathChanged, this, &ComparePage::showBeneath);
  connect(takeLive_, &QPushButton::clicked, this, &ComparePage::takeLive);
  connect(openExample_, &QPushButton::clicked, this, &ComparePage::openExample);
  connect(sealedTrial_, &QPushButton::clicked, this, [this] { trial_.conceal(); });
  connect(&trial_, &TrialRun::changed, this, &ComparePage::showTrial);
  connect(diagnose_, &QPushButton::clicked, &comparison_, &Comparison::diagnose);
  connect(cancel_, &QPushButton::clicked, &comparison_, &Comparison::cancel);
  connect(finish_, &QPushButton::clicked, &comparison_, &Comparison::finishNow);
}

void ComparePage::buildBase() {
  auto* group = card(this);
  columnOf(group)->addWidget(section(group, tr("Base parameters")));
  base_ = new FactsTable("baseParameters", group);
  base_->setOneLine(shortValue);
  columnOf(group)->addWidget(base_);
  settings()->addWidget(group);
}

void ComparePage::buildFindings() {
  auto* group = card(this);
  columnOf(group)->addWidget(section(group, tr("Findings")));
  ticked_ = new ElidedLabel("tickedLine", group);
  ticked_->setFont(typed(Type::caption));
  ticked_->setProperty("tone", "muted");
  findings_ = new FindingsList(comparison_, group);
  runExperiment_ = pushButton(group, "runExperimentButton", tr("Run the next experiment"));
  columnOf(group)->addWidget(runExperiment_);  // above the list, which is long
  columnOf(group)->addWidget(ticked_);
  columnOf(group)->addWidget(findings_);
  connect(runExperiment_, &QPushButton::clicked, &experiment_, &ExperimentRun::start);
  connect(&experiment_, &ExperimentRun::changed, this, &ComparePage::showExperiment);
  showExperiment();
  settings()->addWidget(group);
  connect(findings_, &FindingsList::evidenceChosen, this,
          [this](const QString& effect) { plots_->showEvidenceOf(effect); });
  connect(findings_, &FindingsList::axisChosen, this, [this](const QString& axis) { plots_->showResidualOver(axis); });
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
  if (live_.lastRecording().isEmpty()) return;
  comparison_.openRecording(live_.lastRecording());
  if (bench_.bench() && !comparison_.bench()) comparison_.takeBench(*bench_.bench());
}

/// Rows of the recording that the plot over time shows now.
std::optional<Recording> ComparePage::visible() const {
  const auto& recording = comparison_.recording();
  if (!recording) return std::nullopt;
  const auto [from_s, to_s] = plots_->visible_s();
  const auto part = stretchOf(*recording, from_s, to_s);
  return part ? std::optional(*part) : std::nullopt;
}

void ComparePage::showKeep() {
  const auto& recording = comparison_.recording();
  QString reason;
  if (!recording) {
    reason = tr("Open a recording first");
  } else {
    const auto [from_s, to_s] = plots_->visible_s();
    if (from_s <= recording->time().front() && to_s >= recording->time().back())
      reason = tr("All of it is visible: zoom in with the wheel, over the measurement");
  }
  plots_->setKeepObstacle(reason);
}

void ComparePage::keepVisible() {
  const auto part = visible();
  if (!part) return;
  NewRun run;
  run.at = utcNow();
  run.kind = "recording";
  run.name = tr("%1, %2 s to %3 s")
                 .arg(fileName(part->name()))
                 .arg(part->time().front(), 0, 'f', 3)
                 .arg(part->time().back(), 0, 'f', 3)
                 .toStdString();
  if (comparison_.bench()) run.motor = comparison_.bench()->motorSerial;
  run.write = [part = *part](const std::string& folder) { return writeCsv(part, folder + "/recording.csv"); };
  project_.put(run);
}

void ComparePage::showInputs() {
  const auto& bench = comparison_.bench();
  openBench_->show(bench ? QString::fromStdString(bench->name) : QString(), !bench ? QString()
                                                                            : bench->axis == Axis::linear
                                                                                ? tr("linear")
                                                                                : tr("rotary"));
  const auto about = [](const Recording& recording) {
    return tr("%1 s").arg(numberText(recording.time().back() - recording.time().front()));
  };
  const auto& recording = comparison_.recording();
  const auto beside = [](const QString& first, size_t all) {
    return all > 1 ? tr("%1, %2 more").arg(first).arg(all - 1) : first;
  };
  openRecording_->show(recording ? fileName(recording->name()) : QString(),
                       recording ? beside(about(*recording), comparison_.recordings().size()) : QString());
  const auto& heldout = comparison_.heldout();
  openHeldout_->show(heldout     ? fileName(heldout->name())
                     : recording ? tr("parts of the recording")
                                 : QString(),
                     heldout ? beside(about(*heldout), comparison_.allHeldout().size()) : QString());
  setAvailable(takeLive_, !live_.lastRecording().isEmpty(),
               tr("Take the last recording that was made in the live plots"),
               tr("Nothing was recorded yet: Record, below the page, begins one"));
  setAvailable(openExample_, !resourceFiles("examples", ".bench.json").isEmpty(),
               tr("A recording of a simulated rig with concealed physics"), tr("The examples are not installed"));
  showProgress();
  showKeep();
  showTrial();
  showHint();
}

void ComparePage::showBeneath() {
  const auto& beneath = comparison_.beneath();
  openBeneath_->show(beneath ? beneath->name : QString(), {});
  setAvailable(takeBeneathAway_, beneath.has_value(), tr("Takes away what lies beneath"),
               tr("No recording lies beneath"));
}

void ComparePage::showTrial() {
  setAvailable(sealedTrial_,
               tr("Conceals physics in a simulated rig and records it; whoever diagnoses sees bench and recordings "
                  "alone. Unseal says whether the answer is right."),
               trial_.obstacle());
}

void ComparePage::showExperiment() {
  setAvailable(runExperiment_, experiment_.plan(), experiment_.obstacle());
  showNext();
}

/// One button is to be pressed: to diagnose, and then to make the experiment that tells more, where the board can.
void ComparePage::showNext() {
  const bool experiment = comparison_.diagnosis() && runExperiment_->isEnabled();
  dressAs(runExperiment_, "role", experiment ? "primary" : QString());
  dressAs(diagnose_, "role", experiment ? QString() : "primary");
}

void ComparePage::showProgress() {
  const bool running = comparison_.diagnosing();
  setAvailable(
      diagnose_, tr("Fits the declared physics, searches for what is missing, and decides on data that was held out"),
      comparison_.log().isOpen() ? tr("Open the log as a recording first, or leave it") : comparison_.obstacle());
  setAvailable(cancel_, running, tr("End the diagnosis"), tr("No diagnosis is running"));
  const bool finishing = comparison_.finishing();
  setAvailable(finish_, running && !finishing, tr("Weigh and prove what was found so far, and look no further"),
               finishing ? tr("It looks no further; what was found is being proved") : tr("No diagnosis is running"));
  if (!comparison_.diagnosis()) showHint();
  showState();
}

void ComparePage::showLog() {
  const bool open = comparison_.log().isOpen();
  // One goes before the other comes: together they ask for more room than there is.
  (open ? compared_ : static_cast<QWidget*>(log_))->hide();
  (open ? static_cast<QWidget*>(log_) : compared_)->show();
  showProgress();
  showHint();
}

/// What can be read off, or what is next.
void ComparePage::showHint() {
  const QString obstacle = comparison_.obstacle();
  read(comparison_.log().isOpen() ? tr("Check what each column is taken as; then open the log as a recording")
       : comparison_.diagnosis()  ? tr("Point at a plot to read it")
       : !comparison_.recording() ? tr("Open a bench file and a recording on the left, or the example")
       : comparison_.diagnosing() ? tr("The diagnosis runs; Finish now takes what was found so far, Cancel ends it")
       : !obstacle.isEmpty()      ? obstacle
                                  : tr("Diagnose finds what the bench file leaves out"));
}

void ComparePage::showState() {
  const auto& diagnosis = comparison_.diagnosis();
  if (comparison_.diagnosing()) {
    setState({StepMark::running, tr("%1 % done").arg(100.0 * comparison_.progress(), 0, 'f', 0)});
  } else if (diagnosis) {
    const auto count = diagnosis->findings.size();
    setState({StepMark::done, count == 0   ? tr("nothing missing")
                              : count == 1 ? tr("1 finding")
                                           : tr("%1 findings").arg(count)});
  } else {
    setState({StepMark::open, comparison_.recording() ? tr("not diagnosed yet") : tr("needs a recording")});
  }
}

std::vector<Fact> ComparePage::baseFacts(const Diagnosis& diagnosis) {
  std::vector<Fact> facts;
  for (const Parameter& parameter : diagnosis.model.base) {  // as the command says them: beside the findings
    const ParameterWords words = wordsOf(parameter);
    facts.push_back({words.name, words.estimate,
                     words.interval.isEmpty() ? tr("Held as declared")
                                              : tr("%1 %2 with 95 % confidence").arg(words.interval, words.unit)});
  }
  const bool linear = diagnosis.base.axis == Axis::linear;
  const auto coulomb = diagnosis.model.baseValue(linear ? "coulomb_N" : "coulomb_Nm");
  const QString size = linear ? tr("%1 N").arg(numberText(diagnosis.wander.rms, 2))
                              : tr("%1 mNm").arg(numberText(1e3 * diagnosis.wander.rms, 2));
  facts.push_back(
      {tr("Wander of the friction"),
       coulomb && *coulomb > 0.0 ? tr("%1 % of it").arg(numberText(100.0 * diagnosis.wander.rms / *coulomb, 2)) : size,
       tr("Torque that changes at random and has no place: %1 rms, over about %2 s")
           .arg(size, numberText(diagnosis.wander.time_s, 2))});
  return facts;
}

void ComparePage::showProof() {
  const auto& diagnosis = comparison_.diagnosis();
  if (diagnosis) {
    base_->show(baseFacts(*diagnosis));
  } else {
    base_->show({{tr("Not fitted yet"), {}, {}}});
  }
  const bool drawn = diagnosis && !comparison_.shownTrace().position.empty();
  const QString off = drawn ? channelText(comparison_.shownRmse(), comparison_.shownChannel()) : QString();
  ticked_->setVisible(diagnosis && !diagnosis->findings.empty());
  ticked_->setText(!drawn ? tr("Untick one to see the fit without it")
                   : diagnosis->fit.inTorque()
                       ? tr("This motion can't be foreseen (%1 off): the torque counts").arg(off)
                       : tr("As ticked, the error is %1").arg(off));
  showNext();
  showHint();
  showState();
}

void ComparePage::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void ComparePage::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls()) comparison_.open(url.toLocalFile());
}

}  // namespace breakaway
