#include "pages/connect_page.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "experiment/abilities.h"
#include "session/bench_runs.h"
#include "session/connection.h"
#include "session/language.h"
#include "widgets/board_list.h"
#include "widgets/controls.h"
#include "widgets/facts_table.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/profile_panel.h"
#include "widgets/setting_words.h"
#include "widgets/welcome_card.h"

namespace breakaway {

namespace {
constexpr int stateLines = 4, identityHeight = 212, turnWidth = 120, connectWidth = 144;

/// A rig file's name without its folders.
QString shortAddress(const QString& uri) {
  return uri.contains('/') ? uri.section(':', 0, 0) + ":" + QFileInfo(uri).fileName() : uri;
}

QString linkTo(const char* page, const QString& title) {
  return QString("<a href='%1'>%2</a>").arg(page, title);
}

/// What this board can't do, each with its reason; empty when it can do all.
QString cannotWords(const Identity& board) {
  const std::pair<Task, QString> tasks[] = {{Task::homing, ConnectPage::tr("Homing")},
                                            {Task::identification, ConnectPage::tr("Identification and sweeps")},
                                            {Task::tuning, ConnectPage::tr("Tuning")},
                                            {Task::compensation, ConnectPage::tr("Friction compensation")}};
  QStringList lines;
  for (const auto& [task, name] : tasks) {
    const Message why = obstacleTo(task, board);
    if (!why.empty()) lines << "• " + name + ": " + inLanguage(why);
  }
  return lines.isEmpty() ? QString() : ConnectPage::tr("Not possible with this board:") + "\n" + lines.join('\n');
}
}  // namespace

ConnectPage::ConnectPage(Connection& connection, BenchRuns& bench, ProfileComparison& profile, FileChooser& files,
                         QWidget* parent)
    : Page("connectPage", tr("Connect"), parent),
      connection_(connection),
      bench_(bench),
      profile_(profile),
      files_(files) {
  setHead(tr("Connect"), tr("Choose a board and connect. Nothing moves, and nothing is written to it."));
  goOn_ = addPrimary("goOnButton", tr("Identify the motor"));
  connect_ = addSecondary("connectButton", tr("Connect"), connectWidth);
  disconnect_ = addSecondary("disconnectButton", tr("Disconnect"));
  settings()->addWidget(buildBoards(), 1);
  auto* welcome = new WelcomeCard(this);
  welcome_ = welcome;
  connect(welcome, &WelcomeCard::tryAsked, this, &ConnectPage::tryOut);
  picture()->addWidget(welcome_, 1);
  board_ = new QWidget(this);
  auto* cards = columnIn(board_, picture()->spacing());
  cards->addWidget(buildIdentity());
  cards->addWidget(buildProfile(), 1);
  picture()->addWidget(board_, 1);
  connect(&connection_, &Connection::changed, this, &ConnectPage::showConnection);
  connect(&connection_, &Connection::settingsChanged, this, &ConnectPage::showConnection);
  connect(&connection_, &Connection::runChanged, this, &ConnectPage::showMotion);
  connect(&bench_, &BenchRuns::measured, this, &ConnectPage::showMotion);
  showConnection();
}

QWidget* ConnectPage::buildBoards() {
  auto* side = card(this);
  auto* column = columnOf(side);
  column->addWidget(section(side, tr("Boards")));
  boards_ = new BoardList(side);
  column->addWidget(boards_, 1);
  address_ = new QLineEdit(boards_->address(), side);
  address_->setObjectName("addressEdit");
  address_->setAccessibleName(tr("Address of the board"));
  address_->setPlaceholderText("serial:ttyACM0@115200");
  address_->setToolTip(
      tr("serial:PORT@BAUD or tcp:HOST:PORT. A VESC doesn't know its motor's pole pairs and encoder counts: "
         "write ?pole_pairs=7&counts_per_rev=16384 behind its address"));
  auto* named = new QHBoxLayout;
  auto* title = new QLabel(tr("Address"), side);
  title->setBuddy(address_);
  named->addWidget(title);
  named->addWidget(address_, 1);
  column->addLayout(named);
  auto* open =
      pushButton(side, "openRigButton", tr("Open rig file…"), tr("Add a simulated rig of your own, NAME.rig.json"));
  column->addWidget(open);
  state_ = explanation(side, {}, "connectionState");
  state_->setFixedHeight(stateLines * state_->fontMetrics().lineSpacing());
  state_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  state_->setTextInteractionFlags(Qt::TextBrowserInteraction);
  state_->setAccessibleName(tr("State of the connection"));
  state_->setToolTip(tr("What came of connecting, and what is next"));
  connect(state_, &QLabel::linkActivated, this, &ConnectPage::pageAsked);
  column->addWidget(state_);
  connect(connect_, &QPushButton::clicked, this, &ConnectPage::connectChosen);
  connect(goOn_, &QPushButton::clicked, this, [this] { emit pageAsked(nextPage()); });
  connect(open, &QPushButton::clicked, this, &ConnectPage::openRig);
  connect(boards_, &QListWidget::itemActivated, this, &ConnectPage::connectChosen);
  connect(boards_, &QListWidget::currentRowChanged, this, [this] {
    if (const QString chosen = boards_->address(); !chosen.isEmpty()) address_->setText(chosen);
  });
  connect(address_, &QLineEdit::returnPressed, this, &ConnectPage::connectChosen);
  connect(address_, &QLineEdit::textChanged, this, &ConnectPage::showConnection);
  return side;
}

QWidget* ConnectPage::buildIdentity() {
  auto* side = card(this);
  auto* column = columnOf(side);
  auto* head = new QHBoxLayout;
  head->addWidget(section(side, tr("Connected board")), 1);
  head->addWidget(buildMotion());
  column->addLayout(head);
  auto* tables = new QHBoxLayout;
  tables->setSpacing(24);
  facts_ = new FactsTable("identityTable", side);
  controller_ = new FactsTable("controllerTable", side);
  tables->addWidget(facts_, 0, Qt::AlignTop);
  tables->addWidget(controller_, 0, Qt::AlignTop);
  cannot_ = explanation(side, {}, "cannotLine");
  tables->addWidget(cannot_, 100, Qt::AlignTop);
  tables->addStretch(1);
  column->addLayout(tables);
  column->addStretch(1);
  side->setMinimumHeight(identityHeight);  // as much as the longest identity takes: what is below stays where it is
  return side;
}

QWidget* ConnectPage::buildProfile() {
  auto* side = card(this);
  columnOf(side)->addWidget(new ProfilePanel(connection_, profile_, files_, side), 1);
  return side;
}

QWidget* ConnectPage::buildMotion() {
  auto* row = new QWidget(this);
  auto* buttons = rowIn(row);
  turn_ = pushButton(row, "turnButton", tr("Turn slowly"));
  turn_->setFixedWidth(turnWidth);
  pace_ = new QComboBox(row);
  pace_->setObjectName("paceBox");
  pace_->setAccessibleName(tr("Pace of simulated time"));
  for (const double pace : {1.0, 2.0, 5.0, 10.0, 20.0}) pace_->addItem(tr("%1 × real time").arg(pace), pace);
  connect(pace_, &QComboBox::activated, this, [this] { connection_.setPace(pace_->currentData().toDouble()); });
  buttons->addWidget(turn_);
  buttons->addWidget(pace_);
  connect(turn_, &QPushButton::clicked, &bench_, &BenchRuns::turnSlowly);
  connect(disconnect_, &QPushButton::clicked, &connection_, &Connection::close);
  return row;
}

void ConnectPage::connectChosen() {
  if (const QString address = address_->text().trimmed(); !address.isEmpty()) connection_.open(address);
}

void ConnectPage::tryOut(const QString& page, bool needsBoard) {
  if (needsBoard) connection_.open("simulated:servo");
  emit pageAsked(page);
}

void ConnectPage::openRig() {
  files_.ask(this, {tr("Open a simulated rig"), tr("Rig file (*.rig.json)"), {}, false}, [this](const QString& path) {
    boards_->addRig(QFileInfo(path).fileName(), "simulated:" + path);
    connectChosen();
  });
}

void ConnectPage::showConnection() {
  const bool connected = connection_.connected(), simulated = connection_.identity().simulated;
  const ConnectionState state = connection_.state();
  const bool trying = state == ConnectionState::connecting || state == ConnectionState::reconnecting;
  const bool begins = state == ConnectionState::none || state == ConnectionState::failed;
  if (begins || connected) {  // on the way to either, what is there stays
    welcome_->setVisible(begins);
    board_->setVisible(!begins);
  }
  const bool anew = connected && address_->text().trimmed() == connection_.uri();
  connect_->setText(anew ? tr("Connect anew") : tr("Connect"));
  connect_->setAccessibleName(connect_->text());
  dressAs(connect_, "role", anew ? QString() : "primary");  // what is connected asks for nothing here
  setAvailable(connect_, !address_->text().trimmed().isEmpty(), tr("Connect to this address; the motor stays off"),
               tr("No board is chosen in the list, and no address is given"));
  showNext();
  setAvailable(pace_, simulated,
               tr("How fast time passes on the simulated board: at 20 × real time a sweep of 20 minutes takes one"),
               connected ? tr("A real board keeps its own time") : tr("No board is connected"));
  disconnect_->setText(trying ? tr("Give up") : tr("Disconnect"));
  setAvailable(disconnect_, connected || trying,
               trying ? tr("Don't try to connect any more") : tr("Stop the motor and let the board go"),
               tr("No board is connected"));
  showState();
  showIdentity();
  showMotion();
}

QString ConnectPage::nextPage() const {
  return obstacleTo(Task::identification, connection_.identity()).empty() ? "identifyPage" : "handPage";
}

/// Of what is at the head, one is to be pressed: to connect, and then to go on.
void ConnectPage::showNext() {
  const bool connected = connection_.connected();
  goOn_->setText(connected && nextPage() == "handPage" ? tr("Go on to Drive by hand") : tr("Go on to Identify"));
  goOn_->setAccessibleName(goOn_->text());
  dressAs(goOn_, "role", connected ? "primary" : QString());
  setAvailable(goOn_, connected, tr("The next step; nothing moves before it is asked to"), tr("No board is connected"));
}

void ConnectPage::showState() {
  dressAs(state_, "tone", connection_.trouble().empty() ? QString() : "trouble");
  setState(railState());
  switch (connection_.state()) {
    case ConnectionState::none:
      state_->setText(address_->text().startsWith("simulated")
                          ? tr("A simulated board: every page works as with a real one, and nothing can break.")
                          : QString());
      break;
    case ConnectionState::connecting:
      state_->setText(tr("Connecting to %1 …").arg(shortAddress(connection_.uri())));
      break;
    case ConnectionState::connected:
      state_->setText(tr("Connected. Next: %1; or %2, which makes by itself what it needs.")
                          .arg(linkTo("identifyPage", tr("Identify")), linkTo("frictionPage", tr("Friction"))));
      break;
    case ConnectionState::failed:
      state_->setText(tr("Not connected: %1").arg(inLanguage(connection_.trouble())));
      break;
    case ConnectionState::reconnecting:
      state_->setText(tr("Link lost: %1. Trying again every second; the motor stays off when the board comes back.")
                          .arg(inLanguage(connection_.trouble())));
      break;
  }
}

StepState ConnectPage::railState() const {
  switch (connection_.state()) {
    case ConnectionState::connected: {
      const double rate_Hz = connection_.identity().loopRate_Hz;
      return {StepMark::done,
              rate_Hz < 1e3 ? tr("%1 Hz").arg(rate_Hz, 0, 'f', 0) : tr("%1 kHz").arg(rate_Hz / 1e3, 0, 'f', 2)};
    }
    case ConnectionState::connecting:
      return {StepMark::running, tr("connecting")};
    case ConnectionState::reconnecting:
      return {StepMark::trouble, tr("link lost, trying again")};
    case ConnectionState::failed:
      return {StepMark::trouble, tr("not connected")};
    case ConnectionState::none:
      break;
  }
  return {StepMark::open, tr("no board")};
}

void ConnectPage::showIdentity() {
  const Identity& identity = connection_.identity();
  const ControllerSettings& settings = connection_.settings();
  cannot_->setText(connection_.connected() ? cannotWords(identity) : QString());
  cannot_->setVisible(!cannot_->text().isEmpty());  // its place is the tables'
  if (!connection_.connected()) {
    facts_->show({{tr("Device"), tr("none"), {}}});
    controller_->show({});
  } else {
    const auto number = [](double value) { return plainText(value); };
    facts_->show({{tr("Device"), QString::fromStdString(boardName(identity)), {}},
                  {tr("Firmware"), QString::fromStdString(identity.firmware), {}},
                  {tr("Address"), shortAddress(connection_.uri()), connection_.uri()},
                  {identity.can.everyTick ? tr("Control loop") : tr("Asked for values"),
                   tr("%1 Hz").arg(number(identity.loopRate_Hz)),
                   identity.can.everyTick ? tr("The board sends one sample for each tick of its loop")
                                          : tr("As often as the board can answer while half of its time stays free")},
                  {tr("Encoder"),
                   (connection_.linear() ? tr("%1 counts per m") : tr("%1 counts per turn"))
                       .arg(plainText(identity.countsPerRev)),
                   {}},
                  {tr("Index"),
                   !identity.hasIndex     ? tr("none")
                   : connection_.linear() ? tr("once over the travel")
                                          : tr("once per turn"),
                   {}},
                  {tr("Supply"), tr("%1 V").arg(number(identity.supply_V)), {}}});
    std::vector<Fact> rows;
    for (double ControllerSettings::*setting :
         {&ControllerSettings::velocity_kp_A_s_per_rad, &ControllerSettings::velocity_ki_A_per_rad,
          &ControllerSettings::velocity_kd_A_s2_per_rad, &ControllerSettings::observer_cutoff_rad_per_s,
          &ControllerSettings::nominal_inertia_kg_m2, &ControllerSettings::nominal_torque_constant_Nm_per_A,
          &ControllerSettings::current_limit_A}) {
      const SettingWords words = settingWords(setting, identity.axis);
      rows.push_back({words.title, number(words.scale * settings.*setting) + " " + words.unit, words.meaning});
    }
    controller_->show(rows);
  }
}

void ConnectPage::showMotion() {
  turn_->setText(connection_.linear() ? tr("Go to and fro") : tr("Turn slowly"));
  setAvailable(turn_,
               connection_.linear() ? tr("Go to and fro slowly over half the travel, until STOP")
                                    : tr("Turn to and fro slowly, ±6 rad/s, until STOP"),
               bench_.turningObstacle());
}

}  // namespace breakaway
