#include "screenshots.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QListWidget>
#include <QPixmap>
#include <QStyleFactory>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QThread>
#include <functional>

#include "base/atomic_file.h"
#include "main_window.h"
#include "session/resource_folder.h"
#include "session/session.h"
#include "widgets/live_plots.h"
#include "widgets/look.h"

namespace breakaway {

namespace {

using Condition = std::function<bool()>;

/// Nobody is there to answer but with the one path that was prepared, if any.
class PreparedAnswer : public FileChooser {
 public:
  QString path;
  void ask(QWidget*, const FileQuestion&, Answer answer) override {
    if (!path.isEmpty()) answer(path);
  }
};

/// One tour through the window in one palette.
class Tour {
 public:
  Tour(const QString& folder, const QString& theme)
      : folder_(folder), theme_(theme), session_(options()), window_(session_, files_) {
    window_.resize(1366, 768);
    window_.show();
  }

  Result<void> run();

 private:
  static DriveLoopOptions options() { return {4.0, 0.005, 600.0}; }
  bool wait(const Condition& reached, int timeout_ms = 120'000);
  void settle(int time_ms);
  void press(const char* button);
  void shoot(const QString& name);
  void connectBoard();
  void compareProfile();
  void tune();
  void home();
  void sweep();
  void compare();
  void linear();

  QString folder_, theme_;
  PreparedAnswer files_;
  Session session_;
  MainWindow window_;
  QString trouble_;
};

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
  window_.findChild<LivePlots*>()->refresh();
  settle(60);
  const QString path = QString("%1/%2-%3.png").arg(folder_, name, theme_);
  if (!window_.grab().save(path)) trouble_ = path + " cannot be written";
}

Result<void> Tour::run() {
  connectBoard();
  tune();
  home();
  sweep();
  compare();
  window_.showPage("reportPage");
  shoot("report-ready");
  linear();
  if (!trouble_.isEmpty()) return Error{"screenshots", trouble_.toStdString()};
  return {};
}

void Tour::connectBoard() {
  window_.showPage("connectPage");
  shoot("connect-empty");
  session_.connection.open("serial:ttyACM7@921600");
  if (!wait([this] { return session_.connection.state() == ConnectionState::failed; }))
    trouble_ = "a port that isn't there does not fail";
  shoot("connect-failed");
  session_.connection.open("simulated");
  if (!session_.connection.connected()) trouble_ = "the simulated board cannot be opened";
  session_.bench.turnSlowly();
  settle(3200);
  shoot("connect-connected");
  window_.findChild<LivePlots*>()->setPaused(true);
  window_.findChild<LivePlots*>()->showCursors(true);
  shoot("connect-cursors");
  window_.findChild<LivePlots*>()->showCursors(false);
  window_.findChild<LivePlots*>()->setPaused(false);
  compareProfile();
}

void Tour::compareProfile() {
  const QTemporaryDir folder;
  const ControllerSettings before = session_.connection.settings();
  files_.path = folder.filePath("bench 3.profile.json");
  press("saveProfileButton");
  wait([this] { return QFile::exists(files_.path); }, 5000);
  ControllerSettings other = before;
  other.velocity_kp_A_s_per_rad *= 0.6;
  other.observer_cutoff_rad_per_s *= 0.5;
  other.current_limit_A *= 0.8;
  session_.connection.configure(other);
  wait([&] { return session_.connection.settings() == other; }, 5000);
  press("openProfileButton");
  const auto* table = window_.findChild<QTableWidget*>("profileTable");
  wait([&] { return table->rowCount() == 3; }, 5000);
  table->item(0, 0)->setCheckState(Qt::Unchecked);
  table->item(1, 0)->setCheckState(Qt::Unchecked);
  press("restoreProfileButton");
  wait([&] { return !table->item(2, 3)->text().isEmpty(); }, 5000);
  shoot("connect-profile");
  files_.path.clear();
  session_.connection.configure(before);
  wait([&] { return session_.connection.settings() == before; }, 5000);
}

void Tour::tune() {
  window_.showPage("tunePage");
  shoot("tune-empty");
  const ControllerSettings tuned = session_.connection.settings();
  for (const double factor : {0.35, 0.6, 1.0}) {
    ControllerSettings softer = tuned;
    softer.velocity_kp_A_s_per_rad *= factor;
    session_.connection.configure(softer);
    wait([&] { return session_.connection.settings() == softer; }, 5000);
    const size_t before = session_.bench.steps().size();
    press("measureStepButton");
    if (!wait([&] { return session_.bench.steps().size() > before; })) trouble_ = "the velocity step did not end";
  }
  shoot("tune-step");
}

void Tour::home() {
  window_.showPage("homePage");
  shoot("home-ready");
  press("homeButton");
  wait([this] { return session_.connection.runs(RunKind::homing) && session_.connection.run().status.progress > 0.3; },
       5000);
  shoot("home-running");
  session_.connection.setPace(60.0);
  if (!wait([this] { return session_.bench.index_rad().has_value() && !session_.connection.run().running(); }))
    trouble_ = "homing did not end";
  session_.connection.setPace(4.0);
  shoot("home-done");
}

void Tour::sweep() {
  window_.showPage("frictionPage");
  shoot("friction-ready");
  session_.connection.setPace(60.0);
  press("velocitySweepButton");
  if (!wait([this] { return session_.bench.known().knows(Known::runs); })) trouble_ = "the velocity sweep did not end";
  press("breakawaySweepButton");
  const auto share = [this] { return static_cast<double>(session_.bench.known().breakaways.size()) / 720.0; };
  wait([&] { return share() > 0.6; });
  session_.connection.setPace(4.0);
  shoot("friction-running");
  session_.connection.setPace(60.0);
  if (!wait([this] { return session_.bench.known().knows(Known::map) && !session_.connection.run().running(); }))
    trouble_ = "the breakaway sweep did not end";
  session_.connection.setPace(4.0);
  shoot("friction-done");
  auto* view = window_.findChild<QComboBox*>("polarView");
  view->setCurrentIndex(2);
  window_.findChild<QCheckBox*>("radiusFromZero")->setChecked(false);
  shoot("friction-coulomb");
}

void Tour::compare() {
  window_.showPage("comparePage");
  shoot("compare-empty");
  if (resourceFiles("examples", ".bench.json").isEmpty()) return;
  press("openExampleButton");
  if (!wait([this] { return session_.comparison.bench() && session_.comparison.recording(); }))
    trouble_ = "the example cannot be opened";
  shoot("compare-opened");
  press("diagnoseButton");
  shoot("compare-running");
  if (!wait([this] {
        return !session_.comparison.shownTrace().position.empty() && !session_.comparison.baseTrace().position.empty();
      })) {
    trouble_ = "the diagnosis did not end";
    return;
  }
  shoot("compare-diagnosed");
  if (session_.comparison.diagnosis()->where.empty()) return;
  auto* axis = window_.findChild<QComboBox*>("residualAxis");
  window_.findChild<QWidget*>("comparePage")->setFocus();
  axis->setCurrentIndex(
      std::max(0, axis->findData(QString::fromStdString(session_.comparison.diagnosis()->where.front().axis))));
  shoot("compare-where");
}

/// The same way on a linear axis.
void Tour::linear() {
  session_.connection.setPace(4.0);
  window_.showPage("connectPage");
  auto* boards = window_.findChild<QListWidget*>("boardList");
  for (QListWidgetItem* item : boards->findItems("Simulated board: linear", Qt::MatchExactly))
    boards->setCurrentItem(item);
  press("connectButton");
  shoot("connect-linear");
  window_.showPage("homePage");
  shoot("home-linear-ready");
  press("homeButton");
  wait([this] { return session_.connection.runs(RunKind::homing) && session_.connection.run().status.progress > 0.1; },
       10'000);
  shoot("home-linear-running");
  session_.connection.setPace(60.0);
  if (!wait([this] { return session_.bench.index_rad().has_value() && !session_.connection.run().running(); }))
    trouble_ = "the linear axis was not homed";
  session_.connection.setPace(4.0);
  shoot("home-linear-done");
  window_.showPage("tunePage");
  press("measureStepButton");
  if (!wait([&] { return !session_.bench.steps().empty(); })) trouble_ = "the linear axis' step did not end";
  shoot("tune-linear-step");
  window_.showPage("frictionPage");
  shoot("friction-linear-ready");
  session_.connection.setPace(100.0);
  press("velocitySweepButton");
  if (!wait([this] { return session_.bench.known().knows(Known::runs) && !session_.connection.run().running(); }))
    trouble_ = "the linear axis' velocity sweep did not end";
  shoot("friction-linear-coulomb");
  press("breakawaySweepButton");
  wait([this] { return session_.bench.known().breakaways.size() > 432; });
  session_.connection.setPace(4.0);
  shoot("friction-linear-running");
  session_.connection.setPace(100.0);
  if (!wait([this] { return session_.bench.known().knows(Known::map) && !session_.connection.run().running(); }))
    trouble_ = "the linear axis' map did not come";
  session_.connection.setPace(4.0);
  window_.findChild<QComboBox*>("polarView")->setCurrentIndex(1);
  shoot("friction-linear-done");
  window_.showPage("reportPage");
  shoot("report-linear-ready");
}

}  // namespace

Result<void> takeScreenshots(const QString& folder) {
  if (auto made = makeFolder(folder.toStdString()); !made) return made;
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  for (const QString& theme : {QString("light"), QString("dark")}) {
    QApplication::setPalette(theme == "dark" ? darkPalette() : lightPalette());
    Tour tour(folder, theme);
    if (auto done = tour.run(); !done) return done;
  }
  return {};
}

}  // namespace breakaway
