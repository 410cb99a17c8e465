// Noise of a recorded voltage: whether it acted.
#include <QTest>
#include <cmath>

#include "base/numbers.h"
#include "base/random.h"
#include "diagnose/fit/drive_noise.h"
#include "diagnose/fit/read_track.h"

using namespace breakaway;

namespace {

constexpr double noise_V = 0.05;

enum class VoltageNoise { none, acts, isReadOnly };

/// A motor of 20 ms with friction under sines of 6 V, `row_s` from row to row, 4096 counts.
Track recorded(VoltageNoise noise, double row_s, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> time, voltage, angle;
  double position = 0.0, speed = 0.0;
  const double count = turn_rad / 4096.0;
  for (int k = 0; k < static_cast<int>(20.0 / row_s); ++k) {
    const double t = k * row_s, wanted = 4.0 * std::sin(2.0 * t) + 2.0 * std::sin(7.3 * t);
    const double shown = wanted + (noise == VoltageNoise::none ? 0.0 : noise_V * random.normal());
    time.push_back(t);
    voltage.push_back(shown);
    angle.push_back(count * std::floor(position / count));
    for (int part = 0; part < 20; ++part) {
      const double drive = 20.0 * (noise == VoltageNoise::acts ? shown : wanted), way = speed != 0.0 ? speed : drive;
      const double next = speed + row_s / 20.0 * 50.0 * (drive - speed - std::copysign(12.0, way));
      speed = speed != 0.0 && next * speed < 0.0 ? 0.0 : speed == 0.0 && std::abs(drive) < 12.0 ? 0.0 : next;
      position += speed * row_s / 20.0;
    }
  }
  Bench bench;
  bench.input = DriveInput::voltage;
  bench.countsPerUnit = 4096.0;
  return *readTrack(bench, *Recording::seal("t.csv", {{"time_s", time}, {"angle_rad", angle}, {"voltage_V", voltage}}));
}

}  // namespace

class TestDriveNoise : public QObject {
  Q_OBJECT
 private slots:
  void noise_isTheReadingsUnlessItMoved_data();
  void noise_isTheReadingsUnlessItMoved();
};

void TestDriveNoise::noise_isTheReadingsUnlessItMoved_data() {
  QTest::addColumn<double>("row_s");
  QTest::newRow("100 Hz") << 0.01;
  QTest::newRow("500 Hz") << 0.002;
}

void TestDriveNoise::noise_isTheReadingsUnlessItMoved() {
  QFETCH(double, row_s);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    QCOMPARE(recorded(VoltageNoise::none, row_s, seed).inputNoise, 0.0);
    QCOMPARE(recorded(VoltageNoise::acts, row_s, seed).inputNoise, 0.0);
    const double read = recorded(VoltageNoise::isReadOnly, row_s, seed).inputNoise;
    QVERIFY2(std::abs(read - noise_V) < 0.1 * noise_V, qPrintable(QString::number(read)));
  }
}

QTEST_APPLESS_MAIN(TestDriveNoise)
#include "tst_drive_noise.moc"
