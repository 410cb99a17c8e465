// Compare in a window of its own, with the answers that a person would give its dialogs.
#pragma once

#include <QLabel>
#include <QTest>

#include "app/technician.h"
#include "app/window_support.h"
#include "main_window.h"
#include "session/session.h"

namespace breakaway::test {

inline constexpr int patience_ms = 240'000;

struct Desk {
  explicit Desk(double pace = 1.0) : session({pace, 0.005, 600.0}), window(session, answers) {
    window.show();
    window.showPage("comparePage");
  }
  bool opened(const QString& bench, const QString& recording) {
    answers.byTitle["Open a bench"] = bench;
    answers.byTitle["Open a recording"] = recording;
    press(window, "openBenchButton");
    press(window, "openRecordingButton");
    return ready();
  }
  bool ready() {
    return QTest::qWaitFor([this] { return session.comparison.bench() && session.comparison.recording(); },
                           patience_ms);
  }
  /// `soon`: finished at once, with what was found by then.
  bool diagnosed(bool soon = false) {
    press(window, "diagnoseButton");
    if (soon) press(window, "finishButton");
    return QTest::qWaitFor(
        [this] {
          return !session.comparison.baseTrace().position.empty() && !session.comparison.shownTrace().position.empty();
        },
        patience_ms);
  }
  QString text(const char* name) { return named<QLabel>(window, name)->text(); }

  Answers answers;
  Session session;
  MainWindow window;
};

}  // namespace breakaway::test
