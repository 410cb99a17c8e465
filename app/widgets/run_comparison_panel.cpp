#include "widgets/run_comparison_panel.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "widgets/comparison_words.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"

namespace breakaway {

RunComparisonPanel::RunComparisonPanel(FileChooser& files, QWidget* parent) : QWidget(parent), files_(files) {
  auto* column = columnIn(this, 8);
  auto* head = new QHBoxLayout;
  head->setSpacing(8);
  title_ = new ElidedLabel("runComparisonTitle", this);
  auto* report = pushButton(this, "writeRunComparisonButton", tr("Write report…"),
                            tr("One HTML file with both maps, the figures, and comparison.json, into a folder"));
  auto* back = pushButton(this, "closeRunComparisonButton", tr("Back to the list"), tr("Shows the runs again"));
  head->addWidget(title_, 1);
  head->addWidget(report);
  head->addWidget(back);
  column->addLayout(head);
  words_ = new QTextBrowser(this);
  words_->setObjectName("runComparisonWords");
  words_->setAccessibleName(tr("What has changed"));
  words_->setToolTip(tr("What has changed between the two runs; bold lies beyond the 95 % intervals"));
  column->addWidget(words_, 1);
  connect(back, &QPushButton::clicked, this, &RunComparisonPanel::closed);
  connect(report, &QPushButton::clicked, this, [this] {
    FileQuestion question{tr("Write the comparison of the runs into a folder"), {}, {}, true};
    question.folder = true;
    files_.ask(this, question, [this](const QString& folder) {
      if (comparison_) emit reportAsked(*comparison_, folder);
    });
  });
}

void RunComparisonPanel::show(const RunComparison& comparison) {
  comparison_ = comparison;
  title_->setText(titleOf(comparison));
  words_->setHtml(pageOf(comparison));
}

}  // namespace breakaway
