#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>

#include "base/statistics.h"
#include "diagnose/fit/channel_checks.h"
#include "diagnose/fit/motion.h"
#include "diagnose/fit/preparation.h"
#include "support/driven_recording.h"

using namespace breakaway;

namespace {

Model torqueDriven() {
  Model model;
  model.input = DriveInput::torque;
  model.count = 0.0015;
  model.base = {{"inertia_kg_m2", 6e-5, 6e-5, 6e-5},
                {"viscous_Nm_s_per_rad", 2e-5, 2e-5, 2e-5},
                {"coulomb_Nm", 0.012, 0.012, 0.012}};
  return model;
}

Bench benchOf(const Model& model) {
  Bench bench;
  bench.input = model.input;
  return bench;
}

/// The driven recording after a change of its columns.
Recording changed(const std::function<void(std::vector<Channel>&)>& change) {
  const Recording driven = test::drivenRecording(torqueDriven(), {.seconds = 20.0});
  std::vector<Channel> channels;
  for (const char* name : {"time_s", "angle_rad", "torque_Nm"}) {
    const auto values = driven.channel(name);
    channels.push_back({name, {values.begin(), values.end()}});
  }
  change(channels);
  return *Recording::seal("bench.csv", channels);
}

Preparation prepared(const Recording& recording) {
  auto out = prepare(benchOf(torqueDriven()), {recording}, {}, 0.5);
  if (!out) qFatal("%s", out.error().message().c_str());
  return std::move(*out);
}

std::vector<Message> remarksOf(const Recording& recording) {
  Track track = *makeTrack(recording, Axis::rotary, DriveInput::torque, {}, 0.0015);
  track.leaps = leapsOf(track);
  track.motion = motionOf(track);
  std::vector<Message> remarks = channelRemarks(benchOf(torqueDriven()), recording, track);
  remarks.insert(remarks.end(), track.remarks.begin(), track.remarks.end());
  return remarks;
}

bool says(const std::vector<Message>& remarks, const char* words) {
  return remarks.size() == 1 && remarks.front().find(words) != std::string::npos;
}

void addVelocity(std::vector<Channel>& channels, double sign) {
  const std::vector<double>&time = channels[0].values, &angle = channels[1].values;
  std::vector<double> velocity(time.size(), 0.0);
  for (size_t k = 5; k + 5 < time.size(); ++k)
    velocity[k] = sign * (angle[k + 5] - angle[k - 5]) / (time[k + 5] - time[k - 5]);
  channels.push_back({"velocity_rad_per_s", velocity});
}

}  // namespace

class TestChannelChecks : public QObject {
  Q_OBJECT

 private slots:
  void soundRecording_getsNoRemark();
  void missingRows_areSaidAndTheirWindowsLeftOut();
  void missingRow_isUnknown_whereTheDriveLeaps();
  void longRecording_isFittedOnWindowsOfAllItsParts();
  void timesThatJitter_areStraightened();
  void motionSampledAtIrregularTimes_keepsThem();
  void velocityOfTheWrongSign_isSaid();
  void clippedDrive_isSaid();
  void driveInSteps_isNotCalledClipped();
  void driveThatNeverChanges_isSaid();
  void driveAgainstTheMotion_isSaid();
  void angleThatWrapsOrLeaps_isSaid();
};

void TestChannelChecks::soundRecording_getsNoRemark() {
  const auto remarks = remarksOf(changed([](std::vector<Channel>& channels) { addVelocity(channels, 1.0); }));
  QVERIFY2(remarks.empty(), remarks.empty() ? "" : remarks.front().c_str());
}

void TestChannelChecks::angleThatWrapsOrLeaps_isSaid() {
  constexpr double turn = 6.283185307179586;
  const Recording wrapped = changed([](std::vector<Channel>& channels) {
    for (double& angle : channels[1].values) angle -= turn * std::floor(angle / turn);
  });
  const auto refused = prepare(benchOf(torqueDriven()), {wrapped}, {}, 0.5);
  QVERIFY(!refused);
  QVERIFY(refused.error().message().find("column angle_rad: wraps") != std::string::npos);
  const auto leaping = remarksOf(changed([](std::vector<Channel>& channels) {
    for (size_t k = 9000; k < channels[1].values.size(); ++k) channels[1].values[k] += 40.0;
  }));
  QVERIFY(says(leaping, "within a row in 1 place: bad readings or lost counts"));
}

void TestChannelChecks::missingRows_areSaidAndTheirWindowsLeftOut() {
  const Preparation whole = prepared(changed([](std::vector<Channel>&) {}));
  const Preparation data = prepared(changed([](std::vector<Channel>& channels) {
    for (Channel& one : channels) one.values.erase(one.values.begin() + 5200, one.values.begin() + 5600);
  }));
  QVERIFY(says(data.remarks, "rows are missing in 1 place, for up to 0.401 s"));
  QVERIFY(data.split.train.size() < whole.split.train.size());
  const Track& track = data.tracks.front();
  for (const auto* windows : {&data.split.train, &data.split.trainScore, &data.split.polish}) {
    for (const Window& window : *windows)
      QVERIFY(track.time[window.last] < 5.2 || track.time[window.first] > 5.599 + 0.19);
  }
}

/// A step of the drive may have come in the missing row or after it: unknown for windows that look back on it, too.
/// A row that is missing while the drive holds tells as much as any other.
void TestChannelChecks::missingRow_isUnknown_whereTheDriveLeaps() {
  constexpr size_t leaps = 5200, holds = 9202;  // of a drive that changes every fourth row
  const Recording steps = changed([](std::vector<Channel>& channels) {
    for (Channel& one : channels) {
      for (const size_t row : {holds, leaps}) one.values.erase(one.values.begin() + static_cast<std::ptrdiff_t>(row));
    }
  });
  const Preparation data = prepared(steps);
  const Track& track = data.tracks.front();
  QVERIFY(track.missingInput(leaps - 1) > 0.0);
  QCOMPARE(track.missingInput(holds - 2), 0.0);
  bool across = false;
  for (const Window& window : data.split.train) {
    const double from = track.time[window.first], to = track.time[window.last];
    QVERIFY(to < 5.2 || from > 5.2 + 0.19);
    across = across || (from < 9.2 && to > 9.21);
  }
  QVERIFY(across);
}

void TestChannelChecks::longRecording_isFittedOnWindowsOfAllItsParts() {
  const Recording recording = test::drivenRecording(torqueDriven(), {.seconds = 240.0});
  const Preparation data = prepared(recording);
  size_t rows = 0;
  double last = 0.0, widest = 0.0;
  for (const Window& window : data.split.train) {
    rows += window.last - window.first + 1;
    widest = std::max(widest, data.tracks[0].time[window.first] - last);
    last = data.tracks[0].time[window.last];
  }
  QVERIFY(rows > 80'000 && rows <= 91'000);
  QCOMPARE(data.split.fold.size(), data.split.train.size());
  QVERIFY2(widest < 12.0, qPrintable(QString::number(widest)));  // held-out parts of 6 s lie between
  QVERIFY(last > 220.0);
}

void TestChannelChecks::timesThatJitter_areStraightened() {
  const Recording recording = changed([](std::vector<Channel>& channels) {
    Random random(3);
    for (size_t k = 0; k < channels[0].values.size(); ++k) {
      double& time = channels[0].values[k];
      channels[1].values[k] = 40.0 * std::sin(3.0 * time);
      time += 3e-4 * (2.0 * random.uniform() - 1.0);
    }
  });
  const auto track = makeTrack(recording, Axis::rotary, DriveInput::torque, {}, 0.0);
  QVERIFY(track);
  QVERIFY(says(track->remarks, "its times jitter by up to"));
  for (size_t k = 0; k + 1 < track->rows(); ++k) QVERIFY(std::abs(track->time[k + 1] - track->time[k] - 1e-3) < 1e-6);
}

void TestChannelChecks::motionSampledAtIrregularTimes_keepsThem() {
  const Recording recording = changed([](std::vector<Channel>& channels) {
    Random random(4);
    for (size_t k = 0; k < channels[0].values.size(); ++k) {
      double& time = channels[0].values[k];
      time += 3e-4 * (2.0 * random.uniform() - 1.0);
      channels[1].values[k] = 40.0 * std::sin(3.0 * time);
    }
  });
  const auto track = makeTrack(recording, Axis::rotary, DriveInput::torque, {}, 0.0);
  QVERIFY(track);
  QVERIFY(track->remarks.empty());
  QCOMPARE(track->time[7], recording.time()[7] - recording.time()[0]);
  QVERIFY2(track->noise < 1e-5, qPrintable(QString::number(track->noise)));
}

void TestChannelChecks::velocityOfTheWrongSign_isSaid() {
  QVERIFY(says(remarksOf(changed([](std::vector<Channel>& channels) { addVelocity(channels, -1.0); })),
               "has the opposite sign of the angle's slope"));
}

void TestChannelChecks::clippedDrive_isSaid() {
  QVERIFY(says(remarksOf(changed([](std::vector<Channel>& channels) {
                 for (double& one : channels[2].values) one = std::clamp(one, -0.02, 0.02);
               })),
               "of the rows stand at exactly -0.02 or 0.02"));
}

void TestChannelChecks::driveInSteps_isNotCalledClipped() {
  const auto remarks = remarksOf(changed([](std::vector<Channel>& channels) {
    for (size_t k = 0; k < channels[2].values.size(); ++k) {
      const double levels[] = {0.02, 0.01, -0.015, -0.02, 0.005};
      channels[2].values[k] = levels[k / 400 % 5];
    }
  }));
  const auto clipped = [](const std::string& one) { return one.find("stand at exactly") != std::string::npos; };
  QVERIFY(std::none_of(remarks.begin(), remarks.end(), clipped));
}

void TestChannelChecks::driveThatNeverChanges_isSaid() {
  QVERIFY(says(remarksOf(changed([](std::vector<Channel>& channels) {
                 std::fill(channels[2].values.begin(), channels[2].values.end(), 0.02);
               })),
               "never changes (0.02 throughout)"));
}

void TestChannelChecks::driveAgainstTheMotion_isSaid() {
  QVERIFY(says(remarksOf(changed([](std::vector<Channel>& channels) {
                 for (double& one : channels[2].values) one = -one;
               })),
               "moves against torque_Nm most of the time"));
}

QTEST_GUILESS_MAIN(TestChannelChecks)
#include "tst_channel_checks.moc"
