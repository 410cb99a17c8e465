// Driving by hand: the motor runs while something is held, and at no other time.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

#include "app/desk.h"
#include "base/numbers.h"
#include "session/jog.h"

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
  void step_goesAsFarAsSaidAndStops();
  void step_endsWithThePage();
  void axis_isNotDrivenBeforeItsEndsAreKnown();
  void step_ofAnAxisEndsBeforeItsMargin();
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

void TestHand::step_goesAsFarAsSaidAndStops() {
  Hand hand;
  QVERIFY(hand.isFree());
  const auto angle_deg = [&] { return hand.session.live.history().newest()->angle_rad * 360.0 / turn_rad; };
  named<QDoubleSpinBox>(hand.window, "handStep")->setValue(90.0);
  const auto step = [&](auto&& begin, double wanted_deg) {
    QTest::qWait(50);
    const double before_deg = angle_deg();
    begin();
    QVERIFY(QTest::qWaitFor([&] { return hand.session.connection.run().running(); }, patience_ms));
    QVERIFY(hand.isFree());
    QCOMPARE(hand.session.connection.run().status.state, Procedure::State::finished);
    QTest::qWait(100);
    const double went_deg = angle_deg() - before_deg;
    QVERIFY2(std::abs(went_deg - wanted_deg) < 3.0, qPrintable(QString::number(went_deg)));
  };
  step([&] { press(hand.window, "jogOn"); }, 90.0);
  step([&] { press(hand.window, "jogBack"); }, -90.0);
  auto* page = named<QWidget>(hand.window, "handPage");
  step([&] { QTest::keyClick(page, Qt::Key_Right, Qt::ShiftModifier); }, 90.0);
}

void TestHand::step_endsWithThePage() {
  Hand hand;
  QVERIFY(hand.isFree());
  named<QDoubleSpinBox>(hand.window, "handStep")->setValue(3600.0);
  press(hand.window, "jogOn");
  QVERIFY(hand.turnsAt(1.0, 3.0));
  hand.window.showPage("connectPage");
  QVERIFY(hand.isFree());
}

void TestHand::axis_isNotDrivenBeforeItsEndsAreKnown() {
  Desk desk(unhurried);
  desk.session.connection.open("simulated:linear");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.connected(); }, patience_ms));
  desk.window.showPage("handPage");
  const auto* button = named<QPushButton>(desk.window, "handOn");
  QVERIFY(!button->isEnabled());
  QVERIFY2(button->toolTip().startsWith("Home first"), qPrintable(button->toolTip()));
  QVERIFY(!named<QPushButton>(desk.window, "jogOn")->isEnabled());
}

void TestHand::step_ofAnAxisEndsBeforeItsMargin() {
  const Travel travel{0.0, 0.5, 0.02};
  Jog jog({10.0, 0.2, 0.0, 0.0, travel, 1e-6}, std::make_shared<HandGrip>());
  Sample sample;  // an axis that does what it is told
  sample.angle_rad = 0.4;
  constexpr double tick_s = 1e-3;
  for (int k = 0; k < 10'000 && jog.state() == Procedure::State::running; ++k) {
    const Command command = jog.step(sample);
    sample.velocity_rad_per_s = command.mode == Command::Mode::velocity ? command.target : 0.0;
    sample.angle_rad += sample.velocity_rad_per_s * tick_s;
    sample.time_s += tick_s;
    QVERIFY(sample.angle_rad <= travel.last_m());
  }
  QCOMPARE(jog.state(), Procedure::State::finished);
  QVERIFY2(sample.angle_rad > travel.last_m() - 0.11, qPrintable(QString::number(sample.angle_rad)));
}

JOURNEY_MAIN(TestHand)
#include "tst_hand.moc"
