#include "widgets/log_drawer.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

namespace {
constexpr int drawerHeight = 168, lineHeight = 24;
}  // namespace

LogDrawer::LogDrawer(Messages& messages, QWidget* parent) : QWidget(parent), messages_(messages) {
  setObjectName("logDrawer");
  setFixedHeight(drawerHeight);
  auto* column = columnIn(this, 8, {16, 8, 16, 8});
  auto* row = new QHBoxLayout;
  row->addWidget(section(this, tr("Log")));
  row->addStretch(1);
  troubleOnly_ = chipButton(this, "logTroubleOnly", tr("Trouble only"), tr("Show only what failed"));
  auto* copyAll = pushButton(this, "logCopy", tr("Copy"), tr("Copy the lines that are shown, with their times"));
  auto* close = pushButton(this, "logClose", tr("Close"), tr("Close the log"));
  for (QWidget* button : std::initializer_list<QWidget*>{troubleOnly_, copyAll, close}) row->addWidget(button);
  column->addLayout(row);
  table_ = new QTableWidget(0, 2, this);
  table_->setObjectName("logTable");
  table_->setAccessibleName(tr("What was said so far"));
  table_->setToolTip(tr("What was said so far, the newest on top; a chosen line is shown whole"));
  table_->horizontalHeader()->hide();
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setColumnWidth(0, 80);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(lineHeight);
  table_->setShowGrid(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  column->addWidget(table_, 1);
  connect(troubleOnly_, &QPushButton::toggled, this, &LogDrawer::fill);
  connect(copyAll, &QPushButton::clicked, this, &LogDrawer::copy);
  connect(close, &QPushButton::clicked, this, &LogDrawer::closed);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int now, int, int before) { unfold(now, before); });
  connect(&messages_, &Messages::said, this, &LogDrawer::take);
  onNewLook(this, [this] { fill(); });
  fill();
}

void LogDrawer::take() {
  addOnTop(messages_.lines().back());
  if (isVisible()) messages_.markRead();
}

void LogDrawer::addOnTop(const Messages::Line& line) {
  if (troubleOnly_->isChecked() && !line.trouble) return;
  const Look& look = Look::of(palette());
  table_->insertRow(0);
  auto* time = new QTableWidgetItem(line.time);
  auto* text = new QTableWidgetItem(line.text);
  time->setForeground(look.muted);
  text->setForeground(line.trouble ? look.trouble : look.ink);
  text->setToolTip(line.text);
  table_->setItem(0, 0, time);
  table_->setItem(0, 1, text);
  if (table_->rowCount() > static_cast<int>(Messages::mostLines)) table_->removeRow(table_->rowCount() - 1);
}

void LogDrawer::fill() {
  table_->setRowCount(0);
  for (const Messages::Line& line : messages_.lines()) addOnTop(line);
}

/// A chosen line has all the room that it needs.
void LogDrawer::unfold(int row, int before) {
  if (before >= 0 && before < table_->rowCount()) table_->setRowHeight(before, lineHeight);
  if (row < 0) return;
  table_->resizeRowToContents(row);
  table_->setRowHeight(row, std::max(lineHeight, table_->rowHeight(row)));
}

void LogDrawer::showLine(const QString& text) {
  for (int row = 0; row < table_->rowCount(); ++row) {
    if (table_->item(row, 1)->text() != text) continue;
    table_->setCurrentCell(row, 1);
    table_->scrollToItem(table_->item(row, 1));
    return;
  }
  if (!troubleOnly_->isChecked()) return;
  troubleOnly_->setChecked(false);  // it hid the line
  showLine(text);
}

void LogDrawer::copy() const {
  QStringList text;
  for (int row = 0; row < table_->rowCount(); ++row)
    text << table_->item(row, 0)->text() + "  " + table_->item(row, 1)->text();
  QApplication::clipboard()->setText(text.join('\n'));
}

void LogDrawer::showEvent(QShowEvent* event) {
  messages_.markRead();
  QWidget::showEvent(event);
}

}  // namespace breakaway
