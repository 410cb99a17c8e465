#include "tour.h"

#include <qcustomplot.h>

#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QListWidget>
#include <QPixmap>
#include <QThread>

#include "widgets/live_plots.h"

namespace breakaway {

namespace {

constexpr Screen screens[] = {
    {{1366, 768}, 1.0, ""}, {{1280, 720}, 1.0, "-1280x720"}, {{3840, 2160}, 2.0, "-3840x2160"}};

}  // namespace

Tour::Tour(const QString& folder, const QString& theme)
    : folder_(folder), theme_(theme), session_(DriveLoopOptions{4.0, 0.005, 600.0}), window_(session_, files_) {
  session_.project.open(project_.path());
  window_.resize(screens[0].size);
  window_.show();
}

Result<void> Tour::run() {
  connectBoard();
  loseLink();
  live();
  tune();
  identify();
  home();
  sweep();
  compare();
  report("report-ready");
  linear();
  sealedTrial();
  if (!trouble_.isEmpty()) return Error{"screenshots", trouble_.toStdString()};
  return {};
}

bool Tour::wait(const Condition& reached, int timeout_ms) {
  QElapsedTimer clock;
  clock.start();
  while (!reached()) {
    if (clock.elapsed() > timeout_ms) return false;
    QApplication::processEvents(QEventLoop::AllEvents, 10);
    QThread::msleep(2);
  }
  return true;
}

void Tour::settle(int time_ms) {
  wait([] { return false; }, time_ms);
}

void Tour::press(const char* button) {
  auto* found = window_.findChild<QAbstractButton*>(button);
  if (found == nullptr || !found->isEnabled()) {
    trouble_ = QString("%1 cannot be pressed").arg(button);
    return;
  }
  found->click();
}

void Tour::shoot(const QString& name) {
  settle(120);
  for (const Screen& screen : screens) shoot(name, screen);
  window_.resize(screens[0].size);
}

void Tour::shoot(const QString& name, const Screen& screen) {
  const QSize size = screen.size / screen.ratio;
  window_.resize(size);
  settle(30);
  for (QCustomPlot* plot : window_.findChildren<QCustomPlot*>()) {
    if (plot->bufferDevicePixelRatio() == screen.ratio) continue;
    plot->setBufferDevicePixelRatio(screen.ratio);
    plot->replot();  // the new buffer holds nothing yet
  }
  window_.findChild<LivePlots*>()->refresh();
  settle(60);
  if (window_.size() != size && trouble_.isEmpty())
    trouble_ = QString("%1: the window grew to %2×%3").arg(name).arg(window_.width()).arg(window_.height());
  QPixmap picture(screen.size);
  picture.setDevicePixelRatio(screen.ratio);
  window_.render(&picture);
  const QString path = QString("%1/%2-%3%4.png").arg(folder_, name, theme_, screen.name);
  if (!picture.save(path)) trouble_ = path + " cannot be written";
}

/// With its preview, which is made beside the window.
void Tour::report(const QString& name) {
  auto* chapters = window_.findChild<QListWidget*>("reportChapters");
  chapters->clear();
  window_.showPage("reportPage");
  if (!wait([&] { return chapters->count() > 0; }, 60'000)) trouble_ = "the report's preview did not come";
  shoot(name);
}

}  // namespace breakaway
