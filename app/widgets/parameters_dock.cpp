#include "widgets/parameters_dock.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTableWidget>
#include <QVBoxLayout>

#include "session/profile_comparison.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/setting_words.h"
#include "widgets/table.h"

namespace breakaway {

namespace {

enum Column { tickColumn, nameColumn, boardColumn, editedColumn, beforeColumn, profileColumn, rangeColumn };
constexpr int columnWidths[] = {24, 0, 60, 68, 66, 66, 82};  // the name takes what is left
constexpr int digits = 4, mostDigits = 9, noteLines = 4, applyWidth = 144;
constexpr int wide_px = 652, narrow_px = 430, wideFrom_px = 1700;  // the dock; from this window on it is wide

/// As many digits as tell it from what the board has.
QString valueText(double value, double other) {
  int enough = digits;
  if (!sameSetting(value, other))
    while (enough < mostDigits && plainText(value, enough) == plainText(other, enough)) ++enough;
  return plainText(value, enough);
}

/// The cell without tick and colours. It stays the same item, since its own change may be what asks for this.
QTableWidgetItem* plainCell(QTableWidget& table, int row, int column) {
  QTableWidgetItem* item = table.item(row, column);
  if (item == nullptr) {
    item = new QTableWidgetItem;
    item->setData(Qt::TextAlignmentRole, table.horizontalHeaderItem(column)->data(Qt::TextAlignmentRole));
    table.setItem(row, column, item);
  }
  for (const int role : {Qt::ForegroundRole, Qt::BackgroundRole, Qt::FontRole, Qt::CheckStateRole})
    item->setData(role, {});
  return item;
}

}  // namespace

ParametersDock::ParametersDock(Connection& connection, SettingsEdits& edits, FileChooser& files, QWidget* parent)
    : QWidget(parent), connection_(connection), edits_(edits), files_(files) {
  setObjectName("parametersDock");
  setProperty("role", "rail");
  setAttribute(Qt::WA_StyledBackground);
  setFixedWidth(narrow_px);
  auto* column = columnIn(this, 8, {16, 12, 16, 12});
  column->addWidget(buildHead());
  column->addWidget(buildTools());
  buildTable();
  column->addWidget(table_, 1);
  column->addWidget(buildFoot());
  connect(&edits_, &SettingsEdits::changed, this, &ParametersDock::fill);
  connect(&connection_, &Connection::changed, this, &ParametersDock::fill);
  onNewLook(this, [this] { fill(); });
  fill();
}

QWidget* ParametersDock::buildHead() {
  auto* group = new QWidget(this);
  auto* row = rowIn(group, 8);
  row->addWidget(section(group, tr("Parameters")));
  row->addStretch(1);
  auto* close = pushButton(group, "parametersClose", tr("Close"), tr("Close the parameters; edits stay (Ctrl+P)"));
  row->addWidget(close);
  connect(close, &QPushButton::clicked, this, &ParametersDock::closed);
  return group;
}

QWidget* ParametersDock::buildTools() {
  auto* group = new QWidget(this);
  auto* column = columnIn(group, 8);
  auto* row = new QHBoxLayout;
  auto* profile = new QHBoxLayout;
  source_ = new ElidedLabel("parametersSource", group);
  source_->setFont(typed(Type::caption));
  undo_ = pushButton(group, "parametersUndo", tr("Undo"));
  redo_ = pushButton(group, "parametersRedo", tr("Redo"));
  revert_ = pushButton(group, "parametersRevert", tr("Revert"));
  revertAll_ = pushButton(group, "parametersRevertAll", tr("Revert all"));
  open_ = pushButton(group, "parametersOpenProfile", tr("Profile…"));
  take_ = pushButton(group, "parametersTakeProfile", tr("Take ticked"));
  for (QPushButton* one : {undo_, redo_, revert_, revertAll_}) row->addWidget(one);
  row->addStretch(1);
  for (QPushButton* one : {open_, take_}) profile->addWidget(one);
  profile->addStretch(1);
  for (QHBoxLayout* one : {row, profile}) {
    one->setSpacing(4);
    column->addLayout(one);
  }
  column->addWidget(source_);
  connect(undo_, &QPushButton::clicked, &edits_, &SettingsEdits::undo);
  connect(redo_, &QPushButton::clicked, &edits_, &SettingsEdits::redo);
  connect(revert_, &QPushButton::clicked, this, [this] { edits_.revert(settingOf(table_->currentRow())); });
  connect(revertAll_, &QPushButton::clicked, &edits_, &SettingsEdits::revertAll);
  connect(open_, &QPushButton::clicked, this, [this] {
    files_.ask(this, {tr("Lay a profile beside the board"), tr("Profile (*.profile.json *.json)"), {}, false},
               [this](const QString& path) { edits_.openProfile(path); });
  });
  connect(take_, &QPushButton::clicked, this, [this] { edits_.takeFromProfile(ticked()); });
  return group;
}

void ParametersDock::buildTable() {
  table_ = readTable(this, "parametersTable", tr("The board's settings"),
                     {QString(), tr("Setting"), tr("Board"), tr("Edited"), tr("At first"), tr("Profile"), tr("Range")},
                     {nameColumn});
  table_->setToolTip(tr("F2 or a double click edits; nothing is sent before Apply"));
  table_->setRowCount(static_cast<int>(profileParameters().size()));
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::AnyKeyPressed);
  // Only once columns have their widths: as long as nobody sees the table, they don't.
  rowsSoon_.setSingleShot(true);
  rowsSoon_.setInterval(0);
  connect(&rowsSoon_, &QTimer::timeout, table_, [this] {
    if (isVisible()) table_->resizeRowsToContents();
  });
  QHeaderView* header = table_->horizontalHeader();
  for (int at = 0; at < table_->columnCount(); ++at) {
    if (at == nameColumn) continue;
    header->setSectionResizeMode(at, QHeaderView::Fixed);
    table_->setColumnWidth(at, columnWidths[at]);
  }
  // A name that has no room in one line takes two.
  table_->verticalHeader()->setMinimumSectionSize(table_->verticalHeader()->defaultSectionSize());
  connect(header, &QHeaderView::sectionResized, this, [this](int resized) {
    if (resized == nameColumn) rowsSoon_.start();
  });
  // Rows that come to need a scroll bar leave names less room.
  connect(table_->verticalScrollBar(), &QScrollBar::rangeChanged, &rowsSoon_, qOverload<>(&QTimer::start));
  table_->horizontalHeaderItem(beforeColumn)
      ->setToolTip(tr("What the board had when it was connected; boards don't say what their defaults are"));
  connect(table_, &QTableWidget::cellChanged, this, &ParametersDock::takeCell);
  connect(table_, &QTableWidget::currentCellChanged, this, [this] {
    showAvailable();
    explain();
  });
  connect(table_, &QTableWidget::itemActivated, this, [this](const QTableWidgetItem* item) {
    if (item->column() <= nameColumn) toggle(item->row());  // Enter, since Space is STOP
    if (item->column() == editedColumn && (item->flags() & Qt::ItemIsEditable))
      table_->editItem(table_->item(item->row(), editedColumn));
  });
}

QWidget* ParametersDock::buildFoot() {
  auto* group = new QWidget(this);
  auto* row = rowIn(group, 16);
  note_ = explanation(group, {}, "parametersNote");
  note_->setFixedHeight(noteLines * note_->fontMetrics().lineSpacing());
  note_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  apply_ = pushButton(group, "parametersApply", tr("Apply ticked"));
  apply_->setProperty("role", "primary");
  apply_->setFixedWidth(applyWidth);
  row->addWidget(note_, 1);
  row->addWidget(apply_, 0, Qt::AlignTop);
  connect(apply_, &QPushButton::clicked, this, [this] { edits_.apply(ticked()); });
  return group;
}

void ParametersDock::fitIn(int window_px) {
  narrow_ = window_px < wideFrom_px;
  setFixedWidth(narrow_ ? narrow_px : wide_px);
  showColumns();
}

void ParametersDock::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  rowsSoon_.start();
}

void ParametersDock::showColumns() {
  table_->setColumnHidden(beforeColumn, narrow_);
  table_->setColumnHidden(rangeColumn, narrow_);
  table_->setColumnHidden(profileColumn, narrow_ && !edits_.profile());
}

SettingsEdits::Setting ParametersDock::settingOf(int row) const {
  return profileParameters()[static_cast<size_t>(row)].value;
}

bool ParametersDock::canTick(int row) const {
  return edits_.isEdited(settingOf(row)) || edits_.differsFromProfile(settingOf(row));
}

void ParametersDock::fill() {
  const QSignalBlocker quiet(table_);
  for (int row = 0; row < table_->rowCount(); ++row) fillRow(row);
  source_->setText(edits_.profileSource());
  showColumns();
  rowsSoon_.start();
  showAvailable();
  explain();
}

void ParametersDock::fillRow(int row) {
  const Look& look = Look::of(palette());
  const SettingsEdits::Setting setting = settingOf(row);
  const SettingWords words = settingWords(setting, connection_.identity().axis);
  const SettingRange range = connection_.rangeOf(setting);
  const bool edited = edits_.isEdited(setting), differs = edits_.differsFromProfile(setting);
  const double board = words.scale * edits_.accepted().*setting;
  const auto text = [&](const ControllerSettings& of) { return valueText(words.scale * of.*setting, board); };
  QStringList cells{{}, words.titleWithUnit(), tr("–"), {}, {}, {}, {}};
  if (range.offered) {
    cells = {{},
             words.titleWithUnit(),
             plainText(board, digits),
             text(edits_.edited()),
             text(edits_.before()),
             edits_.profile() ? text(edits_.profile()->settings) : QString(),
             words.rangeText(range)};
  } else if (connection_.connected()) {
    cells[boardColumn] = tr("not offered");
  }
  const QString tip = !connection_.connected() ? tr("No board is connected")
                      : range.offered          ? words.meaning
                                               : tr("This board keeps the setting to itself: its maker's tool sets it");
  for (int at = 0; at < table_->columnCount(); ++at) {
    QTableWidgetItem* item = plainCell(*table_, row, at);
    item->setText(cells[at]);
    item->setToolTip(tip);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    if (!range.offered) item->setForeground(look.disabled);
  }
  auto* tick = table_->item(row, tickColumn);
  if (!canTick(row)) unticked_.erase(row);
  if (canTick(row)) {
    tick->setFlags(tick->flags() | Qt::ItemIsUserCheckable);
    tick->setCheckState(unticked_.contains(row) ? Qt::Unchecked : Qt::Checked);
  }
  auto* value = table_->item(row, editedColumn);
  if (range.offered) value->setFlags(value->flags() | Qt::ItemIsEditable);
  if (edited) {
    value->setBackground(look.warningBack);
    value->setForeground(look.warning);
    value->setFont(typed(Type::body, true));
  }
  if (differs) {
    table_->item(row, profileColumn)->setForeground(look.accentLine);
    table_->item(row, profileColumn)->setFont(typed(Type::body, true));
  }
}

void ParametersDock::takeCell(int row, int column) {
  const QTableWidgetItem* item = table_->item(row, column);
  if (column == tickColumn) tick(row, item->checkState() == Qt::Checked);
  if (column == editedColumn) takeText(row, item->text());
}

void ParametersDock::tick(int row, bool ticked) {
  if (ticked) {
    unticked_.erase(row);
  } else {
    unticked_.insert(row);
  }
  showAvailable();
}

void ParametersDock::toggle(int row) {
  if (!canTick(row)) return;
  auto* tick = table_->item(row, tickColumn);
  tick->setCheckState(tick->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
}

void ParametersDock::takeText(int row, const QString& text) {
  const SettingsEdits::Setting setting = settingOf(row);
  const SettingWords words = settingWords(setting, connection_.identity().axis);
  const std::optional<double> value = numberIn(text);
  const bool taken = value && edits_.set(setting, *value / words.scale);
  fill();
  if (taken) return;
  explain(tr("%1: %2 is not within %3 %4; the value stays as it was")
              .arg(words.title, text.trimmed(), words.rangeText(connection_.rangeOf(setting)), words.unit));
}

std::vector<SettingsEdits::Setting> ParametersDock::ticked() const {
  std::vector<SettingsEdits::Setting> chosen;
  for (int row = 0; row < table_->rowCount(); ++row) {
    if (canTick(row) && !unticked_.contains(row)) chosen.push_back(settingOf(row));
  }
  return chosen;
}

void ParametersDock::showAvailable() {
  const QString none = connection_.connected() ? QString() : tr("No board is connected");
  const auto because = [&none](bool possible, const QString& otherwise) {
    return !none.isEmpty() ? none : possible ? QString() : otherwise;
  };
  int toSend = 0, toTake = 0;
  for (const auto setting : ticked()) {
    toSend += edits_.isEdited(setting) ? 1 : 0;
    toTake += edits_.differsFromProfile(setting) ? 1 : 0;
  }
  const int row = table_->currentRow();
  setAvailable(undo_, tr("Take the last edit back"), because(edits_.canUndo(), tr("There is no edit to take back")));
  setAvailable(redo_, tr("Make the edit again that was taken back"),
               because(edits_.canRedo(), tr("No edit was taken back")));
  setAvailable(revert_, tr("Back to what the board has, in the chosen row"),
               because(row >= 0 && edits_.isEdited(settingOf(row)), tr("The chosen row is not edited")));
  setAvailable(revertAll_, tr("Back to what the board has, in every row"),
               because(edits_.count() > 0, tr("Nothing is edited")));
  setAvailable(open_, tr("Show what a saved profile holds beside the board; nothing is changed by it"),
               profileObstacle(connection_));
  setAvailable(take_, tr("Edit the ticked rows to what the profile holds; Apply sends them"),
               because(toTake > 0, edits_.profile() ? tr("No row that differs from the profile is ticked")
                                                    : tr("No profile is open")));
  setAvailable(apply_, tr("Send the ticked edits to the board; what it accepts is shown"),
               because(toSend > 0, edits_.count() > 0 ? tr("No edited row is ticked")
                                                      : tr("Nothing is edited: the board has what is shown")));
}

void ParametersDock::explain(const QString& trouble) {
  dressAs(note_, "tone", trouble.isEmpty() ? QString() : "trouble");
  if (!trouble.isEmpty()) return note_->setText(trouble);
  const int row = table_->currentRow();
  if (!connection_.connected() || row < 0) {
    note_->setText(connection_.connected() ? tr("Choose a row to read what it is; F2 or a double click edits it.")
                                           : tr("No board is connected."));
    return;
  }
  const SettingWords words = settingWords(settingOf(row), connection_.identity().axis);
  const SettingRange range = connection_.rangeOf(settingOf(row));
  note_->setText(range.offered ? tr("%1: %2 %3 %4.").arg(words.title, words.meaning, words.rangeText(range), words.unit)
                               : tr("%1: this board keeps it to itself; its maker's tool sets it.").arg(words.title));
}

}  // namespace breakaway
