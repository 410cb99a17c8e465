#include "widgets/profile_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "widgets/controls.h"
#include "widgets/number_text.h"
#include "widgets/setting_words.h"
#include "widgets/table.h"

namespace breakaway {

namespace {

constexpr int nameRole = Qt::UserRole;  ///< of the file
constexpr int usualDigits = 4, mostDigits = 9;
constexpr int leastTable_px = 24;
constexpr int profileColumn = 2, acceptedColumn = 3;

/// Of a parameter by its name in the file, or of the friction table, which has neither unit nor scale.
SettingWords wordsFor(const std::string& name) {
  for (const auto& [known, setting] : profileParameters()) {
    if (name == known) return settingWords(setting, Axis::rotary);
  }
  return {name == frictionTableName ? ProfilePanel::tr("Friction table") : QString::fromStdString(name), {}, 1.0, {}};
}

QString shortText(const QString& text, int digits, double scale = 1.0) {
  bool number = false;
  const double value = text.toDouble(&number);
  return number ? plainText(scale * value, digits) : text;
}

/// As many digits as tell the two apart.
int digitsFor(const QString& one, const QString& other) {
  int digits = usualDigits;
  while (digits < mostDigits && shortText(one, digits) == shortText(other, digits)) ++digits;
  return digits;
}

}  // namespace

ProfilePanel::ProfilePanel(const Connection& connection, ProfileComparison& profile, FileChooser& files,
                           QWidget* parent)
    : QWidget(parent), connection_(connection), profile_(profile), files_(files) {
  auto* column = columnIn(this, 8);
  column->addWidget(section(this, tr("Profile")));
  auto* buttons = new QHBoxLayout;
  save_ = pushButton(this, "saveProfileButton", tr("Save…"));
  open_ = pushButton(this, "openProfileButton", tr("Compare with…"));
  restore_ = pushButton(this, "restoreProfileButton", tr("Restore ticked"));
  for (QPushButton* one : {save_, open_, restore_}) buttons->addWidget(one);
  buttons->addStretch(1);
  column->addLayout(buttons);
  source_ = explanation(this, {}, "profileSource");
  column->addWidget(source_);
  table_ = readTable(this, "profileTable", tr("Parameters of the board, or those that differ from the profile"),
                     {tr("Parameter"), tr("Board"), tr("Profile"), tr("Accepted")});
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  table_->setMinimumHeight(leastTable_px);  // it scrolls: beside the live plots there is little room
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
    if (!(name->flags() & Qt::ItemIsUserCheckable) || !name->data(nameRole).isValid()) return;
    name->setCheckState(name->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
  });
  connect(table_, &QTableWidget::itemChanged, this, &ProfilePanel::showAvailable);
  connect(&connection, &Connection::changed, this, &ProfilePanel::showBoard);
  connect(&connection, &Connection::settingsChanged, this, &ProfilePanel::showBoard);
  fill();
}

void ProfilePanel::fill() {
  const QSignalBlocker quiet(table_);
  table_->setRowCount(0);
  const QString source = profile_.source();
  if (source.isEmpty())
    fillBoard();
  else
    fillDifferences();
  for (const int column : {profileColumn, acceptedColumn}) table_->setColumnHidden(column, source.isEmpty());
  source_->setText(source.isEmpty()
                       ? tr("A profile is a file with the gains, limits and friction table of a board: save this "
                            "board's, or see where a saved one differs. Nothing is written unasked.")
                   : table_->rowCount() == 0 ? tr("%1: nothing differs").arg(source)
                                             : source);
  dressAs(source_, "tone", source.isEmpty() ? "muted" : QString());
  table_->setVisible(table_->rowCount() > 0);
  showAvailable();
}

/// What is open stays as it was compared.
void ProfilePanel::showBoard() {
  if (profile_.source().isEmpty())
    fill();
  else
    showAvailable();
}

/// What a profile would hold.
void ProfilePanel::fillBoard() {
  if (!connection_.connected()) return;
  for (const auto& [name, setting] : profileParameters()) {
    if (!connection_.rangeOf(setting).offered) continue;
    const SettingWords words = settingWords(setting, connection_.identity().axis);
    const int row = table_->rowCount();
    table_->setRowCount(row + 1);
    fillRow(*table_, row,
            {words.titleWithUnit(), plainText(words.scale * connection_.settings().*setting, usualDigits), {}, {}});
    table_->item(row, 0)->setToolTip(words.meaning);
  }
}

/// Where the profile that is open and the board part.
void ProfilePanel::fillDifferences() {
  int row = 0;
  for (const ProfileComparison::Row& one : profile_.rows()) {
    if (one.values.same && one.accepted.isEmpty()) continue;
    table_->setRowCount(row + 1);
    const QString here = QString::fromStdString(one.values.here), there = QString::fromStdString(one.values.there);
    const int digits = one.values.same ? usualDigits : digitsFor(here, there);
    const SettingWords words = wordsFor(one.values.name);
    const auto shown = [&](const QString& text) { return shortText(text, digits, words.scale); };
    fillRow(
        *table_, row,
        {words.unit.isEmpty() ? words.title : words.titleWithUnit(), shown(here), shown(there), shown(one.accepted)});
    auto* name = table_->item(row, 0);
    name->setData(nameRole, QString::fromStdString(one.values.name));
    name->setToolTip(tr("%1 in the file").arg(QString::fromStdString(one.values.name)));
    name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
    name->setCheckState(one.values.same ? Qt::Unchecked : Qt::Checked);
    ++row;
  }
}

QStringList ProfilePanel::ticked() const {
  QStringList names;
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto* name = table_->item(row, 0);
    if (name != nullptr && name->checkState() == Qt::Checked && name->data(nameRole).isValid())
      names << name->data(nameRole).toString();
  }
  return names;
}

void ProfilePanel::showAvailable() {
  setAvailable(save_, tr("Write gains, limits and the friction table of this board to a file"),
               profileObstacle(connection_));
  setAvailable(open_, tr("Show where a saved profile differs from the board; nothing is written"),
               profileObstacle(connection_));
  QString nothing = profileObstacle(connection_);
  if (nothing.isEmpty() && profile_.source().isEmpty()) nothing = tr("No profile is open: compare with one first");
  if (nothing.isEmpty() && ticked().isEmpty()) nothing = tr("No parameter is ticked");
  setAvailable(restore_, tr("Ask the board for the profile's values of the ticked parameters"), nothing);
}

}  // namespace breakaway
