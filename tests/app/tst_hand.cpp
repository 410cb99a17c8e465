// Driving by hand: the motor runs while something is held, and at no other time.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

#include "app/desk.h"

using namespace breakaway;
using namespace breakaway::test;

class TestHand : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void motor_runsWhileTheButtonIsHeld();
  void motor_runsWhileAnArrowIsHeld();
  void motor_isLetGoWithThePage();
  void motor_isLetGoBeyondThePagesLimit();
  void axis_isNotDrivenBeforeItsEndsAreKnown();
};

namespace {

/// Connected and on the page, with 5 rad/s to hold.
struct Hand : Desk {
  Hand() : Desk(unhurried) {
    press(window, "connectButton");
    window.showPage("handPage");
    press(window, "handSpeed");
    named<QDoubleSpinBox>(window, "handTarget")->setValue(5.0);
  }
  bool turnsAt(double least_rad_per_s, double most_rad_per_s) {
    return QTest::qWaitFor(
        [&] {
          const auto newest = session.live.history().newest();
          return newest && newest->velocity_rad_per_s > least_rad_per_s && newest->velocity_rad_per_s < most_rad_per_s;
        },
        patience_ms);
  }
  bool isFree() {
    return QTest::qWaitFor([&] { return !session.connection.run().running() && !session.connection.powered(); },
                           patience_ms);
  }
};

}  // namespace

void TestHand::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestHand::motor_runsWhileTheButtonIsHeld() {
  Hand hand;
  QVERIFY(hand.isFree());
  QTest::mousePress(named<QPushButton>(hand.window, "handOn"), Qt::LeftButton);
  QVERIFY(hand.turnsAt(4.0, 6.0));
  QVERIFY(hand.session.connection.runs(RunKind::hand));
  QTest::mouseRelease(named<QPushButton>(hand.window, "handOn"), Qt::LeftButton);
  QVERIFY(hand.isFree());
  QTest::mousePress(named<QPushButton>(hand.window, "handBack"), Qt::LeftButton);
  QVERIFY(hand.turnsAt(-6.0, -4.0));
  QTest::mouseRelease(named<QPushButton>(hand.window, "handBack"), Qt::LeftButton);
  QVERIFY(hand.isFree());
}

void TestHand::motor_runsWhileAnArrowIsHeld() {
  Hand hand;
  auto* page = named<QWidget>(hand.window, "handPage");
  QTest::keyPress(page, Qt::Key_Right);
  QVERIFY(hand.turnsAt(4.0, 6.0));
  QTest::keyRelease(page, Qt::Key_Right);
  QVERIFY(hand.isFree());
}

void TestHand::motor_isLetGoWithThePage() {
  Hand hand;
  QTest::mousePress(named<QPushButton>(hand.window, "handOn"), Qt::LeftButton);
  QVERIFY(hand.turnsAt(4.0, 6.0));
  hand.window.showPage("connectPage");
  QVERIFY(hand.isFree());
}

void TestHand::motor_isLetGoBeyondThePagesLimit() {
  Hand hand;
  named<QDoubleSpinBox>(hand.window, "handMostSpeed")->setValue(2.0);
  QTest::mousePress(named<QPushButton>(hand.window, "handOn"), Qt::LeftButton);
  const auto& connection = hand.session.connection;
  QVERIFY(QTest::qWaitFor([&] { return connection.run().status.state == Procedure::State::failed; }, patience_ms));
  QVERIFY(hand.isFree());
  const QString said = named<QLabel>(hand.window, "handReading")->text();
  QVERIFY2(said.contains("faster than the limit"), qPrintable(said));
}

void TestHand::axis_isNotDrivenBeforeItsEndsAreKnown() {
  Desk desk(unhurried);
  desk.session.connection.open("simulated:linear");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.connected(); }, patience_ms));
  desk.window.showPage("handPage");
  const auto* button = named<QPushButton>(desk.window, "handOn");
  QVERIFY(!button->isEnabled());
  QVERIFY2(button->toolTip().startsWith("Home first"), qPrintable(button->toolTip()));
}

JOURNEY_MAIN(TestHand)
#include "tst_hand.moc"
