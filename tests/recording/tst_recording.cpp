#include <QTest>
#include <cmath>

#include "recording/recording.h"
#include "support/temporary.h"

using namespace breakaway;

class TestRecording : public QObject {
  Q_OBJECT
 private slots:
  void copies_shareTheirData();
  void unknownChannel_isEmpty();
  void medianStep_ignoresOneGap();
  void unequalLengths_areRefused();
};

void TestRecording::copies_shareTheirData() {
  const auto recording = Recording::seal("r", {{"time_s", {0, 1}}, {"angle_rad", {2, 3}}});
  VERIFY_OK(recording);
  const std::vector<Recording> copies{*recording};
  QCOMPARE(copies[0].channel("angle_rad").data(), recording->channel("angle_rad").data());
  QCOMPARE(copies[0].time()[1], 1.0);
}

void TestRecording::unknownChannel_isEmpty() {
  const auto recording = Recording::seal("r", {{"time_s", {0, 1}}});
  QVERIFY(!recording->has("angle_rad"));
  QVERIFY(recording->channel("angle_rad").empty());
}

void TestRecording::medianStep_ignoresOneGap() {
  const auto recording = Recording::seal("r", {{"time_s", {0, 0.5, 1, 100, 100.5}}});
  QCOMPARE(recording->medianStep_s(), 0.5);
}

void TestRecording::unequalLengths_areRefused() {
  VERIFY_ERROR(Recording::seal("r", {{"time_s", {0, 1}}, {"x", {1}}}), "r, column x: has 1 values, expected 2");
}

QTEST_APPLESS_MAIN(TestRecording)
#include "tst_recording.moc"
