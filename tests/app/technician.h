// Who works by the mouse alone and counts the clicks, and what the manual says of them.
#pragma once

#include <QFile>

#include "app/window_support.h"
#include "widgets/rail.h"

namespace breakaway::test {

/// A question for a file, which is answered by the keyboard, is no click.
struct Technician {
  MainWindow& window;
  int clicks = 0;

  void goTo(const QString& step) {
    auto* rail = named<Rail>(window, "steps");
    const QList<QListWidgetItem*> found = rail->findItems(step, Qt::MatchExactly);
    if (found.size() != 1) qFatal("the rail has no step %s", qPrintable(step));
    QTest::mouseClick(rail->viewport(), Qt::LeftButton, {}, rail->visualItemRect(found[0]).center());
    ++clicks;
  }
  void click(const char* button) {
    press(window, button);
    ++clicks;
  }
};

/// The clicks in that row of the manual's table.
inline int clicksSaid(const QString& row) {
  QFile page(qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/resources/help/window.md");
  if (!page.open(QIODevice::ReadOnly)) qFatal("no manual");
  const QString cells = QString::fromUtf8(page.readAll()).section("\n| " + row + " | ", 1).section('\n', 0, 0);
  return cells.section(" | ", 0, 0).toInt();
}

}  // namespace breakaway::test
