#include "pages/report_page.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "base/atomic_file.h"
#include "report/commission_report.h"
#include "report/diagnosis_report.h"
#include "session/bench_runs.h"
#include "session/comparison.h"
#include "session/language.h"
#include "session/messages.h"
#include "widgets/controls.h"

namespace breakaway {

namespace {

constexpr int drawnSoon_ms = 250, remarksHeight = 84, chapterHeight = 26, figureWidth = 680;

/// The report's HTML, by way of a folder that goes again.
template <class Draft>
Result<std::string> htmlOf(const Draft& draft) {
  const QTemporaryDir place;
  if (auto written = draft(place.path().toStdString()); !written) return written.error();
  return readFile(place.filePath("report.html").toStdString());
}

}  // namespace

ReportPage::ReportPage(const BenchRuns& bench, const Comparison& comparison, Messages& messages, FileChooser& files,
                       QWidget* parent)
    : Page("reportPage", tr("Report"), parent),
      bench_(bench),
      comparison_(comparison),
      messages_(messages),
      files_(files) {
  setHead(tr("Report"), tr("What was measured or compared, as a file to hand over."));
  friction_ = addPrimary("writeFrictionReportButton", tr("Write friction report…"));
  compared_ = addSecondary("writeComparisonReportButton", tr("Write comparison…"), 160);
  paper_ = addSecondary("writePaperButton", tr("Write as PDF…"), 128);
  open_ = addSecondary("openReportButton", tr("Open the last one"), 144);
  settings()->addWidget(buildChoice());
  settings()->addWidget(buildWords());
  settings()->addStretch(1);
  text_ = new QTextBrowser(this);
  text_->setObjectName("reportPreview");
  text_->setAccessibleName(tr("Preview of the report"));
  text_->setToolTip(tr("The report as it will be written"));
  text_->setOpenLinks(false);
  text_->document()->setDocumentMargin(16);
  picture()->addWidget(text_, 1);
  setAvailable(open_, false, {}, tr("No report was written yet"));
  soon_.setSingleShot(true);
  soon_.setInterval(drawnSoon_ms);
  pool_.setMaxThreadCount(1);
  connect(&soon_, &QTimer::timeout, this, &ReportPage::preview);
  connect(friction_, &QPushButton::clicked, this, &ReportPage::writeFriction);
  connect(compared_, &QPushButton::clicked, this, &ReportPage::writeComparison);
  connect(paper_, &QPushButton::clicked, this, &ReportPage::writePaper);
  connect(open_, &QPushButton::clicked, this, [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(last_)); });
  connect(&bench_, &BenchRuns::knownChanged, this, &ReportPage::showAvailable);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &ReportPage::showAvailable);
  choose(Of::friction);
}

ReportPage::~ReportPage() {
  ++wanted_;  // previews need not come any more, what is being written must
  pool_.waitForDone();
}

QWidget* ReportPage::buildChoice() {
  auto* group = card(this);
  columnOf(group)->addWidget(section(group, tr("Report of")));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  ofFriction_ =
      chipButton(group, "reportOfFriction", tr("This motor"), tr("Friction, motor, and how they were measured"));
  ofComparison_ = chipButton(group, "reportOfComparison", tr("Comparison"), tr("The diagnosis of the Compare page"));
  row->addWidget(ofFriction_, 1);
  row->addWidget(ofComparison_, 1);
  columnOf(group)->addLayout(row);
  connect(ofFriction_, &QPushButton::clicked, this, [this] { choose(Of::friction); });
  connect(ofComparison_, &QPushButton::clicked, this, [this] { choose(Of::comparison); });
  return group;
}

QWidget* ReportPage::buildWords() {
  auto* group = card(this);
  columnOf(group)->addWidget(section(group, tr("For whom")));
  customer_ = new QLineEdit(group);
  customer_->setObjectName("reportCustomer");
  customer_->setAccessibleName(tr("Customer"));
  customer_->setPlaceholderText(tr("Customer"));
  customer_->setToolTip(tr("Stands below the report's title"));
  columnOf(group)->addWidget(customer_);
  remarks_ = new QPlainTextEdit(group);
  remarks_->setObjectName("reportRemarks");
  remarks_->setAccessibleName(tr("Remarks"));
  remarks_->setPlaceholderText(tr("Remarks"));
  remarks_->setToolTip(tr("Stand below the customer's name"));
  remarks_->setTabChangesFocus(true);
  remarks_->setFixedHeight(remarksHeight);
  columnOf(group)->addWidget(remarks_);
  language_ = new QComboBox(group);
  language_->setObjectName("reportLanguage");
  language_->setAccessibleName(tr("Language of the report"));
  language_->setToolTip(tr("The language in which the report is written; files that programs read stay as they are"));
  language_->addItem(tr("In the window's language"), "");
  language_->addItem(tr("In English"), "en");
  language_->addItem(tr("In German"), "de");
  columnOf(group)->addWidget(language_);
  columnOf(group)->addWidget(section(group, tr("Chapters")));
  chapters_ = new QListWidget(group);
  chapters_->setObjectName("reportChapters");
  chapters_->setAccessibleName(tr("Chapters"));
  chapters_->setToolTip(tr("Which chapters are written; Enter ticks one"));
  chapters_->setMinimumHeight(140);
  columnOf(group)->addWidget(chapters_);
  connect(customer_, &QLineEdit::textChanged, &soon_, qOverload<>(&QTimer::start));
  connect(remarks_, &QPlainTextEdit::textChanged, &soon_, qOverload<>(&QTimer::start));
  connect(language_, &QComboBox::currentIndexChanged, &soon_, qOverload<>(&QTimer::start));
  connect(chapters_, &QListWidget::itemChanged, &soon_, qOverload<>(&QTimer::start));
  connect(chapters_, &QListWidget::itemActivated, this, [](QListWidgetItem* item) {
    item->setCheckState(item->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
  });
  return group;
}

void ReportPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  soon_.start();
}

/// Where four buttons have no room, that of what was written before goes.
void ReportPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  open_->setVisible(!narrow());
}

void ReportPage::choose(Of of) {
  if (of_ != of) showChapters({});
  of_ = of;
  ofFriction_->setChecked(of == Of::friction);
  ofComparison_->setChecked(of == Of::comparison);
  showAvailable();
}

void ReportPage::showAvailable() {
  const bool friction = bench_.known().knows(Known::motor), compared = comparison_.diagnosis().has_value();
  const QString nothing = tr("Nothing was measured yet"), undiagnosed = tr("Nothing was diagnosed yet");
  setAvailable(friction_, friction, tr("Write one HTML file"), nothing);
  setAvailable(compared_, compared, tr("Choose a folder; it is created when it is new"), undiagnosed);
  const bool chosen = of_ == Of::friction ? friction : compared;
  setAvailable(paper_, chosen, tr("Write what is shown as A4 pages"), of_ == Of::friction ? nothing : undiagnosed);
  if (last_.isEmpty()) {
    setState({StepMark::open, friction || compared ? tr("can be written") : tr("nothing yet")});
  } else {
    setState({StepMark::done, tr("written")});
  }
  soon_.start();
}

Catalogue ReportPage::words() const {
  const QString chosen = language_->currentData().toString();
  return wordsOf(chosen.isEmpty() ? spokenLanguage() : languageOf(chosen));
}

ReportPage::Draft ReportPage::draft() const {
  if (of_ == Of::friction) {
    if (!bench_.known().knows(Known::motor)) return {};
    return [known = bench_.known(), words = words()](const std::string& folder) {
      return writeReport(known, false, folder + "/report.html", words);
    };
  }
  if (!comparison_.diagnosis() || !comparison_.bench() || !comparison_.recording()) return {};
  std::vector<Recording> heldout;
  if (comparison_.heldout()) heldout.push_back(*comparison_.heldout());
  return [diagnosis = *comparison_.diagnosis(), bench = *comparison_.bench(), recording = *comparison_.recording(),
          heldout, words = words()](const std::string& folder) {
    return writeDiagnosisFolder(diagnosis, bench, {recording}, heldout, folder, words);
  };
}

ReportEdit ReportPage::edit() const {
  ReportEdit edit{customer_->text().trimmed().toStdString(), remarks_->toPlainText().trimmed().toStdString(), {}};
  for (int row = 0; row < chapters_->count(); ++row) {
    if (chapters_->item(row)->checkState() == Qt::Unchecked)
      edit.leftOut.push_back(chapters_->item(row)->text().toStdString());
  }
  return edit;
}

/// Made beside the window's thread; only the newest one is shown.
void ReportPage::preview() {
  if (!isVisible()) return;
  const Draft draft = this->draft();
  const unsigned mine = ++wanted_;
  if (!draft) {
    text_->setPlainText(of_ == Of::friction
                            ? tr("Nothing was measured yet. A sweep on the Friction page fills this report.")
                            : tr("Nothing was diagnosed yet. Diagnose on the Compare page fills this report."));
    return showChapters({});
  }
  pool_.start([this, mine, draft, edit = edit()] {
    if (mine != wanted_) return;
    const auto html = htmlOf(draft);
    const auto report = html ? Result<DrawnReport>(drawn(*html, edit, figureWidth)) : Result<DrawnReport>(html.error());
    QMetaObject::invokeMethod(
        this, [this, mine, report] { showPreview(mine, report); }, Qt::QueuedConnection);
  });
}

void ReportPage::showPreview(unsigned number, const Result<DrawnReport>& report) {
  if (number != wanted_) return;
  if (!report) return text_->setPlainText(inLanguage(report.error().said()));
  const int at = text_->verticalScrollBar()->value();
  fill(*text_->document(), *report);
  text_->verticalScrollBar()->setValue(at);
  showChapters(report->chapters);
}

/// What was unticked stays so, as long as the chapters are the same, in whatever language.
void ReportPage::showChapters(const QStringList& chapters) {
  QStringList before;
  std::vector<Qt::CheckState> ticks;
  for (int row = 0; row < chapters_->count(); ++row) {
    before << chapters_->item(row)->text();
    ticks.push_back(chapters_->item(row)->checkState());
  }
  if (before == chapters) return;
  if (before.size() != chapters.size()) ticks.assign(static_cast<size_t>(chapters.size()), Qt::Checked);
  // What is shown was made with the names of the other language.
  if (std::find(ticks.begin(), ticks.end(), Qt::Unchecked) != ticks.end()) soon_.start();
  const QSignalBlocker quiet(chapters_);
  chapters_->clear();
  for (const QString& one : chapters) {
    auto* item = new QListWidgetItem(one, chapters_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(ticks[static_cast<size_t>(chapters_->count()) - 1]);
    item->setSizeHint({0, chapterHeight});
  }
}

void ReportPage::writeFriction() {
  choose(Of::friction);
  files_.ask(this, {tr("Write the friction report"), tr("Report (*.html)"), "friction.html", true},
             [this](const QString& path) { write(draft(), path); });
}

void ReportPage::writeComparison() {
  choose(Of::comparison);
  FileQuestion question{tr("Write the comparison's report into a folder"), {}, {}, true};
  question.folder = true;
  files_.ask(this, question, [this](const QString& folder) {
    const Draft whole = draft();
    if (!whole) return;
    ++writing_;
    pool_.start([this, whole, folder, edit = edit()] {
      auto done = whole(folder.toStdString());
      const std::string report = folder.toStdString() + "/report.html";
      const auto html = done ? readFile(report) : Result<std::string>(done.error());
      if (html) done = writeFile(report, editedReport(*html, edit));
      QMetaObject::invokeMethod(
          this, [this, done, report] { written(done, QString::fromStdString(report)); }, Qt::QueuedConnection);
    });
  });
}

void ReportPage::writePaper() {
  files_.ask(this, {tr("Write the report as PDF"), tr("Report (*.pdf)"), "report.pdf", true},
             [this](const QString& path) { write(draft(), path); });
}

/// As PDF where the name says so, else as HTML.
void ReportPage::write(const Draft& draft, const QString& path) {
  if (!draft) return;
  ++writing_;
  pool_.start([this, draft, path, edit = edit()] {
    const auto html = htmlOf(draft);
    Result<void> done = html ? Result<void>() : Result<void>(html.error());
    if (done && path.endsWith(".pdf", Qt::CaseInsensitive)) {
      done = writePdf(drawn(*html, edit, figureWidth), path.toStdString());
    } else if (done) {
      done = writeFile(path.toStdString(), editedReport(*html, edit));
    }
    QMetaObject::invokeMethod(
        this, [this, done, path] { written(done, path); }, Qt::QueuedConnection);
  });
}

void ReportPage::written(const Result<void>& result, const QString& report) {
  --writing_;
  if (!result) {
    messages_.warn(result.error());
    return;
  }
  messages_.say(tr("Written: %1").arg(report));
  offerToOpen(report);
}

void ReportPage::offerToOpen(const QString& report) {
  last_ = report;
  setAvailable(open_, true, tr("Open %1").arg(report), {});
  showAvailable();
}

QVariant ReportPage::kept() const {
  QStringList chapters, ticked;
  for (int row = 0; row < chapters_->count(); ++row) {
    chapters << chapters_->item(row)->text();
    if (chapters_->item(row)->checkState() == Qt::Checked) ticked << chapters.back();
  }
  return QVariantList{last_, chapters, ticked};
}

void ReportPage::take(const QVariant& kept) {
  const QVariantList parts = kept.toList();
  const QStringList ticked = parts.value(2).toStringList();
  showChapters(parts.value(1).toStringList());
  for (int row = 0; row < chapters_->count(); ++row) {
    QListWidgetItem* item = chapters_->item(row);
    item->setCheckState(ticked.contains(item->text()) ? Qt::Checked : Qt::Unchecked);
  }
  if (const QString last = parts.value(0).toString(); !last.isEmpty()) offerToOpen(last);
}

}  // namespace breakaway
