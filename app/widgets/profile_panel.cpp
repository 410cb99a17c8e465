#include "widgets/profile_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "widgets/controls.h"
#include "widgets/number_text.h"
#include "widgets/table.h"

namespace breakaway {

namespace {

constexpr int nameRole = Qt::UserRole;  ///< of the file
constexpr int usualDigits = 4, mostDigits = 9;

struct Words {
  const char* name;
  const char* words;
};

constexpr Words parameters[] = {
    {"velocity_kp_A_s_per_rad", QT_TRANSLATE_NOOP("ProfilePanel", "Velocity Kp (A s/rad)")},
    {"velocity_ki_A_per_rad", QT_TRANSLATE_NOOP("ProfilePanel", "Velocity Ki (A/rad)")},
    {"velocity_kd_A_s2_per_rad", QT_TRANSLATE_NOOP("ProfilePanel", "Velocity Kd (A s²/rad)")},
    {"position_kp_A_per_rad", QT_TRANSLATE_NOOP("ProfilePanel", "Position Kp (A/rad)")},
    {"position_ki_A_per_rad_s", QT_TRANSLATE_NOOP("ProfilePanel", "Position Ki (A/(rad s))")},
    {"position_kd_A_s_per_rad", QT_TRANSLATE_NOOP("ProfilePanel", "Position Kd (A s/rad)")},
    {"observer_cutoff_rad_per_s", QT_TRANSLATE_NOOP("ProfilePanel", "Observer cutoff (rad/s)")},
    {"nominal_inertia_kg_m2", QT_TRANSLATE_NOOP("ProfilePanel", "Nominal inertia (kg m²)")},
    {"nominal_torque_constant_Nm_per_A", QT_TRANSLATE_NOOP("ProfilePanel", "Nominal torque constant (Nm/A)")},
    {"current_limit_A", QT_TRANSLATE_NOOP("ProfilePanel", "Current limit (A)")},
    {"velocity_limit_rad_per_s", QT_TRANSLATE_NOOP("ProfilePanel", "Velocity limit (rad/s)")},
    {frictionTableName, QT_TRANSLATE_NOOP("ProfilePanel", "Friction table")}};

QString wordsOf(const std::string& name) {
  const auto* found =
      std::find_if(std::begin(parameters), std::end(parameters), [&](const Words& one) { return name == one.name; });
  return found == std::end(parameters) ? QString::fromStdString(name) : ProfilePanel::tr(found->words);
}

QString shortText(const QString& text, int digits) {
  bool number = false;
  const double value = text.toDouble(&number);
  return number ? numberText(value, digits) : text;
}

/// As many digits as tell the two apart.
int digitsFor(const QString& one, const QString& other) {
  int digits = usualDigits;
  while (digits < mostDigits && shortText(one, digits) == shortText(other, digits)) ++digits;
  return digits;
}

}  // namespace

ProfilePanel::ProfilePanel(Connection& connection, const BenchRuns& bench, Messages& messages, FileChooser& files,
                           QWidget* parent)
    : QWidget(parent), files_(files), profile_(connection, bench, messages) {
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
  fill();
}

void ProfilePanel::fill() {
  const QSignalBlocker quiet(table_);
  int row = 0;
  table_->setRowCount(0);
  for (const ProfileComparison::Row& one : profile_.rows()) {
    if (one.values.same && one.accepted.isEmpty()) continue;
    table_->setRowCount(row + 1);
    const QString here = QString::fromStdString(one.values.here), there = QString::fromStdString(one.values.there);
    const int digits = one.values.same ? usualDigits : digitsFor(here, there);
    fillRow(
        *table_, row,
        {wordsOf(one.values.name), shortText(here, digits), shortText(there, digits), shortText(one.accepted, digits)});
    auto* name = table_->item(row, 0);
    name->setData(nameRole, QString::fromStdString(one.values.name));
    name->setToolTip(tr("%1 in the file").arg(QString::fromStdString(one.values.name)));
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
    if (name != nullptr && name->checkState() == Qt::Checked) names << name->data(nameRole).toString();
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
