#include "pages/runs_page.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>

#include "session/comparison.h"
#include "session/project_runs.h"
#include "session/shown_maps.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/facts_table.h"
#include "widgets/parameter_words.h"
#include "widgets/run_comparison_panel.h"
#include "widgets/run_words.h"
#include "widgets/runs_table.h"

namespace breakaway {

namespace {

constexpr size_t mostValues = 8;
constexpr int shortRunValue = 8;  // characters that have room beside the longest name

QString asIs(const std::string& text) {
  return QString::fromStdString(text);
}

}  // namespace

RunsPage::RunsPage(BenchProject& project, ProjectRuns& runs, ShownMaps& maps, Comparison& comparison,
                   FileChooser& files, QWidget* parent)
    : Page("runsPage", tr("Runs"), parent),
      project_(project),
      runs_(runs),
      maps_(maps),
      comparison_(comparison),
      files_(files) {
  setHead(tr("Runs"), tr("All that was measured and found, kept by itself; this window's and the commands'."));
  open_ = addPrimary("openRunButton", tr("Open"));
  compare_ = addSecondary("compareRunsButton", tr("Compare two"));
  settings()->addWidget(buildFind());
  settings()->addWidget(buildChosen());
  settings()->addStretch(1);
  table_ = new RunsTable(this);
  compared_ = new RunComparisonPanel(files, this);
  compared_->hide();
  picture()->addWidget(table_, 1);
  picture()->addWidget(compared_, 1);
  addReading("runReading");
  connect(table_, &RunsTable::chosenChanged, this, &RunsPage::showChosen);
  connect(table_, &RunsTable::opened, this, &RunsPage::open);
  connect(table_, &RunsTable::renamed, this,
          [this](const std::string& id, const QString& name) { runs_.note(id, {.name = name.toStdString()}); });
  connect(table_, &RunsTable::remarked, this,
          [this](const std::string& id, const QString& remark) { runs_.note(id, {.remark = remark.toStdString()}); });
  connect(compared_, &RunComparisonPanel::closed, this, [this] {
    compared_->hide();
    table_->QWidget::show();
    table_->setFocus();
  });
  connect(compared_, &RunComparisonPanel::reportAsked, &runs_, &ProjectRuns::writeReport);
  connect(open_, &QPushButton::clicked, this, &RunsPage::open);
  connect(compare_, &QPushButton::clicked, this, &RunsPage::compareChosen);
  connect(&runs_, &ProjectRuns::listed, this, &RunsPage::showList);
  showList();
  showChosen();
}

QWidget* RunsPage::buildFind() {
  auto* group = card(this);
  columnOf(group)->addWidget(section(group, tr("Find")));
  text_ = new QLineEdit(group);
  text_->setObjectName("runsText");
  text_->setAccessibleName(tr("Text in a run"));
  text_->setPlaceholderText(tr("Name, remark, result, date"));
  text_->setToolTip(tr("Only runs with this in their name, remark, folder, result or command"));
  const auto box = [&](const char* objectName, const QString& name, const QString& tip) {
    auto* one = new QComboBox(group);
    one->setObjectName(objectName);
    one->setAccessibleName(name);
    one->setToolTip(tip);
    one->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    one->setMinimumContentsLength(8);
    connect(one, &QComboBox::currentIndexChanged, this, &RunsPage::find);
    return one;
  };
  motor_ = box("runsMotor", tr("Motor"), tr("Only runs of this motor, by its serial number"));
  kind_ = box("runsKind", tr("Kind"), tr("Only runs of this kind"));
  motor_->addItem(tr("Every motor"), QString());
  kind_->addItem(tr("Every kind"), QString());
  columnOf(group)->addWidget(text_);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(motor_, 1);
  row->addWidget(kind_, 1);
  columnOf(group)->addLayout(row);
  count_ = caption(group, {});
  count_->setObjectName("runsCount");
  columnOf(group)->addWidget(count_);
  connect(text_, &QLineEdit::textChanged, this, &RunsPage::find);
  return group;
}

QWidget* RunsPage::buildChosen() {
  auto* group = card(this);
  columnOf(group)->addWidget(section(group, tr("Chosen")));
  title_ = new ElidedLabel("runTitle", group);
  columnOf(group)->addWidget(title_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(8);
  const auto button = [&](const char* objectName, const QString& text, int row, int column, void (RunsPage::*what)()) {
    auto* one = pushButton(group, objectName, text);
    grid->addWidget(one, row, column);
    grid->setColumnStretch(column, 1);
    connect(one, &QPushButton::clicked, this, what);
    return one;
  };
  report_ = button("openRunReportButton", tr("Open report"), 0, 0, &RunsPage::openReport);
  csv_ = button("saveRunCsvButton", tr("Save as CSV…"), 0, 1, &RunsPage::saveCsv);
  beneath_ = button("layMapBeneathButton", tr("Lay beneath"), 1, 0, &RunsPage::layBeneath);
  columnOf(group)->addLayout(grid);
  values_ = new FactsTable("runValues", group);
  values_->setOneLine(shortRunValue);
  columnOf(group)->addWidget(values_);
  findings_ = explanation(group, {}, "runFindings");
  columnOf(group)->addWidget(findings_);
  return group;
}

void RunsPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  runs_.refresh();
}

void RunsPage::find() {
  RunFilter filter;
  filter.text = text_->text().trimmed().toStdString();
  filter.motor = motor_->currentData().toString().toStdString();
  filter.kind = kind_->currentData().toString().toStdString();
  runs_.filter(filter);
}

/// Its first line, for all of them, stays; so does what was chosen.
void RunsPage::offer(QComboBox& box, const std::vector<std::string>& names, QString (*inWords)(const std::string&)) {
  const QSignalBlocker quiet(box);
  const QVariant before = box.currentData();
  while (box.count() > 1) box.removeItem(1);
  for (const std::string& name : names) box.addItem(inWords(name), QString::fromStdString(name));
  box.setCurrentIndex(std::max(0, box.findData(before)));
}

void RunsPage::showList() {
  offer(*motor_, runs_.motors(), asIs);
  offer(*kind_, runs_.kinds(), kindInWords);
  const size_t all = runs_.all(), shown = runs_.runs().size();
  table_->show(runs_.runs(), all == 0
                                 ? tr("Nothing was kept yet. A sweep, a recording or a diagnosis comes here by itself.")
                                 : tr("No run passes the filter."));
  count_->setText(shown == all ? tr("%1 runs").arg(all) : tr("%1 of %2 runs").arg(shown).arg(all));
  setState({StepMark::open, all == 0 ? tr("nothing kept yet") : tr("%1 kept").arg(all)});
}

void RunsPage::showChosen() {
  chosen_ = table_->chosen();
  read_ = false;
  values_->show({});
  findings_->setText({});
  title_->setText(chosen_.empty()       ? tr("Choose a run in the table")
                  : chosen_.size() == 1 ? titleOf(chosen_[0])
                                        : tr("%1 runs").arg(chosen_.size()));
  read(chosen_.empty() ? tr("Folder of the project: %1").arg(project_.folder()) : QString());
  showButtons();
  if (chosen_.size() == 1) runs_.read(chosen_[0].id, this, [this](const KeptRun& kept) { showRun(kept); });
}

void RunsPage::showRun(const KeptRun& kept) {
  if (chosen_.size() != 1 || chosen_[0].id != kept.run.id) return;
  chosen_[0] = kept.run;
  read_ = true;
  std::vector<Fact> facts;
  for (const RunValue& value : byImportance(kept.run)) {
    if (facts.size() == mostValues) break;
    const ParameterWords words = wordsOf(Parameter{value.name, value.value, value.low, value.high});
    facts.push_back({words.name, words.estimate, tr("%1 %2 with 95 % confidence").arg(words.interval, words.unit)});
  }
  values_->show(facts);
  QStringList findings;
  for (const std::string& one : kept.run.findings) findings << QString::fromStdString(one);
  findings_->setText(findings.join("\n\n"));
  read(tr("Folder: %1").arg(QString::fromStdString(kept.folder)));
  showButtons();
}

void RunsPage::showButtons() {
  const bool one = chosen_.size() == 1;
  const auto obstacle = [&](const char* file, const QString& without) {
    if (!one) return chosen_.empty() ? tr("Choose a run first") : tr("Choose one run alone");
    if (!read_) return tr("The run is being read");
    return chosen_[0].file(file) == nullptr ? without : QString();
  };
  const bool mapped = one && read_ && chosen_[0].file("map") != nullptr;
  const bool recorded = one && read_ && chosen_[0].file("recording") != nullptr;
  const QString being = one && chosen_[0].state == RunState::recording ? tr("It is being recorded") : QString();
  setAvailable(open_,
               mapped     ? tr("Shows the map on the Friction page")
               : recorded ? tr("Shows the recording on the Compare page")
                          : tr("Shows the run's report"),
               !being.isEmpty() ? being
               : mapped || recorded
                   ? QString()
                   : obstacle("report", tr("The run left nothing to show: its files lie in its folder")));
  setAvailable(beneath_,
               recorded && !mapped
                   ? tr("Draws the recording dashed beneath the one on the Compare page")
                   : tr("Lays the map beneath the one on the Friction page, with a ring of their differences"),
               !being.isEmpty() ? being
               : recorded       ? QString()
                                : obstacle("map", tr("The run has neither a friction map nor a recording")));
  setAvailable(report_, tr("Opens the run's report in the browser"), obstacle("report", tr("The run has no report")));
  setAvailable(csv_, tr("Writes the whole recording as CSV"),
               !being.isEmpty() ? being : obstacle("recording", tr("The run has no recording")));
  setAvailable(compare_, chosen_.size() == 2, tr("What has changed between the two, beyond their intervals"),
               tr("Choose two runs, with Ctrl or Shift"));
}

void RunsPage::open() {
  if (!open_->isEnabled()) return;
  if (chosen_[0].file("map") != nullptr) {
    runs_.readMap(chosen_[0].id, this, [this](const KeptMap& map) {
      maps_.open(map);
      emit pageAsked("frictionPage");
    });
    return;
  }
  runs_.read(chosen_[0].id, this, [this](const KeptRun& kept) {
    if (kept.run.file("recording") == nullptr) return openReport();
    comparison_.openRecording(kept.pathOf("recording"));
    emit pageAsked("comparePage");
  });
}

void RunsPage::layBeneath() {
  if (chosen_[0].file("map") == nullptr) {
    runs_.read(chosen_[0].id, this, [this](const KeptRun& kept) {
      comparison_.layBeneath(kept.pathOf("recording"),
                             kept.run.name.empty() ? timeInWords(kept.run) : QString::fromStdString(kept.run.name));
      emit pageAsked("comparePage");
    });
    return;
  }
  runs_.readMap(chosen_[0].id, this, [this](const KeptMap& map) {
    maps_.layBeneath(map);
    emit pageAsked("frictionPage");
  });
}

void RunsPage::openReport() {
  runs_.read(chosen_[0].id, this, [](const KeptRun& kept) {
    if (kept.run.file("report") != nullptr) QDesktopServices::openUrl(QUrl::fromLocalFile(kept.pathOf("report")));
  });
}

void RunsPage::saveCsv() {
  files_.ask(this, {tr("Save the run's recording"), tr("Recording (*.csv)"), "recording.csv", true},
             [this, id = chosen_[0].id](const QString& path) { runs_.saveCsv(id, path); });
}

void RunsPage::compareChosen() {
  runs_.compare(chosen_[0].id, chosen_[1].id, this,
                [this](const RunComparison& comparison) { showComparison(comparison); });
}

void RunsPage::showComparison(const RunComparison& comparison) {
  compared_->show(comparison);
  table_->hide();
  compared_->QWidget::show();
}

QVariant RunsPage::kept() const {
  return compared_->isHidden() ? QVariant() : QVariant::fromValue(*compared_->comparison());
}

void RunsPage::take(const QVariant& kept) {
  showComparison(kept.value<RunComparison>());
}

}  // namespace breakaway
