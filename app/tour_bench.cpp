// The tour's stations at the bench: from the first connection to the friction map, and the same on a linear axis.
#include <QAbstractItemView>
#include <QComboBox>
#include <QCoreApplication>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QProcess>
#include <QTableWidget>
#include <cmath>

#include "tour.h"
#include "widgets/live_plots.h"

namespace breakaway {

void Tour::connectBoard() {
  window_.showPage("runsPage");
  shoot("runs-empty");
  window_.showPage("connectPage");
  shoot("connect-empty");
  session_.connection.open("serial:ttyACM7@921600");
  if (!wait([this] { return session_.connection.state() == ConnectionState::failed; }))
    trouble_ = "a port that isn't there does not fail";
  shoot("connect-failed");
  session_.connection.open("simulated:servo");
  if (!session_.connection.connected()) trouble_ = "the simulated board cannot be opened";
  session_.bench.turnSlowly();
  settle(3200);
  shoot("connect-connected");
  compareProfile();
}

void Tour::live() {
  auto* plots = window_.findChild<LivePlots*>();
  window_.showPage("handPage");
  shoot("hand-ready");
  window_.showLive(true);
  settle(200);
  plots->setPaused(true);
  plots->showCursors(true);
  shoot("hand-live");
  plots->showCursors(false);
  plots->setPaused(false);
  auto* mode = window_.findChild<QComboBox*>("triggerMode");
  window_.findChild<QComboBox*>("triggerChannel")->setCurrentIndex(1);
  mode->setCurrentIndex(2);
  if (!wait([&] { return plots->paused(); }, 30'000)) trouble_ = "the trigger finds no edge";
  shoot("hand-trigger");
  plots->showSpectrum(true);
  auto* reading = window_.findChild<QLabel*>("spectrumReading");
  const auto read = [reading] { return reading->text().contains("Hz"); };
  if (!wait(read, 10'000)) trouble_ = "the spectrum has no peak";
  shoot("hand-spectrum");
  press("largeLiveButton");
  settle(400);
  shoot("hand-live-large");
  press("largeLiveButton");
  plots->showSpectrum(false);
  mode->setCurrentIndex(0);
  plots->setPaused(false);
  window_.showLive(false);
  press("logButton");
  shoot("hand-log");
  press("logButton");
}

/// A board in a process of its own, whose cable is pulled while it records, and which comes back.
void Tour::loseLink() {
  const QString program = QCoreApplication::applicationDirPath() + "/breakaway-board";
  if (!QFile::exists(program)) return;
  QProcess board;
  board.start(program, {"--tcp", "0"});
  if (!board.waitForReadyRead(10'000)) {
    trouble_ = "breakaway-board does not begin";
    return;
  }
  const QString uri = QString::fromUtf8(board.readLine()).trimmed();
  session_.connection.open(uri);
  if (!wait([this] { return session_.connection.connected(); }, 20'000)) trouble_ = uri + " cannot be opened";
  window_.showPage("handPage");
  window_.showLive(true);
  session_.bench.turnSlowly();
  press("recordButton");
  settle(4000);
  board.kill();
  board.waitForFinished(5000);
  if (!wait([this] { return !session_.connection.connected(); }, 20'000)) trouble_ = "the lost link isn't noticed";
  shoot("hand-link-lost");
  board.start(program, {"--tcp", uri.section(':', -1)});
  if (!wait([this] { return session_.connection.connected(); }, 20'000)) trouble_ = uri + " does not come back";
  settle(3000);
  shoot("hand-link-back");
  window_.showLive(false);
  session_.connection.close();
  board.kill();
  board.waitForFinished(5000);
  session_.connection.open("simulated:servo");
  session_.bench.turnSlowly();
}

void Tour::compareProfile() {
  const QTemporaryDir folder;
  const ControllerSettings before = session_.connection.settings();
  files_.path = folder.filePath("bench 3.profile.json");
  press("saveProfileButton");
  wait([this] { return QFile::exists(files_.path); });
  ControllerSettings other = before;
  other.velocity_kp_A_s_per_rad *= 0.6;
  other.observer_cutoff_rad_per_s *= 0.5;
  other.current_limit_A *= 0.8;
  session_.connection.configure(other);
  wait([&] { return session_.connection.settings() == other; });
  press("openProfileButton");
  const auto* table = window_.findChild<QTableWidget*>("profileTable");
  if (!wait([&] { return table->rowCount() == 3; })) {
    trouble_ = "the profile is not compared";
    return;
  }
  table->item(0, 0)->setCheckState(Qt::Unchecked);
  table->item(1, 0)->setCheckState(Qt::Unchecked);
  press("restoreProfileButton");
  wait([&] { return !table->item(2, 3)->text().isEmpty(); }, 5000);
  shoot("connect-profile");
  parameters(files_.path);
  files_.path.clear();
  session_.connection.configure(before);
  wait([&] { return session_.connection.settings() == before; }, 5000);
}

/// The board's settings beside Tune: two edits, one of them unticked, and a profile.
void Tour::parameters(const QString& profile) {
  window_.showPage("tunePage");
  window_.showParameters(true);
  shoot("parameters-ready");
  session_.edits.openProfile(profile);
  auto* table = window_.findChild<QTableWidget*>("parametersTable");
  table->item(1, 3)->setText("0.5");
  table->item(9, 3)->setText("2.5");
  table->item(9, 0)->setCheckState(Qt::Unchecked);
  table->setCurrentCell(9, 3);
  shoot("parameters-edited");
  table->item(9, 3)->setText("1000");
  shoot("parameters-refused");
  session_.edits.revertAll();
  for (const char* page : {"identify", "friction", "home"}) {
    window_.showPage(QString("%1Page").arg(page));
    shoot(QString("parameters-%1").arg(page));
  }
  window_.showParameters(false);
  window_.showPage("connectPage");
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
  ControllerSettings edited = session_.connection.settings();
  edited.velocity_kp_A_s_per_rad *= 1.6;
  edited.velocity_ki_A_per_rad = 0.4;
  edited.observer_cutoff_rad_per_s *= 3.0;
  session_.edits.edit(edited);
  settle(300);
  shoot("tune-edited");
  session_.edits.revertAll();
  press("observerNoiseTab");
  shoot("tune-noise");
  press("polesTab");
  press("positionLoopTab");
  const size_t before = session_.bench.steps().size();
  press("measureStepButton");
  if (!wait([&] { return session_.bench.steps().size() > before; })) trouble_ = "the position step did not end";
  shoot("tune-position");
  press("velocityLoopTab");
}

void Tour::identify() {
  window_.showPage("identifyPage");
  shoot("identify-ready");
  press("identifyButton");
  wait([this] { return session_.bench.known().knows(Known::windingTest); });
  shoot("identify-running");
  session_.connection.setPace(60.0);
  if (!wait([this] { return session_.bench.known().knows(Known::motor) && !session_.connection.run().running(); }))
    trouble_ = "the identification did not end";
  session_.connection.setPace(4.0);
  shoot("identify-done");
  for (const char* step : {"Winding", "Spin", "Reversal"}) {
    press(qPrintable(QString("testsOf%1").arg(step)));
    shoot(QString("identify-%1").arg(QString(step).toLower()));
  }
  press("testsOfAll");
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
  layBeneath();
  press("viewCoulomb");
  press("radiusFromZero");
  shoot("friction-coulomb");
}

/// The map that was measured, found again in the project, beneath itself with a tenth more friction everywhere.
void Tour::layBeneath() {
  window_.showPage("runsPage");
  auto* runs = window_.findChild<QAbstractItemView*>("runsTable");
  if (!wait([&] { return runs->model()->rowCount() >= 2; }, 20'000)) trouble_ = "the map is not among the runs";
  runs->setCurrentIndex(runs->model()->index(0, 0));
  settle(300);
  shoot("runs-full");
  KeptMap earlier;
  earlier.run.name = "before greasing";
  earlier.map = session_.bench.known().map;
  for (MapBin& bin : earlier.map.bins)
    for (WayBin& way : bin.way) way.static_Nm.value *= 1.1 + 0.15 * std::cos(bin.angle_rad - 1.0);
  session_.maps.layBeneath(earlier);
  window_.showPage("frictionPage");
  press("viewStatic");
  shoot("friction-beneath");
  session_.maps.layBeneath({});
  press("viewTurns");
}

/// The same way on a linear axis.
void Tour::linear() {
  session_.connection.setPace(4.0);
  window_.showPage("connectPage");
  auto* boards = window_.findChild<QListWidget*>("boardList");
  for (QListWidgetItem* item : boards->findItems("linear", Qt::MatchExactly)) boards->setCurrentItem(item);
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
  press("viewStatic");
  shoot("friction-linear-done");
  report("report-linear-ready");
}

}  // namespace breakaway
