#include "pages/report_page.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>

#include "report/commission_report.h"
#include "report/diagnosis_report.h"
#include "session/bench_runs.h"
#include "session/comparison.h"
#include "session/messages.h"
#include "widgets/controls.h"
#include "widgets/findings_list.h"

namespace breakaway {

ReportPage::ReportPage(const BenchRuns& bench, const Comparison& comparison, Messages& messages, FileChooser& files,
                       QWidget* parent)
    : Page("reportPage", tr("Report"), "report", parent),
      bench_(bench),
      comparison_(comparison),
      messages_(messages),
      files_(files) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 12, 16, 8);
  column->setSpacing(8);
  const auto section = [&](const QString& title, const char* text, const char* button, const QString& label,
                           QLabel*& holds, QPushButton*& write) {
    column->addWidget(heading(this, title));
    holds = explanation(this, {}, text);
    holds->setMaximumWidth(760);
    write = pushButton(this, button, label);
    column->addWidget(holds);
    column->addWidget(write, 0, Qt::AlignLeft);
    column->addSpacing(10);
  };
  section(tr("Friction of this motor"), "frictionHolds", "writeFrictionReportButton", tr("Write report…"),
          frictionHolds_, friction_);
  section(tr("Comparison with a recording"), "comparisonHolds", "writeComparisonReportButton",
          tr("Write report folder…"), comparisonHolds_, compared_);
  column->addWidget(rule(this));
  open_ = pushButton(this, "openReportButton", tr("Open the last report"));
  column->addWidget(open_, 0, Qt::AlignLeft);
  column->addStretch(1);
  setAvailable(open_, false, {}, tr("No report was written yet"));
  connect(friction_, &QPushButton::clicked, this, &ReportPage::writeFriction);
  connect(compared_, &QPushButton::clicked, this, &ReportPage::writeComparison);
  connect(open_, &QPushButton::clicked, this, [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(last_)); });
  connect(&bench_, &BenchRuns::knownChanged, this, &ReportPage::showFriction);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &ReportPage::showComparison);
  showFriction();
  showComparison();
}

void ReportPage::showFriction() {
  const Commission& known = bench_.known();
  QStringList parts;
  if (known.knows(Known::motor)) parts << tr("the motor's constants");
  if (known.knows(Known::runs)) parts << tr("Coulomb and viscous averages with intervals");
  if (!known.breakaways.empty())
    parts << (known.linear() ? tr("%1 breakaways over the travel") : tr("%1 breakaways around the rotor"))
                 .arg(known.breakaways.size());
  if (known.knows(Known::map)) parts << tr("the friction map");
  if (known.compensatedRun) parts << tr("what the map is good for");
  frictionHolds_->setText(parts.isEmpty()
                              ? tr("Nothing was measured yet. A sweep on the Friction page fills this report.")
                              : tr("One HTML file with pictures: %1.").arg(parts.join(", ")));
  setAvailable(friction_, known.knows(Known::motor), tr("Write one HTML file"), tr("Nothing was measured yet"));
}

void ReportPage::showComparison() {
  const auto& diagnosis = comparison_.diagnosis();
  if (!diagnosis) {
    comparisonHolds_->setText(tr("Nothing was diagnosed yet. Diagnose on the Compare page fills this report."));
  } else {
    QStringList names;
    for (const Finding& finding : diagnosis->findings) names << effectTitle(finding.effect);
    comparisonHolds_->setText(
        tr("report.html with pictures, diagnosis.json, both models and the figures as SVG. Findings: %1.")
            .arg(names.isEmpty() ? tr("nothing is missing") : names.join(", ")));
  }
  setAvailable(compared_, diagnosis.has_value(), tr("Choose a folder; it is created when it is new"),
               tr("Nothing was diagnosed yet"));
}

void ReportPage::writeFriction() {
  files_.ask(this, {tr("Write the friction report"), tr("Report (*.html)"), "friction.html", true},
             [this](const QString& path) { written(writeReport(bench_.known(), false, path.toStdString()), path); });
}

void ReportPage::writeComparison() {
  FileQuestion question{tr("Write the comparison's report into a folder"), {}, {}, true};
  question.folder = true;
  files_.ask(this, question, [this](const QString& folder) {
    if (!comparison_.diagnosis() || !comparison_.bench() || !comparison_.recording()) return;
    std::vector<Recording> heldout;
    if (comparison_.heldout()) heldout.push_back(*comparison_.heldout());
    written(writeDiagnosisFolder(*comparison_.diagnosis(), *comparison_.bench(), {*comparison_.recording()}, heldout,
                                 folder.toStdString()),
            folder + "/report.html");
  });
}

void ReportPage::written(const Result<void>& result, const QString& report) {
  if (!result) {
    messages_.warn(result.error());
    return;
  }
  last_ = report;
  setAvailable(open_, true, tr("Open %1").arg(report), {});
  messages_.say(tr("Written: %1").arg(report));
}

}  // namespace breakaway
