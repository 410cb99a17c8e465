// A technician's desk: the window on a simulated board, and the presses that every journey begins with.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QSpinBox>

#include "app/window_support.h"
#include "support/sanitized.h"

namespace breakaway::test {

constexpr int patience_ms = 120'000;
constexpr double hurried = 60.0;  ///< board seconds per wall second
/// Pace of what is to be stopped: a busy machine must not miss the whole of it.
constexpr double unhurried = sanitized ? 5.0 : 10.0;

/// Fast, and without a watchdog that would watch the test machine instead of the window.
struct Desk {
  explicit Desk(double pace = hurried) : session({pace, 0.005, 600.0}), window(session, answers) {
    window.show();
    window.showPage("connectPage");
  }
  bool connected() {
    press(window, "connectButton");
    return session.connection.connected();
  }
  bool homed() {
    window.showPage("homePage");
    press(window, "homeButton");
    return QTest::qWaitFor([this] { return session.bench.index_rad().has_value(); }, patience_ms);
  }
  /// A velocity sweep that is soon over, for what needs one.
  void quickSpeeds() {
    window.showPage("frictionPage");
    named<QSpinBox>(window, "speedCount")->setValue(3);
    named<QDoubleSpinBox>(window, "speedDuration")->setValue(2.0);
  }
  void sweep(int bins, int turns) {
    window.showPage("frictionPage");
    named<QSpinBox>(window, "bins")->setValue(bins);
    named<QSpinBox>(window, "turns")->setValue(turns);
    const bool goesOn = named<QWidget>(window, "continueSweepButton")->isEnabled();
    press(window, goesOn ? "continueSweepButton" : "breakawaySweepButton");
  }
  bool mapComes() {
    return QTest::qWaitFor([this] { return session.bench.known().knows(Known::map); }, patience_ms);
  }
  /// Whether a sweep's map came to its end, and was drawn while it grew.
  bool mapGrows() {
    session.connection.setPace(unhurried);  // else it is over while a busy machine looks elsewhere
    size_t grew = 0, last = 0;
    const bool whole = QTest::qWaitFor(
        [&] {
          const size_t events = session.bench.known().breakaways.size();
          if (events > last) ++grew;
          last = events;
          return session.bench.known().knows(Known::map);
        },
        patience_ms);
    session.connection.setPace(hurried);
    return whole && grew >= 3;
  }
  bool exported(const char* format, const QString& path) {
    answers.byTitle["Export the friction map"] = path;
    auto* box = named<QComboBox>(window, "exportFormat");
    box->setCurrentIndex(box->findData(format));
    press(window, "exportMapButton");
    return QFile(path).size() > 0;
  }

  Answers answers;
  Session session;
  MainWindow window;
};

}  // namespace breakaway::test
