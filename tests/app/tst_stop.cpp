// Whatever the window does or fails to do, the motor stops.
#include <qcustomplot.h>
#include <sched.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <atomic>
#include <thread>
#include <vector>

#include "app/small_drive.h"
#include "app/window_support.h"
#include "base/numbers.h"
#include "base/thread_glance.h"
#include "recording/csv.h"
#include "session/trigger.h"
#include "session/visible_spectrum.h"
#include "widgets/live_plots.h"

using namespace breakaway;
using namespace breakaway::test;

class TestStop : public QObject {
  Q_OBJECT
 private slots:
  void button_stopsTheMotor();
  void key_stopsTheMotor_data();
  void key_stopsTheMotor();
  void spaceInTypedText_isALetter();
  void escapeInTypedText_stops();
  void returnPressesAButton();
  void blockedWindow_stopsTheMotor();
  void starvedMachine_isToldFromAHungWindow();
  void answeringWindow_keepsItRunning();
  void stop_reachesTheDriveWithin50ms();
  void startPostedBeforeStop_isDropped();
  void pulledCable_isSaid();
  void boardsOwnStop_isSaidInItsWords();
  void lostSamples_areCounted();
  void visibleStretch_isExportedWithEverySample();
  void pausedPicture_staysWhileTheBoardGoesOn();
  void view_standsAtTheTriggersEdge();
  void trigger_takesNoNoiseForAnEdge();
  void spectrum_namesWhatTheRotorDoes();
  void spectrum_leavesOutWhatLiesBeforeAGap();
  void spectrum_followsWhatIsVisible();
  void livePlots_takeThePagesPlace();
};

namespace {

struct Desk {
  explicit Desk(double watchdog_s = 5.0) : session({1.0, 0.005, watchdog_s}), window(session, answers) {
    window.show();
    window.showLive(true);
    session.connection.adopt(std::make_unique<SmallDrive>(witness), "small");
  }
  /// Whether it turns and the window answers in time. A stall of the machine's own counts as one of the window's, also
  /// while the motor starts: then it starts again.
  bool turningUnderAWatch() {
    for (int start = 0; start < 20; ++start) {
      if (!turning()) continue;
      int prompt = 0;
      for (int look = 0; look < 50 && prompt < 3; ++look) {
        const auto asked = std::chrono::steady_clock::now();
        QTest::qWait(20);
        prompt = std::chrono::steady_clock::now() - asked < std::chrono::milliseconds(50) ? prompt + 1 : 0;
      }
      if (prompt == 3 && witness->powered) return true;
    }
    return false;
  }
  bool turning() {
    session.bench.turnSlowly();
    return QTest::qWaitFor([this] { return witness->powered && std::abs(witness->velocity_rad_per_s) > 0.5; }, 5000);
  }
  bool stopped() {
    return QTest::qWaitFor([this] { return !witness->powered && session.connection.stateWords() == "stopped"; }, 5000);
  }

  std::shared_ptr<DriveWitness> witness = std::make_shared<DriveWitness>();
  Answers answers;
  Session session;
  MainWindow window;
};

}  // namespace

void TestStop::button_stopsTheMotor() {
  Desk desk;
  QVERIFY(desk.turning());
  QCOMPARE(desk.witness->stops.load(), 0);
  press(desk.window, "stopButton");
  QVERIFY(desk.stopped());
  QCOMPARE(desk.witness->stops.load(), 1);
}

void TestStop::key_stopsTheMotor_data() {
  QTest::addColumn<int>("key");
  QTest::addColumn<QString>("focus");
  for (const char* focus : {"boardList", "spanBox", "turnButton", "livePlot", "steps", "pauseButton"}) {
    QTest::addRow("Esc in %s", focus) << static_cast<int>(Qt::Key_Escape) << QString(focus);
    QTest::addRow("Space in %s", focus) << static_cast<int>(Qt::Key_Space) << QString(focus);
  }
}

void TestStop::key_stopsTheMotor() {
  QFETCH(int, key);
  QFETCH(QString, focus);
  Desk desk;
  QVERIFY(desk.turning());
  auto* widget = named<QWidget>(desk.window, focus.toLatin1().constData());
  widget->setFocus();
  QTest::keyClick(widget, static_cast<Qt::Key>(key));
  QVERIFY(desk.stopped());
  QCOMPARE(desk.witness->stops.load(), 1);
}

void TestStop::spaceInTypedText_isALetter() {
  Desk desk;
  QVERIFY(desk.turning());
  QLineEdit line(&desk.window);
  line.show();
  QTest::keyClick(&line, Qt::Key_Space);
  QCOMPARE(line.text(), QString(" "));
  QTest::qWait(50);
  QCOMPARE(desk.witness->stops.load(), 0);
}

void TestStop::escapeInTypedText_stops() {
  Desk desk;
  QVERIFY(desk.turning());
  QLineEdit line(&desk.window);
  line.show();
  QTest::keyClick(&line, Qt::Key_Escape);
  QVERIFY(desk.stopped());
}

void TestStop::returnPressesAButton() {
  Desk desk;
  auto* turn = named<QWidget>(desk.window, "turnButton");
  turn->setFocus();
  QTest::keyClick(turn, Qt::Key_Return);
  QTRY_VERIFY(desk.witness->powered.load());
}

void TestStop::blockedWindow_stopsTheMotor() {
  Desk desk(0.25);
  QVERIFY(desk.turningUnderAWatch());
  const auto start = std::chrono::steady_clock::now();
  double took_s = 0.0;
  std::thread looking([&] {
    while (desk.witness->powered && std::chrono::steady_clock::now() - start < std::chrono::seconds(5))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  });
  looking.join();  // this thread is the window's: it answers nothing
  QVERIFY(!desk.witness->powered);
  QVERIFY2(took_s > 0.15 && took_s < 1.0, qPrintable(QString::number(took_s)));
  QTRY_COMPARE(desk.session.connection.stateWords(), QString("stopped by watchdog"));
  QVERIFY(named<QLabel>(desk.window, "messageLine")->text().contains("did not answer for 250 ms"));
}

/// The window's thread has the lowest claim to a processor that others keep busy.
void TestStop::starvedMachine_isToldFromAHungWindow() {
  Desk desk(0.25);
  if (!WatchedThread().ran_s()) QSKIP("the system doesn't tell how a thread fares");
  cpu_set_t before, one;
  QVERIFY(::sched_getaffinity(0, sizeof before, &before) == 0);
  QVERIFY(desk.turningUnderAWatch());
  CPU_ZERO(&one);
  CPU_SET(::sched_getcpu(), &one);
  std::atomic<bool> busy{true};
  std::vector<std::thread> others;
  others.reserve(3);
  for (int k = 0; k < 3; ++k)
    others.emplace_back([&busy, one] {
      ::sched_setaffinity(0, sizeof one, &one);
      const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
      while (busy && std::chrono::steady_clock::now() < until) continue;
    });
  std::thread looking([&] {  // frees the processor when the motor stands
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(8);
    while (desk.witness->powered && std::chrono::steady_clock::now() < until)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    busy = false;
  });
  const sched_param none{};
  const bool last = ::sched_setaffinity(0, sizeof one, &one) == 0 && ::sched_setscheduler(0, SCHED_IDLE, &none) == 0;
  QElapsedTimer clock;
  clock.start();
  while (busy && clock.elapsed() < 8000) QCoreApplication::processEvents();
  looking.join();
  for (std::thread& other : others) other.join();
  const bool back = ::sched_setscheduler(0, SCHED_OTHER, &none) == 0;
  ::sched_setaffinity(0, sizeof before, &before);
  QVERIFY(last && back);
  QVERIFY(!desk.witness->powered);
  QTRY_COMPARE(desk.session.connection.stateWords(), QString("stopped by watchdog"));
  QVERIFY2(named<QLabel>(desk.window, "messageLine")->text().contains("The machine was too busy"),
           qPrintable(named<QLabel>(desk.window, "messageLine")->text()));
}

void TestStop::answeringWindow_keepsItRunning() {
  Desk desk(1.0);
  QVERIFY(desk.turning());
  QTest::qWait(1500);
  QVERIFY(desk.witness->powered);
  QCOMPARE(desk.witness->stops.load(), 0);
}

void TestStop::stop_reachesTheDriveWithin50ms() {
  double best_s = 1.0;
  for (int k = 0; k < 5; ++k) {
    Desk desk;
    QVERIFY(desk.turning());
    const auto start = std::chrono::steady_clock::now();
    desk.session.connection.stop();
    while (desk.witness->stops == 0 && std::chrono::steady_clock::now() - start < std::chrono::seconds(5)) {
    }
    QCOMPARE(desk.witness->stops.load(), 1);
    best_s = std::min(best_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  qInfo("STOP reached the drive after %.1f ms at best", 1e3 * best_s);
  QVERIFY2(best_s < 0.05, qPrintable(QString::number(best_s)));
}

void TestStop::startPostedBeforeStop_isDropped() {
  Desk desk;
  desk.session.bench.turnSlowly();
  desk.session.connection.stop();
  QTRY_VERIFY(desk.witness->stops == 1);
  QTest::qWait(100);
  QVERIFY(!desk.witness->powered);
}

void TestStop::boardsOwnStop_isSaidInItsWords() {
  Desk desk;
  QVERIFY(desk.turning());
  QSignalSpy said(&desk.session.messages, &Messages::said);
  desk.witness->trips = true;
  QVERIFY(
      QTest::qWaitFor([&] { return desk.session.connection.run().status.state == Procedure::State::stopped; }, 5000));
  QVERIFY(desk.session.connection.run().endedByBoard);
  QCOMPARE(said.count(), 1);
  QCOMPARE(said.front().at(0).toString(), QString("over-current: 9.9 A measured"));
  QVERIFY(said.front().at(1).toBool());
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.stateWords() == "stopped by the board"; }, 5000));
  said.clear();
  QVERIFY(desk.turning());
  press(desk.window, "stopButton");
  QVERIFY(desk.stopped());
  QVERIFY(!desk.session.connection.run().endedByBoard);
}

void TestStop::pulledCable_isSaid() {
  Desk desk;
  QVERIFY(desk.turning());
  desk.witness->cableCut = true;
  QTRY_VERIFY(!desk.session.connection.connected());
  QVERIFY(!desk.witness->powered);
  QVERIFY(named<QLabel>(desk.window, "messageLine")->text().contains("the cable was pulled"));
  QCOMPARE(named<QLabel>(desk.window, "deviceLabel")->text(), QString("No board"));
  QVERIFY(!named<QWidget>(desk.window, "turnButton")->isEnabled());
  QCOMPARE(named<QWidget>(desk.window, "turnButton")->toolTip(), QString("No board is connected"));
}

void TestStop::lostSamples_areCounted() {
  Desk desk;
  desk.witness->lose = 3;
  QTRY_VERIFY(named<QLabel>(desk.window, "linkLabel")->text().endsWith(", 3 lost"));
}

void TestStop::visibleStretch_isExportedWithEverySample() {
  Desk desk;
  QTemporaryDir folder;
  const QString path = folder.filePath("visible.csv");
  desk.answers.byTitle["Export the visible stretch"] = path;
  QVERIFY(desk.turning());
  QTest::qWait(300);
  press(desk.window, "pauseButton");
  auto* plots = named<LivePlots>(desk.window, "livePlots");
  QVERIFY(plots->paused());
  press(desk.window, "exportVisibleButton");
  const auto recording = readCsv(path.toStdString());
  QVERIFY2(recording.ok(), recording.ok() ? "" : recording.error().message().c_str());
  const double length_s = recording->time().back() - recording->time().front();
  QVERIFY(length_s > 0.3);
  QCOMPARE(static_cast<double>(recording->rows()), std::round(length_s * 1000.0) + 1.0);
}

void TestStop::pausedPicture_staysWhileTheBoardGoesOn() {
  Desk desk;
  QVERIFY(desk.turning());
  QTest::qWait(300);
  auto* plots = named<LivePlots>(desk.window, "livePlots");
  plots->refresh();
  plots->setPaused(true);
  plots->showCursors(true);
  const LiveHistory& history = desk.session.live.history();
  const QString readings = named<QLabel>(desk.window, "cursorDifference")->toolTip();
  auto* graph = named<QCustomPlot>(desk.window, "livePlot")->graph(0);
  const auto points = [&] {
    return graph->data()->findEnd(plots->to_s(), false) - graph->data()->findBegin(plots->from_s(), false);
  };
  const auto before = points();
  QVERIFY(before > 20);
  // Longer than the history is.
  SampleBatch later;
  for (int k = 1; k <= 7000; ++k) {
    later.samples.push_back(*history.newest());
    later.samples.back().time_s += 0.01 * k;
  }
  desk.session.live.take(later);
  plots->refresh();
  QVERIFY(history.at(history.first()).time_s > plots->to_s());
  QVERIFY2(points() >= before && points() <= before + 2, "at most the last moment's extremes have come");
  QVERIFY2(graph->dataCount() < 20'000, "what is neither seen nor in the history goes");
  QCOMPARE(named<QLabel>(desk.window, "cursorDifference")->toolTip(), readings);
  const QTemporaryDir folder;
  desk.answers.byTitle["Export the visible stretch"] = folder.filePath("visible.csv");
  press(desk.window, "exportVisibleButton");
  QTRY_VERIFY(QFile::exists(folder.filePath("visible.csv")));
  QVERIFY(readCsv(folder.filePath("visible.csv").toStdString())->rows() > 100);
  plots->setPaused(false);
  plots->refresh();
  QVERIFY(plots->to_s() >= history.newest()->time_s - 0.5);
}

void TestStop::view_standsAtTheTriggersEdge() {
  Desk desk;
  QVERIFY(desk.turning());
  auto* plots = named<LivePlots>(desk.window, "livePlots");
  named<QComboBox>(desk.window, "spanBox")->setCurrentIndex(0);  // 2 s
  QVERIFY(!named<QWidget>(desk.window, "triggerLevel")->isVisible());
  named<QComboBox>(desk.window, "triggerMode")->setCurrentIndex(2);
  named<QComboBox>(desk.window, "triggerChannel")->setCurrentIndex(1);
  named<QComboBox>(desk.window, "triggerEdge")->setCurrentIndex(1);
  constexpr double level_rad_per_s = 2.0;
  named<QDoubleSpinBox>(desk.window, "triggerLevel")->setValue(level_rad_per_s);
  QVERIFY(QTest::qWaitFor([&] { return plots->paused(); }, 20'000));
  const double edge_s = plots->from_s() + 0.25 * (plots->to_s() - plots->from_s());
  const LiveHistory& history = desk.session.live.history();
  QVERIFY(history.newest()->time_s >= plots->to_s());  // all that follows the edge has come
  QVERIFY(history.nearest(edge_s - 0.01)->velocity_rad_per_s > level_rad_per_s);
  QVERIFY(history.nearest(edge_s + 0.01)->velocity_rad_per_s < level_rad_per_s);
  const double stands_s = plots->from_s();
  QTest::qWait(100);
  QCOMPARE(plots->from_s(), stands_s);
  press(desk.window, "pauseButton");  // arms it again
  QVERIFY(!plots->paused());
  QVERIFY(QTest::qWaitFor([&] { return plots->paused() && plots->from_s() > stands_s + 1.0; }, 20'000));
}

void TestStop::trigger_takesNoNoiseForAnEdge() {
  Trigger trigger({1.0, true, 0.5, 0.1, false});
  const auto take = [&trigger](double from_s, std::initializer_list<double> values) {
    for (const double value : values) trigger.take(from_s += 0.01, value);
  };
  take(0.0, {2.0, 0.9, 1.1, 0.8, 1.2});  // above at first, and never far enough below
  take(0.1, {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2});
  QVERIFY(!trigger.shown_s());
  take(0.3, {0.4, 0.8, 1.2, 0.9, 1.1});
  QVERIFY(!trigger.shown_s());  // what follows hasn't come yet
  take(0.5, {1.2});
  QVERIFY(trigger.shown_s().has_value());
  QVERIFY(std::abs(*trigger.shown_s() - 0.325) < 1e-9);
  QVERIFY(!trigger.done());
}

namespace {

/// Rows of 1 ms: a rotor at 4.1 turns/s, and three times per turn a current.
std::vector<Sample> rotorSamples(double from_s, size_t rows, double current_A) {
  std::vector<Sample> samples(rows);
  for (size_t k = 0; k < rows; ++k) {
    samples[k].time_s = from_s + 1e-3 * static_cast<double>(k);
    samples[k].angle_rad = turn_rad * 4.1 * samples[k].time_s;
    samples[k].current_A = 0.5 + current_A * std::sin(3.0 * samples[k].angle_rad);
  }
  return samples;
}

double currentOf(const Sample& sample) {
  return sample.current_A;
}

}  // namespace

void TestStop::spectrum_namesWhatTheRotorDoes() {
  LiveHistory history;
  history.append(rotorSamples(0.0, 5000, 0.3));
  const auto spectrum = spectrumOf(evenStretch(history, 1.0, 4.0, currentOf), SpectrumWindow::hann);
  QVERIFY(std::abs(spectrum.length_s - 3.0) < 0.01);
  QVERIFY(std::abs(spectrum.turns_Hz - 4.1) < 0.001);
  const auto peak = highestPeak(spectrum.lines, 1.0, 500.0);
  QVERIFY(peak.has_value());
  QVERIFY2(std::abs(peak->frequency_Hz - 12.3) < 0.01, qPrintable(QString::number(peak->frequency_Hz)));
  QVERIFY2(std::abs(peak->amplitude - 0.3) < 0.003, qPrintable(QString::number(peak->amplitude)));
  const auto drawn = drawnLines(spectrum.lines, 1.0, 500.0, 40);
  QVERIFY(drawn.size() <= 40);
  double highest = 0.0;
  for (const SpectrumPoint& point : drawn) highest = std::max(highest, point.amplitude);
  QVERIFY(highest > 0.25);  // the peak is on the screen
  std::vector<Sample> faster = rotorSamples(5.0, 3000, 0.3);
  for (Sample& sample : faster) sample.angle_rad = turn_rad * (20.5 + 6.0 * (sample.time_s - 5.0));
  history.append(faster);
  QCOMPARE(steadyTurns_Hz(evenStretch(history, 3.0, 8.0, currentOf)), 0.0);
}

void TestStop::spectrum_leavesOutWhatLiesBeforeAGap() {
  LiveHistory history;
  history.append(rotorSamples(0.0, 2000, 5.0));
  history.append(rotorSamples(2.5, 1000, 0.3));
  const auto stretch = evenStretch(history, 0.0, 10.0, currentOf);
  QCOMPARE(stretch.values.size(), size_t{1000});
  QVERIFY(std::abs(stretch.rate_Hz - 1000.0) < 0.01);
  QVERIFY(evenStretch(history, 3.49, 10.0, currentOf).values.empty());  // too few
}

void TestStop::spectrum_followsWhatIsVisible() {
  Desk desk;
  QVERIFY(desk.turning());
  press(desk.window, "spectrumButton");
  auto* channel = named<QComboBox>(desk.window, "spectrumChannel");
  QCOMPARE(channel->count(), 9);
  channel->setCurrentIndex(1);
  const auto* reading = named<QLabel>(desk.window, "spectrumReading");
  QVERIFY2(QTest::qWaitFor([&] { return reading->text().startsWith("Highest ") && reading->text().contains(" rad/s"); },
                           10'000),
           qPrintable(reading->text()));
  channel->setCurrentIndex(channel->findText("Supply"));
  QVERIFY2(QTest::qWaitFor([&] { return !reading->text().contains(" rad/s") && !reading->text().contains("Waits"); },
                           10'000),
           qPrintable(reading->text()));
  press(desk.window, "spectrumButton");
  QVERIFY(!channel->isVisible());
}

void TestStop::livePlots_takeThePagesPlace() {
  Desk desk;
  desk.window.resize(1280, 720);
  desk.window.showPage("handPage");
  desk.window.showLive(true);
  auto* plots = named<LivePlots>(desk.window, "livePlots");
  const auto* page = named<QWidget>(desk.window, "handPage");
  const int small = plots->height();
  press(desk.window, "largeLiveButton");
  QTest::qWait(50);
  QVERIFY(!page->isVisible());
  QVERIFY2(plots->height() > 500, qPrintable(QString::number(plots->height())));
  QCOMPARE(desk.window.size(), QSize(1280, 720));
  QVERIFY(named<QWidget>(desk.window, "stopButton")->isVisible());
  press(desk.window, "largeLiveButton");
  QTest::qWait(50);
  QVERIFY(page->isVisible());
  QCOMPARE(plots->height(), small);
  press(desk.window, "largeLiveButton");
  desk.window.showPage("tunePage");  // whoever goes to a page sees it
  QTest::qWait(1);
  QVERIFY(named<QWidget>(desk.window, "tunePage")->isVisible());
  QVERIFY(!named<QAbstractButton>(desk.window, "largeLiveButton")->isChecked());
}

JOURNEY_MAIN(TestStop)
#include "tst_stop.moc"
