#include <unistd.h>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>

#include "app/window_support.h"
#include "experiment/homing.h"
#include "plant/rig.h"
#include "support/temporary.h"
#include "support/vesc_fake.h"
#include "widgets/board_list.h"
#include "widgets/closing.h"

using namespace breakaway;
using namespace breakaway::test;
using namespace std::chrono_literals;

namespace {

Rig servo() {
  const auto rig = readRig(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/servo.rig.json");
  if (!rig) qFatal("%s", rig.error().message().c_str());
  return *rig;
}

/// A port whose name stays while what is plugged in changes, as below /dev/serial/by-id.
class Socket {
 public:
  void plug(const VescFake& board) const {
    ::unlink(path().c_str());
    QCOMPARE(::symlink(board.path().c_str(), path().c_str()), 0);
  }
  std::string path() const { return folder_.path("port"); }
  QString address() const { return QString::fromStdString("serial:" + path() + "?pole_pairs=7&counts_per_rev=14400"); }

 private:
  TemporaryFolder folder_;
};

struct Desk {
  Desk() : session({1.0, 0.005, 600.0}), window(session, answers) {
    window.show();
    window.showPage("connectPage");
  }
  void connectTo(const QString& address) {
    named<QLineEdit>(window, "addressEdit")->setText(address);
    press(window, "connectButton");
  }
  QString state() { return named<QLabel>(window, "connectionState")->text(); }

  Session session;
  Answers answers;
  MainWindow window;
};

}  // namespace

class TestConnection : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void missingPort_isSaidOnThePage();
  void choice_fillsTheAddress();
  void ports_appearByTheirProducts_andTheChoiceStays();
  void vesc_isConnected_andThePagesSayWhatItCannotDo();
  void stop_reachesTheVesc();
  void lostBoard_comesBack_withItsMotorOff();
  void givingUp_endsTheTrying();
  void profile_isSavedComparedAndRestoredInPart();
  void parameters_areEditedBesideThePageAndSentInPart();
  void parameters_refuseWhatTheBoardDoesNotOffer();
};

void TestConnection::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestConnection::missingPort_isSaidOnThePage() {
  Desk desk;
  desk.connectTo("serial:ttyNoSuchPort7");
  QTRY_COMPARE(desk.session.connection.state(), ConnectionState::failed);
  QVERIFY2(desk.state().startsWith("Not connected: serial port /dev/ttyNoSuchPort7: there is no such port"),
           qPrintable(desk.state()));
  desk.connectTo("serial:ttyUSB0@fast");
  QTRY_VERIFY2(desk.state().contains("has the baud rate \"fast\""), qPrintable(desk.state()));
}

void TestConnection::choice_fillsTheAddress() {
  Desk desk;
  auto* list = named<QListWidget>(desk.window, "boardList");
  auto* address = named<QLineEdit>(desk.window, "addressEdit");
  QCOMPARE(address->text(), QString("simulated:servo"));
  for (int row = 0; row < list->count(); ++row) {
    if (list->item(row)->text().contains("geared")) list->setCurrentRow(row);
  }
  QCOMPARE(address->text(), QString("simulated:geared"));
  press(desk.window, "connectButton");
  QVERIFY(desk.session.connection.connected());
  QVERIFY2(desk.state().startsWith("Connected"), qPrintable(desk.state()));
}

void TestConnection::ports_appearByTheirProducts_andTheChoiceStays() {
  BoardList list;
  const SerialPort first{"/dev/ttyACM0", "/dev/serial/by-id/usb-A", "Virtual COM Port", "ChibiOS", "1", true};
  const SerialPort second{"/dev/ttyUSB0", "/dev/ttyUSB0", "FT232R USB UART", "FTDI", "2", true};
  const auto texts = [&list] {
    QStringList all;
    for (int row = 0; row < list.count(); ++row) all << list.item(row)->text();
    return all;
  };
  list.showPorts({});
  QVERIFY(texts().contains("nothing is plugged in"));
  list.showPorts({first, second});
  const auto row = texts().indexOf("Virtual COM Port (ttyACM0)");
  QVERIFY(row > texts().indexOf("On a serial port") && row < texts().indexOf("On the network"));
  QVERIFY(!texts().contains("nothing is plugged in"));
  list.setCurrentRow(static_cast<int>(row));
  QCOMPARE(list.address(), QString("serial:/dev/serial/by-id/usb-A@115200"));
  list.showPorts({second, first});
  QCOMPARE(list.address(), QString("serial:/dev/serial/by-id/usb-A@115200"));
  list.showPorts({second});
  QVERIFY(!texts().contains("Virtual COM Port (ttyACM0)"));
}

void TestConnection::vesc_isConnected_andThePagesSayWhatItCannotDo() {
  Desk desk;
  const VescFake vesc(servo());
  const Socket socket;
  socket.plug(vesc);
  desk.connectTo(socket.address());
  QVERIFY2(desk.state().startsWith("Connecting"), qPrintable(desk.state()));  // the window isn't held up
  QTRY_VERIFY2(desk.session.connection.connected(), qPrintable(desk.state()));
  QCOMPARE(named<QLabel>(desk.window, "deviceLabel")->text(), QString("VESC 60_MK5 01020304"));
  QVERIFY(named<QLabel>(desk.window, "cannotLine")->text().contains("Homing: the board reports no index"));
  QVERIFY(!named<QWidget>(desk.window, "simulatedLabel")->isVisible());
  const auto refused = [&desk](const char* button, const char* why) {
    auto* found = named<QPushButton>(desk.window, button);
    return !found->isEnabled() && found->toolTip().contains(why);
  };
  QVERIFY(refused("homeButton", "The board reports no index: homing needs one"));
  QVERIFY(refused("velocitySweepButton", "no index"));
  QVERIFY(refused("breakawaySweepButton", "winding test"));
  QVERIFY(refused("tuneSoftButton", "keeps its own gains"));
  desk.session.connection.close();
  QVERIFY(!desk.session.connection.connected());
}

void TestConnection::stop_reachesTheVesc() {
  Desk desk;
  const VescFake vesc(servo());
  const Socket socket;
  socket.plug(vesc);
  desk.connectTo(socket.address());
  QTRY_VERIFY2(desk.session.connection.connected(), qPrintable(desk.state()));
  press(desk.window, "turnButton");
  QTRY_VERIFY(vesc.powered());
  QTRY_VERIFY(desk.session.connection.powered());
  press(desk.window, "stopButton");
  QTRY_VERIFY(!vesc.powered());
  QTRY_VERIFY(!desk.session.connection.powered());
}

void TestConnection::lostBoard_comesBack_withItsMotorOff() {
  Desk desk;
  const Socket socket;
  {
    VescFake vesc(servo());
    socket.plug(vesc);
    desk.connectTo(socket.address());
    QTRY_VERIFY2(desk.session.connection.connected(), qPrintable(desk.state()));
    press(desk.window, "turnButton");
    QTRY_VERIFY(vesc.powered());
    vesc.hangUp();
  }
  QTRY_COMPARE(desk.session.connection.state(), ConnectionState::reconnecting);
  QVERIFY2(desk.state().startsWith("Link lost: "), qPrintable(desk.state()));
  QVERIFY(!desk.session.connection.connected());
  const VescFake again(servo());
  socket.plug(again);
  QTRY_VERIFY_WITH_TIMEOUT(desk.session.connection.connected(), 10000);
  QTest::qWait(500);
  QVERIFY(!again.powered() && !desk.session.connection.run().running());
  for (const auto& one : again.commands()) QCOMPARE(one, (std::vector<std::uint8_t>{6, 0, 0, 0, 0}));
}

void TestConnection::givingUp_endsTheTrying() {
  Desk desk;
  const Socket socket;
  {
    VescFake vesc(servo());
    socket.plug(vesc);
    desk.connectTo(socket.address());
    QTRY_VERIFY2(desk.session.connection.connected(), qPrintable(desk.state()));
  }
  QTRY_COMPARE(desk.session.connection.state(), ConnectionState::reconnecting);
  QCOMPARE(named<QPushButton>(desk.window, "disconnectButton")->text(), QString("Give up"));
  press(desk.window, "disconnectButton");
  QCOMPARE(desk.session.connection.state(), ConnectionState::none);
  const VescFake again(servo());
  socket.plug(again);
  QTest::qWait(1500);
  QVERIFY(!desk.session.connection.connected());
}

void TestConnection::profile_isSavedComparedAndRestoredInPart() {
  Desk desk;
  const TemporaryFolder folder;
  const QString file = QString::fromStdString(folder.path("a.profile.json"));
  desk.connectTo("simulated");
  QVERIFY(desk.session.connection.connected());
  desk.answers.byTitle["Save the profile"] = file;
  desk.answers.byTitle["Compare with a profile"] = file;
  press(desk.window, "saveProfileButton");
  QTRY_VERIFY(QFile::exists(file));
  const ControllerSettings saved = desk.session.connection.settings();
  ControllerSettings other = saved;
  other.velocity_kp_A_s_per_rad *= 2.0;
  other.current_limit_A *= 0.5;
  desk.session.connection.configure(other);
  QTRY_VERIFY(desk.session.connection.settings() == other);
  press(desk.window, "openProfileButton");
  auto* table = named<QTableWidget>(desk.window, "profileTable");
  QTRY_COMPARE(table->rowCount(), 2);
  QCOMPARE(table->item(0, 0)->text(), QString("Velocity Kp (A s/rad)"));
  QVERIFY(table->item(0, 3)->text().isEmpty());
  table->item(1, 0)->setCheckState(Qt::Unchecked);
  QVERIFY(desk.session.connection.settings() == other);  // nothing is written unasked
  press(desk.window, "restoreProfileButton");
  other.velocity_kp_A_s_per_rad = saved.velocity_kp_A_s_per_rad;
  QTRY_VERIFY(desk.session.connection.settings() == other);
  QTRY_VERIFY(!table->item(0, 3)->text().isEmpty());
  QCOMPARE(table->item(0, 3)->text(), table->item(0, 2)->text());
  desk.session.connection.close();
  QTRY_COMPARE(table->rowCount(), 0);
}

void TestConnection::parameters_areEditedBesideThePageAndSentInPart() {
  Desk desk;
  desk.connectTo("simulated");
  QVERIFY(desk.session.connection.connected());
  desk.window.showPage("tunePage");
  press(desk.window, "parametersButton");
  auto* table = named<QTableWidget>(desk.window, "parametersTable");
  const auto row = [&](const QString& title) {
    const auto found = table->findItems(title, Qt::MatchExactly);
    if (found.size() != 1) qFatal("no setting is called %s", qPrintable(title));
    return found.front()->row();
  };
  constexpr int board = 2, edited = 3, before = 4, profile = 5;
  const int kp = row("Velocity Kp (A s/rad)"), limit = row("Current limit (A)");
  const ControllerSettings had = desk.session.connection.settings();
  const QString kpText = table->item(kp, board)->text();

  table->item(kp, edited)->setText("0.0123");
  table->item(limit, edited)->setText("2,5");
  QCOMPARE(desk.session.edits.count(), size_t{2});
  QVERIFY(desk.session.connection.settings() == had);  // nothing is written unasked
  QCOMPARE(named<QPushButton>(desk.window, "applyButton")->text(), QString("Apply 2 edits"));  // Tune has them, too
  table->item(limit, edited)->setText("1000");
  QVERIFY(named<QLabel>(desk.window, "parametersNote")->text().contains("is not within 0 to"));
  QCOMPARE(table->item(limit, edited)->text(), QString("2.5"));
  press(desk.window, "parametersUndo");
  QCOMPARE(desk.session.edits.count(), size_t{1});
  press(desk.window, "parametersRedo");
  QCOMPARE(desk.session.edits.count(), size_t{2});

  table->item(limit, 0)->setCheckState(Qt::Unchecked);
  press(desk.window, "parametersApply");
  QTRY_COMPARE(desk.session.edits.count(), size_t{1});
  ControllerSettings wanted = had;
  wanted.velocity_kp_A_s_per_rad = 0.0123;
  QVERIFY(desk.session.connection.settings() == wanted);
  QCOMPARE(table->item(kp, board)->text(), QString("0.0123"));
  QCOMPARE(table->item(kp, before)->text(), kpText);
  QCOMPARE(table->item(limit, edited)->text(), QString("2.5"));

  const TemporaryFolder folder;
  const QString file = QString::fromStdString(folder.path("a.profile.json"));
  Profile saved{desk.session.connection.identity().device, "test", had, {}};
  saved.settings.observer_cutoff_rad_per_s *= 0.5;
  QVERIFY(writeProfile(saved, file.toStdString()).ok());
  desk.answers.byTitle["Lay a profile beside the board"] = file;
  press(desk.window, "parametersOpenProfile");
  QCOMPARE(table->item(kp, profile)->text(), kpText);
  QVERIFY(desk.session.connection.settings() == wanted);
  press(desk.window, "parametersTakeProfile");
  QVERIFY(desk.session.edits.edited().observer_cutoff_rad_per_s == saved.settings.observer_cutoff_rad_per_s);
  QVERIFY(desk.session.edits.edited().velocity_kp_A_s_per_rad == had.velocity_kp_A_s_per_rad);
  table->setCurrentCell(kp, edited);
  press(desk.window, "parametersRevert");
  QVERIFY(!desk.session.edits.isEdited(&ControllerSettings::velocity_kp_A_s_per_rad));
  press(desk.window, "parametersRevertAll");
  QCOMPARE(desk.session.edits.count(), size_t{0});
  QVERIFY(desk.session.connection.settings() == wanted);
  QVERIFY(parametersKeptOpen());
  press(desk.window, "parametersClose");
  QVERIFY(!table->isVisible());
  QVERIFY(!parametersKeptOpen());
}

void TestConnection::parameters_refuseWhatTheBoardDoesNotOffer() {
  Desk desk;
  const VescFake vesc(servo());
  const Socket socket;
  socket.plug(vesc);
  desk.connectTo(socket.address());
  QTRY_VERIFY2(desk.session.connection.connected(), qPrintable(desk.state()));
  desk.window.showParameters(true);
  const auto* table = named<QTableWidget>(desk.window, "parametersTable");
  QCOMPARE(table->item(0, 2)->text(), QString("not offered"));
  QVERIFY(!(table->item(0, 3)->flags() & Qt::ItemIsEditable));
  QVERIFY(!desk.session.edits.set(&ControllerSettings::velocity_kp_A_s_per_rad, 0.1));
  QVERIFY(desk.session.edits.set(&ControllerSettings::current_limit_A, 1.5));
  named<QPushButton>(desk.window, "parametersApply")->click();
  QTRY_COMPARE(desk.session.connection.settings().current_limit_A, 1.5);
  desk.window.showParameters(false);
}

JOURNEY_MAIN(TestConnection)
#include "tst_connection.moc"
