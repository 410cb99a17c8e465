// From the start to an exported map on a real X server, by its own pointer and keys: what reaches the window there went
// through the server, not through the test. Run by xvfb-run, without a window manager.
#include <QApplication>
#include <QProcess>
#include <QScreen>

#include "app/desk.h"
#include "widgets/closing.h"
#include "widgets/rail.h"

using namespace breakaway;
using namespace breakaway::test;

class TestOnADisplay : public QObject {
  Q_OBJECT
 private slots:
  void newcomer_exportsAMap();
  void aFieldIsTypedIn_andAStepIsChosenByKeys();
};

namespace {

/// What a hand does on the display, each by xdotool.
class Hand {
 public:
  explicit Hand(QWidget& window) : window_(window) {
    window.move(0, 0);
    window.activateWindow();
  }
  bool isAtTheWindow() { return QTest::qWaitForWindowActive(&window_, patience_ms); }

  /// As soon as it can be: whoever clicks waits until the page is there and stands still (what a sweep found moves what
  /// is below).
  void click(const char* button) {
    auto* found = named<QAbstractButton>(window_, button);
    if (!QTest::qWaitFor([&] { return found->isVisible() && found->isEnabled(); }, patience_ms))
      qFatal("%s can't be clicked", button);
    standsStill(*found);
    clickAt(*found, found->rect().center());
  }
  void clickAt(const QWidget& widget, QPoint at) {
    const QPoint place = widget.mapToGlobal(at);
    does({"mousemove", QString::number(place.x()), QString::number(place.y()), "click", "1"});
  }
  void goTo(const QString& step) {
    auto* rail = named<Rail>(window_, "steps");
    const QList<QListWidgetItem*> found = rail->findItems(step, Qt::MatchExactly);
    if (found.size() != 1) qFatal("the rail has no step %s", qPrintable(step));
    clickAt(*rail->viewport(), rail->visualItemRect(found[0]).center());
  }
  void key(const char* name) { does({"key", name}); }
  void type(const char* text) { does({"type", text}); }

 private:
  static void standsStill(const QWidget& widget) {
    for (QPoint last(-1, -1), now = widget.mapToGlobal(QPoint()); now != last; now = widget.mapToGlobal(QPoint())) {
      last = now;
      QTest::qWait(200);
    }
  }
  static void does(const QStringList& words) {
    QProcess hand;
    hand.start("xdotool", words);
    if (!hand.waitForFinished(20'000) || hand.exitCode() != 0)
      qFatal("xdotool: %s", hand.readAllStandardError().constData());
    QTest::qWait(50);  // until the server's event is here
  }

  QWidget& window_;
};

bool until(const std::function<bool()>& so) {
  return QTest::qWaitFor(so, patience_ms);
}

}  // namespace

void TestOnADisplay::newcomer_exportsAMap() {
  QCOMPARE(QGuiApplication::platformName(), QString("xcb"));
  Desk desk;
  Hand hand(desk.window);
  QVERIFY(hand.isAtTheWindow());
  QVERIFY(!restoreLayout(desk.window));  // as at the first start
  const QRect at = desk.window.frameGeometry();
  QVERIFY2(desk.window.screen()->geometry().contains(at),
           qPrintable(QString("%1×%2 at %3, %4").arg(at.width()).arg(at.height()).arg(at.x()).arg(at.y())));
  const Connection& connection = desk.session.connection;
  hand.click("connectButton");
  QVERIFY(until([&] { return connection.connected(); }));
  hand.goTo("Home");
  hand.click("homeButton");
  QVERIFY(until([&] { return desk.session.bench.index_rad().has_value() && !connection.run().running(); }));
  hand.goTo("Friction");
  named<QSpinBox>(desk.window, "bins")->setValue(36);
  named<QSpinBox>(desk.window, "turns")->setValue(2);
  desk.session.connection.setPace(unhurried);  // else it is over while a busy machine looks elsewhere
  hand.click("breakawaySweepButton");
  QVERIFY(until([&] { return desk.session.bench.known().breakaways.size() >= 3; }));
  // A key stops the motor, and what was measured stays.
  hand.key("Escape");
  QVERIFY(until([&] { return !connection.run().running() && connection.stateWords() == "stopped"; }));
  const size_t kept = desk.session.bench.known().breakaways.size();
  QVERIFY(kept >= 3 && !desk.session.bench.known().knows(Known::map));
  desk.session.connection.setPace(hurried);
  hand.click("continueSweepButton");
  QVERIFY(until([&] { return desk.session.bench.known().knows(Known::map) && !connection.run().running(); }));
  QVERIFY(desk.session.bench.known().breakaways.size() > kept);
  const QTemporaryDir folder;
  desk.answers.byTitle["Export the friction map"] = folder.filePath("map.csv");
  hand.click("exportMapButton");
  QVERIFY(until([&] { return QFile(folder.filePath("map.csv")).size() > 0; }));
}

void TestOnADisplay::aFieldIsTypedIn_andAStepIsChosenByKeys() {
  Desk desk;
  Hand hand(desk.window);
  QVERIFY(hand.isAtTheWindow());
  hand.click("connectButton");
  QVERIFY(until([&] { return desk.session.connection.connected(); }));
  hand.goTo("Friction");
  auto* bins = named<QSpinBox>(desk.window, "bins");
  hand.clickAt(*bins, QPoint(12, bins->height() / 2));
  QVERIFY(until([&] { return bins->hasFocus(); }));
  hand.key("ctrl+a");
  hand.type("48");
  hand.key("Tab");
  QVERIFY(until([&] { return bins->value() == 48 && !bins->hasFocus(); }));
  hand.key("ctrl+1");
  QVERIFY(until([&] { return named<Rail>(desk.window, "steps")->currentRow() == 0; }));
}

JOURNEY_MAIN(TestOnADisplay)
#include "tst_on_a_display.moc"
