#include "widgets/profile_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "widgets/controls.h"
#include "widgets/look.h"
#include "widgets/table.h"

namespace breakaway {

ProfilePanel::ProfilePanel(Connection& connection, const BenchRuns& bench, Messages& messages, FileChooser& files,
                           QWidget* parent)
    : QWidget(parent), files_(files), profile_(connection, bench, messages) {
  auto* column = columnIn(this, 8);
  column->addWidget(heading(this, tr("Profile")));
  auto* buttons = new QHBoxLayout;
  save_ = pushButton(this, "saveProfileButton", tr("Save…"));
  open_ = pushButton(this, "openProfileButton", tr("Compare with…"));
  restore_ = pushButton(this, "restoreProfileButton", tr("Restore ticked"));
  for (QPushButton* one : {save_, open_, restore_}) buttons->addWidget(one);
  buttons->addStretch(1);
  column->addLayout(buttons);
  source_ = explanation(this, {}, "profileSource");
  column->addWidget(source_);
  table_ = readTable(this, "profileTable", tr("Parameters that differ"),
                     {tr("Parameter"), tr("Board"), tr("Profile"), tr("Accepted")});
  column->addWidget(table_, 100);
  column->addStretch(1);
  connect(save_, &QPushButton::clicked, this, [this] {
    files_.ask(this, {tr("Save the profile"), tr("Profile (*.profile.json)"), "board.profile.json", true},
               [this](const QString& path) { profile_.save(path); });
  });
  connect(open_, &QPushButton::clicked, this, [this] {
    files_.ask(this, {tr("Compare with a profile"), tr("Profile (*.profile.json *.json)"), {}, false},
               [this](const QString& path) { profile_.open(path); });
  });
  connect(restore_, &QPushButton::clicked, this, [this] { profile_.restore(ticked()); });
  connect(&profile_, &ProfileComparison::changed, this, &ProfilePanel::fill);
  connect(table_, &QTableWidget::itemActivated, this, [this](const QTableWidgetItem* item) {
    auto* name = table_->item(item->row(), 0);  // Enter, since Space is STOP
    name->setCheckState(name->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
  });
  connect(table_, &QTableWidget::itemChanged, this, &ProfilePanel::showAvailable);
  connect(&connection, &Connection::changed, this, &ProfilePanel::showAvailable);
  frameTicks();
  fill();
}

/// The style draws the frame of a tick box a little darker than this colour, which in a dark theme
/// nobody could see.
void ProfilePanel::frameTicks() {
  QPalette visible = palette();
  const Look look = Look::of(visible);
  if (look.dark) visible.setColor(QPalette::Window, look.muted);
  table_->setPalette(visible);
}

void ProfilePanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (table_ != nullptr && event->type() == QEvent::PaletteChange) frameTicks();
}

void ProfilePanel::fill() {
  const QSignalBlocker quiet(table_);
  int row = 0;
  table_->setRowCount(0);
  for (const ProfileComparison::Row& one : profile_.rows()) {
    if (one.values.same && one.accepted.isEmpty()) continue;
    table_->setRowCount(row + 1);
    fillRow(*table_, row,
            {QString::fromStdString(one.values.name), QString::fromStdString(one.values.here),
             QString::fromStdString(one.values.there), one.accepted});
    auto* name = table_->item(row, 0);
    name->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
    name->setCheckState(one.values.same ? Qt::Unchecked : Qt::Checked);
    ++row;
  }
  const QString source = profile_.source();
  source_->setText(source.isEmpty() ? QString() : row == 0 ? tr("%1: nothing differs").arg(source) : source);
  source_->setVisible(!source.isEmpty());
  table_->setVisible(row > 0);
  showAvailable();
}

QStringList ProfilePanel::ticked() const {
  QStringList names;
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto* name = table_->item(row, 0);
    if (name != nullptr && name->checkState() == Qt::Checked) names << name->text();
  }
  return names;
}

void ProfilePanel::showAvailable() {
  setAvailable(save_, tr("Write gains, limits and the friction table of this board to a file"), profile_.obstacle());
  setAvailable(open_, tr("Show where a saved profile differs from the board; nothing is written"), profile_.obstacle());
  QString nothing = profile_.obstacle();
  if (nothing.isEmpty() && profile_.source().isEmpty()) nothing = tr("No profile is open: compare with one first");
  if (nothing.isEmpty() && ticked().isEmpty()) nothing = tr("No parameter is ticked");
  setAvailable(restore_, tr("Ask the board for the profile's values of the ticked parameters"), nothing);
}

}  // namespace breakaway
