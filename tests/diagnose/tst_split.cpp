#include <QTest>
#include <cmath>

#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/inverse_rows.h"
#include "diagnose/fit/motion.h"
#include "diagnose/fit/seen_span.h"
#include "diagnose/fit/split.h"
#include "diagnose/simulate/simulator.h"
#include "diagnose/simulate/track.h"
#include "support/known_servo.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

/// What windows a recording with holes gives.
class TestSplit : public QObject {
  Q_OBJECT
 private slots:
  void rowsThatAreMissing_areInNoWindow();
  void positionsThatWereNotRead_areBridgedOrInNoWindow();
  void middleFifth_canBeHeldOutInPlaceOfTheLast();
  void pushThatEndsUnseen_endsWithTheTrainingData();
  void pauseOfDays_costsNothingAndIsNoMotion();
  void pauseOfAges_isSteppedOver();
  void tooCoarseRows_areOneClearLine();
  void manyShortRecordings_getShortWindows();
  void axisThatStandsInTheProof_provesNothing();
};

namespace {

constexpr double row_s = 1e-3;

/// A swinging axis over 30 s; `keep` says which times have a row and `read` which of these have a position.
template <typename Keep, typename Read>
Track swinging(Keep keep, Read read, double step_s = row_s, size_t rows = 30000) {
  std::vector<double> time, angle, torque;
  for (size_t k = 0; k < rows; ++k) {
    const double t = static_cast<double>(k) * step_s;
    if (!keep(t)) continue;
    time.push_back(t);
    angle.push_back(read(t) ? std::sin(2.0 * t) : std::nan(""));
    torque.push_back(0.01 * std::cos(2.0 * t));
  }
  const auto recording = Recording::seal("holes.csv", {{"time_s", time}, {"angle_rad", angle}, {"torque_Nm", torque}});
  return *makeTrack(*recording, Axis::rotary, DriveInput::torque, {}, 0.0);
}

const auto always = [](double) { return true; };

}  // namespace

void TestSplit::rowsThatAreMissing_areInNoWindow() {
  // Longer than a window, and shorter.
  const auto keep = [](double t) { return !(t > 8.0 && t < 9.7) && !(t > 14.2 && t < 14.4); };
  const std::vector<Track> tracks{swinging(keep, always)};
  const auto split = splitTracks(tracks, 1, 0.5);
  VERIFY_OK(split);
  for (const auto* windows : {&split->train, &split->polish, &split->trainScore, &split->heldoutScore}) {
    QVERIFY(windows->size() > 2);
    for (const Window& window : *windows) {
      QVERIFY(window.first < window.last && window.last < tracks.front().rows());
      for (size_t row = window.first; row < window.last; ++row)
        QVERIFY(tracks.front().time[row + 1] - tracks.front().time[row] < 0.01);
    }
  }
}

void TestSplit::positionsThatWereNotRead_areBridgedOrInNoWindow() {
  const auto read = [](double t) { return !(t > 8.0 && t < 9.7) && std::lround(t / row_s) % 5 != 3; };
  std::vector<Track> tracks{swinging(always, read)};
  bridgePositions(tracks.front(), 0.02);
  const Track& track = tracks.front();
  for (size_t row = 5; row + 5 < track.rows(); ++row) {
    const bool inHole = track.time[row] > 7.99 && track.time[row] < 9.71;
    if (inHole) continue;
    QVERIFY(track.placed(row));
    QVERIFY(std::abs(track.position[row] - std::sin(2.0 * track.time[row])) < 1e-5);
  }
  const auto split = splitTracks(tracks, 1, 0.5);
  VERIFY_OK(split);
  QVERIFY(split->train.size() > 12);
  for (const auto* windows : {&split->train, &split->polish, &split->trainScore}) {
    for (const Window& window : *windows) QVERIFY(track.time[window.last] < 8.11 || track.time[window.first] > 9.69);
  }
}

void TestSplit::middleFifth_canBeHeldOutInPlaceOfTheLast() {
  const std::vector<Track> tracks{swinging(always, always)};
  const std::vector<double>& time = tracks.front().time;
  const double length = time.back();
  const auto split = splitTracks(tracks, 1, 0.5, HeldOut::middle);
  VERIFY_OK(split);
  QVERIFY(split->heldoutScore.size() > 4);
  for (const Window& window : split->heldoutScore)
    QVERIFY(time[window.first] > 0.35 * length && time[window.last] < 0.65 * length);
  bool before = false, after = false;
  for (const auto* windows : {&split->train, &split->polish, &split->trainScore}) {
    for (const Window& window : *windows) {
      before = before || time[window.last] < 0.4 * length;
      after = after || time[window.last] > 0.9 * length;
      for (const Window& kept : split->heldoutScore)
        QVERIFY(time[window.last] < time[kept.first] - 0.99 || time[window.first] > time[kept.last] + 0.99);
    }
  }
  QVERIFY(before && after);
}

void TestSplit::pushThatEndsUnseen_endsWithTheTrainingData() {
  const std::vector<Track> tracks{swinging(always, always)};
  const double length = tracks.front().time.back();
  const auto split = splitTracks(tracks, 1, 0.5);
  VERIFY_OK(split);
  double seen_s = 0.0;
  for (const Window& window : split->polish) seen_s = std::max(seen_s, tracks.front().time[window.last]);
  QVERIFY(seen_s < 0.8 * length);
  Model model;
  model.effects = {test::effectTerm(*findEffect("external_disturbance"), {0.01, 5.0, 2.0 * length})};
  const Model kept = withinSeen(model, tracks, *split);
  QCOMPARE(kept.effects.front().parameters[1].value, 5.0);
  const Parameter& duration = kept.effects.front().parameters[2];
  QVERIFY(std::abs(5.0 + duration.value - seen_s) < 0.01);
  QVERIFY(5.0 + duration.high95 > length - 0.01);  // it may also go on
}

void TestSplit::pauseOfDays_costsNothingAndIsNoMotion() {
  Track track = swinging([](double) { return true; }, [](double) { return true; });
  const size_t whole = inverseRows(track).time.size();
  constexpr double days_s = 1e6;
  for (size_t k = 15000; k < track.rows(); ++k) track.time[k] += days_s;
  const InverseRows rows = inverseRows(track);
  QVERIFY2(rows.time.size() <= whole + 1000, qPrintable(QString::number(rows.time.size())));
  QVERIFY(rows.time.size() > whole);
  QVERIFY(std::abs(rows.time.back() - track.time.back()) < 2.0 * row_s);
  for (size_t k = 0; k < rows.time.size(); ++k) {
    const bool within = rows.time[k] > track.time[14999] + row_s && rows.time[k] < track.time[15000] - row_s;
    QVERIFY(!within || (rows.usable[k] == 0 && rows.moving[k] == 0));
  }
  QCOMPARE(motionOf(track).velocity.size(), track.rows());
  QVERIFY(restartRows(track, 0.5).size() < 100);
}

void TestSplit::pauseOfAges_isSteppedOver() {
  const std::vector<Track> whole{swinging(always, always)};
  std::vector<Track> parted = whole;
  for (const double age_s : {1e3, 1e12, 1e300}) {
    for (size_t k = 15000; k < parted[0].rows(); ++k) parted[0].time[k] = whole[0].time[k] + age_s;
    const auto split = splitTracks(parted, 1, 0.5, HeldOut::none), before = splitTracks(whole, 1, 0.5, HeldOut::none);
    VERIFY_OK(before);
    if (!split) continue;  // where the stamps have no digits left
    QVERIFY(split->polish.size() <= before->polish.size());
    QVERIFY(age_s > 1e6 || split->polish.size() + 8 > before->polish.size());
  }
}

void TestSplit::tooCoarseRows_areOneClearLine() {
  const std::vector<Track> tracks{swinging(always, always, 1000.0, 400)};
  const auto split = splitTracks(tracks, 1, 0.5);
  QVERIFY(!split);
  QCOMPARE(split.error().message(),
           std::string("holes.csv: holds 0 windows of 0.5 s in which no row is missing, expected at least 6; the usual "
                       "step from row to row is 1e+03 s"));
}

/// Three recordings of 6 s with a gap every second: windows of 1 s would hardly find room.
void TestSplit::axisThatStandsInTheProof_provesNothing() {
  for (const double until_s : {20.0, 26.0}) {  // the last six seconds are kept for the proof
    std::vector<double> time, angle, torque;
    for (size_t k = 0; k < 30000; ++k) {
      time.push_back(row_s * static_cast<double>(k));
      angle.push_back(1e-3 * std::round(1e3 * std::sin(2.0 * std::min(time.back(), until_s))));
      torque.push_back(0.01 * std::cos(2.0 * time.back()));
    }
    const auto recording =
        Recording::seal("rests.csv", {{"time_s", time}, {"angle_rad", angle}, {"torque_Nm", torque}});
    const std::vector<Track> tracks{*makeTrack(*recording, Axis::rotary, DriveInput::torque, {}, 0.0)};
    const auto split = splitTracks(tracks, 1, 0.5);
    if (until_s > 25.0) {
      VERIFY_OK(split);
    } else {
      QVERIFY(!split);
      QCOMPARE(split.error().message(), std::string("rests.csv: stands still in all of what is kept for the proof"));
    }
  }
}

void TestSplit::manyShortRecordings_getShortWindows() {
  const auto mostly = [](double t) { return std::fmod(t, 1.4) > 0.06; };
  const std::vector<Track> tracks(3, swinging(mostly, always, row_s, 6000));
  const auto split = splitTracks(tracks, 3, 0.5);
  QVERIFY2(split, split ? "" : split.error().message().c_str());
  const Track& track = tracks.front();
  for (const Window& one : split->train) QVERIFY(track.time[one.last] - track.time[one.first] < 0.6);
}

QTEST_APPLESS_MAIN(TestSplit)
#include "tst_split.moc"
