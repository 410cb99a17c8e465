#include "widgets/log_panel.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "recording/columns.h"
#include "recording/import/units.h"
#include "session/language.h"
#include "widgets/column_words.h"
#include "widgets/controls.h"
#include "widgets/table.h"

namespace breakaway {

namespace {

enum Cell { name, takenAs, unit, first, why };
constexpr size_t mostRows = 500;
constexpr int choiceHeight = 34, numberWidth = 92, shortestChoice = 8, widestName = 140, besideName = 10,
              stateLines = 2, valuesWidth = 132;
constexpr qsizetype valuesSeen = 3;  // of each column in the table; its tooltip has all

/// Without the advice that only the command can follow: here it is said in the boxes.
QString withoutCommand(const Message& said) {
  QString text = inLanguage(said);
  const qsizetype command = text.indexOf("--map");
  if (command < 0) return text;
  const qsizetype advice = std::max(text.lastIndexOf(';', command), text.lastIndexOf(": ", command));
  return (advice < 0 ? text : text.left(advice)) + LogPanel::tr("; say it here");
}

/// What was found, in one line.
QString remarksOf(const LogOpening& log) {
  QStringList remarks;
  for (const Message& one : log.remarks()) remarks << withoutCommand(one);
  return remarks.join("; ");
}

/// What a technician chooses from, by the unit of the recording's column.
QStringList unitsOf(const QString& column) {
  const Column* known = columnNamed(column.toStdString());
  const std::string si = known == nullptr ? "" : known->unit;
  if (si == "s") return {"s", "ms", "us", "ns", "min"};
  if (si == "rad") return {"rad", "deg", "rev", "count", "erad", "edeg", "erev"};
  if (si == "m") return {"m", "mm", "um", "inch"};
  if (si == "rad/s") return {"rad/s", "deg/s", "rev/s", "rpm", "erpm"};
  if (si == "m/s") return {"m/s", "mm/s", "mm/min"};
  if (si == "V") return {"V", "mV"};
  if (si == "A") return {"A", "mA"};
  if (si == "Nm") return {"Nm", "mNm", "Ncm", "oz-in", "kgf cm"};
  if (si == "N") return {"N", "mN", "kgf", "lbf"};
  if (si == "°C") return {"degC", "degF", "K"};
  return {"1", "%"};
}

QStringList numbersText(const std::vector<double>& values, int digits) {
  QStringList words;
  for (const double value : values)
    words << (std::isfinite(value) ? QString::number(value, 'g', digits) : QString("–"));
  return words;
}

}  // namespace

LogPanel::LogPanel(LogOpening& log, QWidget* parent) : QWidget(parent), log_(log) {
  setObjectName("logPanel");
  auto* column = columnIn(this, 6);
  title_ = section(this, {});
  state_ = explanation(this, {}, "logState");
  state_->setMinimumHeight(stateLines * state_->fontMetrics().lineSpacing());  // the table stays where it is
  state_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  table_ = readTable(this, "logColumns", tr("Columns of the log as they are understood"),
                     {tr("Column"), tr("Taken as"), tr("Unit"), tr("First values"), tr("Why")},
                     {name, takenAs, unit, why, first});
  // All of it is seen without scrolling: the reasons take what is left, in as many lines as they need.
  QHeaderView* header = table_->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(name, QHeaderView::Fixed);
  header->setSectionResizeMode(first, QHeaderView::Fixed);
  header->setSectionResizeMode(why, QHeaderView::Stretch);
  table_->setColumnWidth(first, valuesWidth);
  table_->verticalHeader()->setMinimumSectionSize(choiceHeight);
  table_->verticalHeader()->setDefaultSectionSize(choiceHeight);
  connect(
      header, &QHeaderView::sectionResized, this,
      [this](int resized) {
        if (resized == why) table_->resizeRowsToContents();
      },
      Qt::QueuedConnection);
  column->addWidget(title_);
  column->addWidget(state_);
  column->addWidget(table_, 1);
  column->addWidget(buildNumbers());
  column->addWidget(buildSplit());
  column->addWidget(buildButtons());
  connect(&log_, &LogOpening::changed, this, &LogPanel::fill);
  fill();
}

QWidget* LogPanel::buildNumbers() {
  auto* strip = new QWidget(this);
  auto* row = rowIn(strip, 6);
  const auto add = [&](const char* objectName, const QString& label, std::optional<double> ImportMap::*number) {
    auto* edit = new QLineEdit(strip);
    edit->setObjectName(objectName);
    edit->setAccessibleName(label);
    edit->setFixedWidth(numberWidth);
    edit->setPlaceholderText(tr("from file"));
    row->addWidget(new QLabel(label, strip));
    row->addWidget(edit);
    numbers_.push_back({number, edit});
    connect(edit, &QLineEdit::editingFinished, this, [this, edit, number] {
      bool good = false;
      const double value = edit->text().toDouble(&good);
      if (good && value > 0.0) log_.say(number, value);
      if (edit->text().isEmpty()) log_.say(number, std::nullopt);
    });
  };
  add("logSampleTime", tr("Rows apart (s)"), &ImportMap::sample_time_s);
  add("logCounts", tr("Counts a turn"), &ImportMap::counts_per_rev);
  add("logPolePairs", tr("Pole pairs"), &ImportMap::pole_pairs);
  add("logGear", tr("Gear ratio"), &ImportMap::gear_ratio);
  row->addStretch(1);
  return strip;
}

QWidget* LogPanel::buildSplit() {
  auto* strip = new QWidget(this);
  auto* row = rowIn(strip, 6);
  const auto add = [strip, row](const char* objectName, const QString& label) {
    auto* box = new QComboBox(strip);
    box->setObjectName(objectName);
    box->setAccessibleName(label);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(shortestChoice);
    row->addWidget(new QLabel(label, strip));
    row->addWidget(box);
    return box;
  };
  split_ = add("logSplit", tr("Parted by"));
  part_ = add("logPart", tr("Part"));
  connect(split_, &QComboBox::activated, this,
          [this](int index) { log_.splitBy(index <= 0 ? QString() : split_->currentText()); });
  connect(part_, &QComboBox::activated, &log_, &LogOpening::takePart);
  row->addStretch(1);
  return strip;
}

void LogPanel::fillSplit() {
  QStringList names{tr("–")};
  for (const LogColumn& one : log_.columns()) {
    if (names.size() <= static_cast<qsizetype>(mostRows)) names << one.name;
  }
  const QString by = QString::fromStdString(log_.map().split);
  if (!by.isEmpty() && !names.contains(by)) names << by;
  split_->clear();
  split_->addItems(names);
  split_->setCurrentIndex(by.isEmpty() ? 0 : static_cast<int>(names.indexOf(by, 1)));
  part_->clear();
  part_->addItems(log_.parts());
  part_->setCurrentIndex(log_.parts().isEmpty() ? -1
                                                : std::min(log_.part(), static_cast<int>(log_.parts().size()) - 1));
  part_->setEnabled(!log_.parts().isEmpty());
}

QWidget* LogPanel::buildButtons() {
  auto* strip = new QWidget(this);
  auto* row = rowIn(strip, 6);
  open_ = pushButton(strip, "logOpenButton", tr("Open as a recording"));
  open_->setProperty("role", "primary");
  auto* guess = pushButton(strip, "logGuessButton", tr("As guessed"),
                           tr("Forget all that was corrected for logs with these column names"));
  auto* close = pushButton(strip, "logCloseButton", tr("Leave it"), tr("Open nothing"));
  for (QPushButton* one : {open_, guess, close}) row->addWidget(one);
  row->addStretch(1);
  connect(open_, &QPushButton::clicked, &log_, &LogOpening::accept);
  connect(guess, &QPushButton::clicked, &log_, &LogOpening::guessAgain);
  connect(close, &QPushButton::clicked, &log_, &LogOpening::close);
  return strip;
}

void LogPanel::fill() {
  title_->setText(tr("%1, as it is understood").arg(QFileInfo(log_.path()).fileName()));
  state_->setText(log_.settling()         ? tr("Reading…")
                  : !log_.fault().empty() ? withoutCommand(log_.fault())
                                          : remarksOf(log_));
  dressAs(state_, "tone", log_.settling() || log_.fault().empty() ? QString() : "trouble");
  const auto rows = static_cast<int>(std::min(log_.columns().size(), mostRows));
  if (table_->rowCount() != rows) table_->setRowCount(rows);
  for (int row = 0; row < rows; ++row) showRow(row, log_.columns()[static_cast<size_t>(row)]);
  int longest = table_->horizontalHeader()->sectionSizeHint(name);
  for (int row = 0; row < rows; ++row)
    longest = std::max(longest, table_->fontMetrics().horizontalAdvance(table_->item(row, name)->text()));
  table_->setColumnWidth(name, std::min(longest + besideName, widestName));  // a longer one is whole in its tooltip
  // Once more when the columns have their widths.
  QMetaObject::invokeMethod(table_, &QTableView::resizeRowsToContents, Qt::QueuedConnection);
  for (const Number& one : numbers_) {
    const auto& value = log_.map().*one.number;
    one.edit->setText(value ? QLocale::c().toString(*value, 'g', 10) : QString());
  }
  fillSplit();
  setAvailable(open_, tr("Opens it, and remembers what was corrected for logs with these column names"),
               log_.settling() ? tr("It is being read") : withoutCommand(log_.fault()));
}

QComboBox* LogPanel::choice(int row, int cell, const char* what, const QStringList& choices) {
  auto* box = qobject_cast<QComboBox*>(table_->cellWidget(row, cell));
  if (box == nullptr) {
    box = new QComboBox(table_);
    box->setObjectName(QString("%1%2").arg(what).arg(row));
    box->setFocusPolicy(Qt::StrongFocus);
    table_->setCellWidget(row, cell, box);
    connect(
        box, &QComboBox::activated, this, [this, row] { correct(row); }, Qt::QueuedConnection);
  }
  box->clear();
  box->addItems(choices);
  return box;
}

void LogPanel::showRow(int row, const LogColumn& column) {
  fillRow(*table_, row,
          {column.name,
           {},
           {},
           numbersText(column.first, 4).mid(0, valuesSeen).join("  "),
           column.guessed ? tr("a guess: %1").arg(withoutCommand(column.why)) : withoutCommand(column.why)});
  table_->item(row, first)->setToolTip(numbersText(column.first, 7).join("  "));
  for (const int cell : {int{name}, int{why}}) table_->item(row, cell)->setToolTip(table_->item(row, cell)->text());
  QComboBox* taken = choice(row, takenAs, "logTakenAs", {tr("–")});
  for (const Column& one : breakaway::columns()) {
    taken->addItem(wordsOf(one), one.name);
    taken->setItemData(taken->count() - 1, tr("In recordings: %1").arg(one.name), Qt::ToolTipRole);
  }
  taken->setAccessibleName(tr("%1 is taken as").arg(column.name));
  taken->setToolTip(column.to.isEmpty() ? tr("Left out") : tr("In recordings: %1").arg(column.to));
  taken->setCurrentIndex(column.to.isEmpty() ? 0 : taken->findData(column.to));
  QStringList units = column.to.isEmpty() ? QStringList() : unitsOf(column.to);
  const QString shown = column.unit.isEmpty() && !units.isEmpty() ? units.front() : column.unit;
  if (!units.isEmpty() && !units.contains(shown)) units << shown;
  QComboBox* counted = choice(row, unit, "logUnit", units);
  counted->setAccessibleName(tr("Unit of %1").arg(column.name));
  counted->setCurrentIndex(static_cast<int>(units.indexOf(shown)));
  counted->setEnabled(!units.isEmpty());
}

/// What stands in the row's boxes now. A unit of another kind than the column's gives way to SI.
void LogPanel::correct(int row) {
  const auto* taken = qobject_cast<QComboBox*>(table_->cellWidget(row, takenAs));
  const auto* counted = qobject_cast<QComboBox*>(table_->cellWidget(row, unit));
  const QString to = taken->currentData().toString();
  const LogColumn& shown = log_.columns()[static_cast<size_t>(row)];
  const bool sameUnit = counted->currentText() == shown.unit || (shown.unit.isEmpty() && counted->currentIndex() <= 0);
  if (to == shown.to && sameUnit) return;
  const QStringList units = unitsOf(to);
  const QString chosen = units.contains(counted->currentText()) ? counted->currentText() : units.front();
  log_.take(table_->item(row, name)->text(), to, unitNamed(chosen.toStdString()) == nullptr ? QString() : chosen);
}

}  // namespace breakaway
