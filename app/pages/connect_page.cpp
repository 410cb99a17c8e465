#include "pages/connect_page.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "firmware_link/presets.h"
#include "session.h"
#include "widgets/controls.h"
#include "widgets/facts_table.h"
#include "widgets/look.h"

namespace breakaway {

namespace {
constexpr int uriRole = Qt::UserRole;

/// A rig file's name without its folders.
QString shortAddress(const QString& uri) {
  return uri.contains('/') ? "simulated:" + QFileInfo(uri).fileName() : uri;
}
}  // namespace

ConnectPage::ConnectPage(Session& session, FileChooser& files, QWidget* parent)
    : Page("connectPage", tr("Connect"), "connect", parent), session_(session), files_(files) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 12, 16, 12);
  row->setSpacing(28);
  row->addWidget(buildBoards(), 0);
  row->addWidget(buildIdentity(), 1);
  connect(&session_, &Session::connectionChanged, this, &ConnectPage::showConnection);
  connect(&session_, &Session::settingsChanged, this, &ConnectPage::showConnection);
  connect(&session_, &Session::runChanged, this, &ConnectPage::showMotion);
  listPresets();
  showConnection();
}

QWidget* ConnectPage::buildBoards() {
  auto* side = new QWidget(this);
  side->setFixedWidth(340);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(heading(side, tr("Boards")));
  boards_ = new QListWidget(side);
  boards_->setObjectName("boardList");
  boards_->setAccessibleName(tr("Boards to connect to"));
  column->addWidget(boards_, 1);
  auto* buttons = new QHBoxLayout;
  connect_ = pushButton(side, "connectButton", tr("Connect"));
  auto* open =
      pushButton(side, "openRigButton", tr("Open rig file…"), tr("Add a simulated rig of your own, NAME.rig.json"));
  buttons->addWidget(connect_);
  buttons->addWidget(open);
  buttons->addStretch(1);
  column->addLayout(buttons);
  connect(connect_, &QPushButton::clicked, this, &ConnectPage::connectChosen);
  connect(open, &QPushButton::clicked, this, &ConnectPage::openRig);
  connect(boards_, &QListWidget::itemActivated, this, &ConnectPage::connectChosen);
  connect(boards_, &QListWidget::currentRowChanged, this, &ConnectPage::showConnection);
  return side;
}

QWidget* ConnectPage::buildIdentity() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(heading(side, tr("Connected board")));
  auto* tables = new QHBoxLayout;
  tables->setSpacing(40);
  facts_ = new FactsTable("identityTable", side);
  controller_ = new FactsTable("controllerTable", side);
  tables->addWidget(facts_, 0, Qt::AlignTop);
  tables->addWidget(controller_, 0, Qt::AlignTop);
  tables->addStretch(1);
  column->addLayout(tables);
  auto* buttons = new QHBoxLayout;
  turn_ = pushButton(side, "turnButton", tr("Turn slowly"));
  disconnect_ = pushButton(side, "disconnectButton", tr("Disconnect"));
  pace_ = new QComboBox(side);
  pace_->setObjectName("paceBox");
  pace_->setAccessibleName(tr("Pace of simulated time"));
  for (const double pace : {1.0, 2.0, 5.0, 10.0, 20.0}) pace_->addItem(tr("%1 × real time").arg(pace), pace);
  connect(pace_, &QComboBox::activated, this, [this] { session_.setPace(pace_->currentData().toDouble()); });
  buttons->addWidget(turn_);
  buttons->addWidget(disconnect_);
  buttons->addSpacing(12);
  buttons->addWidget(pace_);
  buttons->addStretch(1);
  column->addSpacing(4);
  column->addLayout(buttons);
  column->addStretch(1);
  connect(turn_, &QPushButton::clicked, &session_, &Session::turnSlowly);
  connect(disconnect_, &QPushButton::clicked, &session_, &Session::disconnectBoard);
  return side;
}

void ConnectPage::listPresets() {
  for (const std::string& name : presetNames()) {
    const QString preset = QString::fromStdString(name);
    addBoard(preset, "simulated:" + preset);
    if (preset == "servo") boards_->setCurrentRow(boards_->count() - 1);
  }
}

void ConnectPage::addBoard(const QString& name, const QString& uri) {
  auto* item = new QListWidgetItem(tr("Simulated board: %1").arg(name), boards_);
  item->setData(uriRole, uri);
  item->setToolTip(uri);
}

void ConnectPage::connectChosen() {
  if (const auto* item = boards_->currentItem()) session_.connectTo(item->data(uriRole).toString());
}

void ConnectPage::openRig() {
  files_.ask(this, {tr("Open a simulated rig"), tr("Rig file (*.rig.json)"), {}, false}, [this](const QString& path) {
    addBoard(QFileInfo(path).fileName(), "simulated:" + path);
    boards_->setCurrentRow(boards_->count() - 1);
    connectChosen();
  });
}

void ConnectPage::showConnection() {
  const bool connected = session_.connected();
  setAvailable(connect_, boards_->currentItem() != nullptr, tr("Connect to the chosen board"),
               tr("No board is chosen in the list"));
  const bool simulated = session_.identity().simulated;
  setAvailable(pace_, simulated, tr("How fast the simulated board's time passes; a long sweep need not be waited for"),
               connected ? tr("A real board keeps its own time") : tr("No board is connected"));
  setAvailable(disconnect_, connected, tr("Stop the motor and let the board go"), tr("No board is connected"));
  const Identity& identity = session_.identity();
  const ControllerSettings& settings = session_.settings();
  if (!connected) {
    facts_->show({{tr("Device"), tr("none"), {}}});
    controller_->show({});
  } else {
    const auto number = [](double value) { return QString::number(value, 'g', 5); };
    facts_->show(
        {{tr("Device"), QString::fromStdString(identity.device), {}},
         {tr("Firmware"), QString::fromStdString(identity.firmware), {}},
         {tr("Address"), shortAddress(session_.uri()), session_.uri()},
         {tr("Control loop"), tr("%1 Hz").arg(number(identity.loopRate_Hz)), tr("One sample comes from each tick")},
         {tr("Encoder"), tr("%1 counts per turn").arg(number(identity.countsPerRev)), {}},
         {tr("Index"), identity.hasIndex ? tr("once per turn") : tr("none"), {}},
         {tr("Supply"), tr("%1 V").arg(number(identity.supply_V)), {}}});
    controller_->show(
        {{tr("Velocity Kp"), tr("%1 A s/rad").arg(number(settings.velocity_kp_A_s_per_rad)), {}},
         {tr("Velocity Ki"), tr("%1 A/rad").arg(number(settings.velocity_ki_A_per_rad)), {}},
         {tr("Velocity Kd"), tr("%1 A s²/rad").arg(number(settings.velocity_kd_A_s2_per_rad)), {}},
         {tr("Observer cutoff"), tr("%1 rad/s").arg(number(settings.observer_cutoff_rad_per_s)), {}},
         {tr("Nominal inertia"), tr("%1 kg m²").arg(number(settings.nominal_inertia_kg_m2)), {}},
         {tr("Nominal torque constant"), tr("%1 Nm/A").arg(number(settings.nominal_torque_constant_Nm_per_A)), {}},
         {tr("Current limit"), tr("%1 A").arg(number(settings.current_limit_A)), {}}});
  }
  showMotion();
}

void ConnectPage::showMotion() {
  setAvailable(turn_, tr("Turn to and fro slowly, ±6 rad/s, until STOP"), session_.obstacle());
}

}  // namespace breakaway
