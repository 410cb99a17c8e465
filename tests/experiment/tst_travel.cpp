// The whole job on a linear axis: sound, interrupted, and with every trouble that a rig can play, at every step.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "commission/commission.h"
#include "commission/commission_progress.h"
#include "commission/unfinished_job.h"
#include "experiment/travel_search.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_truth.h"
#include "support/linear_rig.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway;

class TestTravel : public QObject {
  Q_OBJECT
 private slots:
  void bothEnds_areFeltWhereverTheAxisStands_data();
  void bothEnds_areFeltWhereverTheAxisStands();
  void oneThatHuntsAroundTheMiddle_isThere();
  void aClampedAxis_isToldInWords();
  void aLoadThatPressesItAgainstItsEnd_isNamed();
  void troubles_endStoppedAndInWords_data();
  void troubles_endStoppedAndInWords();
  void anInterruptedJob_goesOnWhereItWas_data();
  void anInterruptedJob_goesOnWhereItWas();
  void anIndexlessAxis_countsFromItsLowerEnd();
};

namespace {

constexpr size_t bins = 24;

test::LinearAxis shortAxis() {
  test::LinearAxis axis;
  axis.length_m = 0.12;
  return axis;
}

CommissionOptions quick() {
  CommissionOptions options;
  options.rig = "axis";
  options.sweeps.bins = bins;
  options.sweeps.speedRun_s = 3.0;
  options.keepRecordings = false;
  return options;
}

/// A board on a rig file of its own.
struct Board {
  explicit Board(const test::LinearAxis& axis, unsigned seed = 5) {
    uri = "simulated:" + folder.write("axis.rig.json", test::linearRigText(axis, 7));
    auto opened = openDrive(uri, seed);
    if (!opened) qFatal("%s", opened.error().message().c_str());
    drive = std::move(*opened);
  }
  /// Whether the windings are open a while later.
  bool rests() const {
    std::vector<Sample> samples;
    for (int k = 0; k < 8; ++k) static_cast<void>(drive->advance(0.25, samples));
    return samples.empty() || !samples.back().enabled;
  }

  test::TemporaryFolder folder;
  std::string uri;
  std::unique_ptr<Drive> drive;
};

double worstError(const FrictionMap& map, const FrictionMap& truth, Estimate WayBin::*curve) {
  double worst = 0.0;
  for (size_t w = 0; w < 2; ++w) {
    double squares = 0.0, level = 0.0;
    for (size_t k = 0; k < map.bins.size(); ++k) {
      const double right = (truth.bins[k].way[w].*curve).value;
      squares += std::pow((map.bins[k].way[w].*curve).value - right, 2);
      level += right;
    }
    const auto n = static_cast<double>(map.bins.size());
    worst = std::max(worst, std::sqrt(squares / n) / (level / n));
  }
  return worst;
}

}  // namespace

void TestTravel::bothEnds_areFeltWhereverTheAxisStands_data() {
  QTest::addColumn<double>("start");
  size_t rows = 0;
  QTest::addColumn<bool>("strong");
  for (const double start : {0.02, 0.0, 0.5, 1.0})
    if (test::alsoRun(rows++, 4)) QTest::newRow(std::to_string(start).c_str()) << start << false;
  // The back-EMF of its bounces at the stops is more than the current loop keeps up with: it swings there for ever.
  QTest::newRow("a strong motor") << 0.4 << true;
}

void TestTravel::bothEnds_areFeltWhereverTheAxisStands() {
  QFETCH(double, start);
  QFETCH(bool, strong);
  test::LinearAxis axis = shortAxis();
  axis.start = start;
  if (strong) {
    axis.forceConstant_N_per_A = 64.0;
    axis.mass_kg = 5.2;
    axis.resistance_ohm = 0.9;
    axis.coulomb_N = 9.0;
    axis.supply_V = 36.0;
  }
  const Board board(axis);
  TravelSearchOptions options;
  options.mostLimit_A = board.drive->settings().current_limit_A;
  options.firstLimit_A = 0.02 * options.mostLimit_A;
  options.count_m = 1e-6;
  const auto search = std::make_shared<TravelSearch>(options);
  board.drive->start(search);
  std::vector<Sample> samples;
  double strongest_A = 0.0;
  while (search->state() == Procedure::State::running) {
    samples.clear();
    QVERIFY(board.drive->advance(0.25, samples).ok());
    for (const Sample& sample : samples) strongest_A = std::max(strongest_A, std::abs(sample.current_reference_A));
  }
  QVERIFY2(search->state() == Procedure::State::finished, search->status().failure.c_str());
  // Counted from where it stood at power-up.
  QVERIFY(std::abs(search->travel().low_m + start * 0.12) < 1e-4);
  QVERIFY(std::abs(search->travel().high_m - (1.0 - start) * 0.12) < 1e-4);
  // Gently: friction takes 0.44 A here.
  QVERIFY2(strongest_A < 1.6, qPrintable(QString::number(strongest_A)));
}

/// Between sticking and slipping the loop takes it to and fro by more than what counts as motion, and never comes to
/// rest.
void TestTravel::oneThatHuntsAroundTheMiddle_isThere() {
  TravelSearchOptions options;
  options.mostLimit_A = 5.0;
  options.firstLimit_A = 1.0;
  TravelSearch search(options);
  Sample sample;
  double at_m = 0.03, hunts_m = 0.0;
  for (int k = 0; search.state() != Procedure::State::failed && search.state() != Procedure::State::finished; ++k) {
    sample.time_s = 1e-3 * k;
    sample.angle_rad = at_m + hunts_m;
    const Command command = search.step(sample);
    const double speed = command.mode == Command::Mode::velocity ? command.target : 0.0;
    const bool middle = std::abs(speed) < 0.01 && k > 5000;
    hunts_m = middle ? 6e-4 * std::sin(20.0 * sample.time_s) : 0.0;
    at_m = std::clamp(at_m + 1e-3 * speed, 0.0, 0.12);
  }
  QVERIFY2(search.state() == Procedure::State::finished, search.status().failure.c_str());
  QVERIFY2(sample.time_s < 30.0, qPrintable(QString::number(sample.time_s)));
}

void TestTravel::aClampedAxis_isToldInWords() {
  test::LinearAxis axis = shortAxis();
  axis.more = R"(, "faults": [{"fault": "blocked"}])";
  const Board board(axis);
  const auto done = commission(*board.drive, quick());
  QVERIFY(!done);
  QVERIFY2(done.error().message().find("01-wiring: the axis doesn't move") != std::string::npos,
           done.error().message().c_str());
}

/// A load that comes on the way: it goes forwards with little current, and not back with all of it.
void TestTravel::aLoadThatPressesItAgainstItsEnd_isNamed() {
  TravelSearchOptions options;
  options.mostLimit_A = 5.0;
  options.firstLimit_A = 1.0;
  TravelSearch search(options);
  Sample sample;
  for (int k = 0; search.state() != Procedure::State::failed && k < 60000; ++k) {
    sample.time_s = 1e-3 * k;
    const Command command = search.step(sample);
    const bool forwards = command.mode == Command::Mode::velocity && command.target > 0.0;
    if (forwards) sample.angle_rad = std::min(0.12, sample.angle_rad + 1e-3 * command.target);
  }
  QVERIFY(search.state() == Procedure::State::failed);
  QCOMPARE(
      std::string(search.status().failure.c_str()),
      std::string("the axis went forwards to its end with up to 2 A, but 5 A don't move it backwards again: a load "
                  "presses it there, or something holds it; hold or balance the load, or take it off"));
}

void TestTravel::troubles_endStoppedAndInWords_data() {
  QTest::addColumn<QString>("fault");
  QTest::addColumn<double>("start_s");
  QTest::addColumn<bool>("mayFinish");
  const std::pair<const char*, bool> faults[] = {
      {R"("link_loss", "duration_s": 1)", false},
      {R"("over_current", "current_A": 50, "duration_s": 0.5)", false},
      {R"("blocked")", false},
      {R"("blocked", "position_m": 0.07)", false},
      {R"("encoder_jump", "counts": 1, "duration_s": 0.1)", true},
      {R"("encoder_jump", "counts": -1000, "duration_s": 0.1)", false},
      {R"("index_lost")", false},
      {R"("false_index", "position_m": 0.03)", false},
      {R"("supply_drop", "part": 0.5, "duration_s": 0.5)", false},
      {R"("temperature_drift", "offset_A_per_s": 0.1, "duration_s": 60)", true},
  };
  // In the search for the ends, the winding test, the strokes, and both sweeps.
  size_t rows = 0;
  for (const double start_s : {4.0, 25.0, 47.0, 100.0, 150.0}) {
    for (const auto& [fault, mayFinish] : faults)
      if (test::alsoRun(rows++, 7))
        QTest::addRow("%s at %.0f s", fault, start_s) << QString(fault) << start_s << mayFinish;
  }
}

void TestTravel::troubles_endStoppedAndInWords() {
  QFETCH(QString, fault);
  QFETCH(double, start_s);
  QFETCH(bool, mayFinish);
  test::LinearAxis axis = shortAxis();
  axis.more = ", \"faults\": [{\"fault\": " + fault.toStdString() + ", \"start_s\": " + std::to_string(start_s) + "}]";
  const Board board(axis);
  const auto done = commission(*board.drive, quick());
  if (!done) {
    const std::string words = done.error().message();
    QVERIFY2(words.size() > 20 && words.front() == '0', words.c_str());
  } else {
    QVERIFY2(mayFinish || !done->remarks.empty(), "it went through without a word");
    QVERIFY(mayFinish);
  }
  QVERIFY(board.rests());
}

void TestTravel::anInterruptedJob_goesOnWhereItWas_data() {
  QTest::addColumn<size_t>("breakaways");
  QTest::newRow("amidst a stroke, within one speed") << size_t{0};
  if (!test::sanitized) QTest::newRow("amidst the breakaways") << size_t{10};
}

void TestTravel::anInterruptedJob_goesOnWhereItWas() {
  QFETCH(size_t, breakaways);
  const Board board(shortAxis());
  CommissionOptions options = quick();
  std::optional<Commission> kept;
  options.keepProgress = [&](const Commission& progress) {
    kept = progress;
    return writeProgress(progress, board.folder.path("job"));
  };
  options.keepEvery_s = 0.0;
  options.interrupted = [&] {
    if (!kept || kept->breakaways.size() < breakaways) return false;
    return breakaways > 0 || (kept->strokes.size() == 3 && kept->strokes.back().duration_s > 1.0);
  };
  const auto first = commission(*board.drive, options);
  QVERIFY(!first);
  QVERIFY(kept && kept->knows(Known::motor) && kept->strokes.size() >= 3 && kept->breakaways.size() >= breakaways);
  QVERIFY(board.rests());
  const auto read = readProgress(board.folder.path("job"));
  QVERIFY2(read.ok(), read ? "" : read.error().message().c_str());
  kept = *read;
  QCOMPARE(speedsBrokenOff(*kept), size_t{breakaways > 0 ? 0u : 1u});
  const size_t before = kept->breakaways.size();
  // The board was without power meanwhile: it counts from elsewhere.
  test::LinearAxis moved = shortAxis();
  moved.start = 0.7;
  const Board again(moved, 6);
  CommissionOptions rest = quick();
  rest.earlier = kept;
  rest.earlier->identity.device = again.drive->identity().device;
  const auto done = commission(*again.drive, rest);
  QVERIFY2(done.ok(), done ? "" : done.error().message().c_str());
  QVERIFY(done->events.size() > before);
  if (breakaways == 0) {  // what was left of the speed alone was run
    const TravelRun &begun = done->strokes[2], &rested = done->strokes[3];
    QVERIFY(begun.brokenOff && !rested.brokenOff && rested.isAt(begun.target_m_per_s));
    const auto crossed = [](const TravelBinSums& sum) { return sum.samples > 0; };
    QVERIFY(std::any_of(begun.bins[1].begin(), begun.bins[1].end(), crossed));
    const double pair_s = 2.2 * 0.12 / begun.target_m_per_s;
    QVERIFY2(rested.duration_s < options.sweeps.speedRun_s - begun.duration_s + pair_s,
             qPrintable(QString::number(rested.duration_s)));
  }
  const auto truth = trueMap(again.uri, done->map);
  QVERIFY(truth.ok());
  QVERIFY(worstError(done->map, *truth, &WayBin::static_Nm) < 0.03);
  QVERIFY(worstError(done->map, *truth, &WayBin::coulomb_Nm) < 0.03);
}

void TestTravel::anIndexlessAxis_countsFromItsLowerEnd() {
  test::LinearAxis axis = shortAxis();
  axis.hasIndex = false;
  const Board board(axis);
  const auto done = commission(*board.drive, quick());
  QVERIFY2(done.ok(), done ? "" : done.error().message().c_str());
  QCOMPARE(done->map.bins.size(), bins);
  QVERIFY(done->map.axis == Axis::linear);
  QVERIFY(done->map.bins.front().angle_rad > 0.0 && done->map.bins.back().angle_rad < 0.12);
  const auto truth = trueMap(board.uri, done->map);
  QVERIFY(truth.ok());
  QVERIFY(worstError(done->map, *truth, &WayBin::static_Nm) < 0.03);
  QVERIFY(worstError(done->map, *truth, &WayBin::coulomb_Nm) < 0.03);
  QVERIFY(worstError(done->map, *truth, &WayBin::viscous_Nm_s_per_rad) < 0.08);
  QVERIFY(std::abs(done->motor.inertia_kg_m2.value / 1.8 - 1.0) < 0.02);
  QVERIFY(std::abs(done->motor.resistance_ohm.value / 2.2 - 1.0) < 0.02);
  QVERIFY(std::abs(done->motor.torqueConstant_Nm_per_A.value / 14.0 - 1.0) < 0.02);
  QVERIFY(done->compensatedRun && done->compensatedRun->with_rad_per_s < done->compensatedRun->without_rad_per_s);
  QVERIFY(!done->missed);
  // Left tuned, on the board as in the bench file: the cutoff belongs to the gain.
  const ControllerSettings left = board.drive->settings();
  QVERIFY(done->tunedForUse && done->bench.controller.mode == ControlMode::velocity);
  QCOMPARE(done->bench.controller.kp, left.velocity_kp_A_s_per_rad);
  QCOMPARE(done->bench.controller.observerCutoff_rad_per_s, left.observer_cutoff_rad_per_s);
  const double bandwidth = left.velocity_kp_A_s_per_rad * 14.0 / 1.8;
  QVERIFY2(bandwidth > 20.0 && bandwidth < 200.0, qPrintable(QString::number(bandwidth)));
  QVERIFY(std::abs(left.observer_cutoff_rad_per_s / bandwidth - 10.0 / 3.0) < 0.1);
}

QTEST_APPLESS_MAIN(TestTravel)
#include "tst_travel.moc"
