#include <QTest>
#include <cmath>

#include "base/random.h"
#include "motor/winding_line.h"

using namespace breakaway;

class TestWindingLine : public QObject {
  Q_OBJECT
 private slots:
  void noisyLine_isFoundWithinItsErrors();
  void noCurrent_isReported();
  void fewPoints_areReported();
};

namespace {
std::vector<WindingPoint> points(double R, double V0, double offset, double noise_A, unsigned seed) {
  Noise noise(seed);
  std::vector<WindingPoint> all;
  for (int k = -200; k <= 200; ++k) {
    const double v = 0.6 * k / 200.0;
    const double i = std::copysign(std::max(0.0, std::abs(v) - V0), v) / R;
    all.push_back({v, i + offset + noise_A * noise.normal()});
  }
  return all;
}
}  // namespace

void TestWindingLine::noisyLine_isFoundWithinItsErrors() {
  int inside = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const auto line = fitWindingLine(points(1.2, 0.24, 0.01, 0.003, seed));
    QVERIFY(line.ok());
    QVERIFY(std::abs(line->resistance_ohm.value - 1.2) < 0.05);
    QVERIFY(std::abs(line->deadZone_V.value - 0.24) < 0.01);
    if (line->resistance_ohm.low95() < 1.2 && line->resistance_ohm.high95() > 1.2) ++inside;
  }
  QVERIFY2(inside >= 33 && inside <= 40, qPrintable(QString::number(inside)));
}

void TestWindingLine::noCurrent_isReported() {
  const auto line = fitWindingLine(points(1e6, 0.24, 0.0, 0.003, 1));
  QVERIFY(!line.ok());
}

void TestWindingLine::fewPoints_areReported() {
  QVERIFY(!fitWindingLine({{0.1, 0.1}, {0.2, 0.2}}).ok());
}

QTEST_APPLESS_MAIN(TestWindingLine)
#include "tst_winding_line.moc"
