#include "base/spectrum.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers.h"
#include "base/random.h"

using namespace breakaway;

class TestSpectrum : public QObject {
  Q_OBJECT
 private slots:
  void sine_hasItsFrequencyAndAmplitude_data();
  void sine_hasItsFrequencyAndAmplitude();
  void weakSine_isFoundBesideAStrongOne();
  void rampAndMean_areNoPeak();
  void noise_isAsMuchAsItsVarianceSays();
  void lengthOfAPrime_isCutToAQuickOne();
  void tooLittle_givesNothing();
};

namespace {

constexpr double rate_Hz = 1000.0;

std::vector<double> sine(size_t rows, double frequency_Hz, double amplitude, double phase_rad) {
  std::vector<double> values(rows);
  for (size_t k = 0; k < rows; ++k)
    values[k] = amplitude * std::sin(turn_rad * frequency_Hz * static_cast<double>(k) / rate_Hz + phase_rad);
  return values;
}

}  // namespace

void TestSpectrum::sine_hasItsFrequencyAndAmplitude_data() {
  QTest::addColumn<int>("window");
  QTest::addColumn<double>("frequency_Hz");
  const char* names[] = {"Hann", "Blackman-Harris", "flat top", "none"};
  for (int window = 0; window < 4; ++window) {
    for (const double frequency_Hz : {20.0, 20.13, 20.25, 20.5, 77.77, 311.4})
      QTest::addRow("%s, %g Hz", names[window], frequency_Hz) << window << frequency_Hz;
  }
}

void TestSpectrum::sine_hasItsFrequencyAndAmplitude() {
  QFETCH(int, window);
  QFETCH(double, frequency_Hz);
  std::vector<double> values = sine(2000, frequency_Hz, 0.25, 0.7);
  for (double& value : values) value += 3.0;
  const auto spectrum = amplitudeSpectrum(values, rate_Hz, static_cast<SpectrumWindow>(window));
  QCOMPARE(spectrum.step_Hz, 0.5);
  QCOMPARE(spectrum.amplitude.size(), size_t{1001});
  const auto peak = highestPeak(spectrum, 5.0, 500.0);
  QVERIFY(peak.has_value());
  QVERIFY2(std::abs(peak->amplitude - 0.25) < 0.01 * 0.25, qPrintable(QString::number(peak->amplitude)));
  QVERIFY2(std::abs(peak->frequency_Hz - frequency_Hz) < 0.02, qPrintable(QString::number(peak->frequency_Hz)));
}

void TestSpectrum::weakSine_isFoundBesideAStrongOne() {
  std::vector<double> values = sine(2000, 40.25, 1.0, 0.0);
  const std::vector<double> weak = sine(2000, 47.1, 1e-3, 1.0);
  for (size_t k = 0; k < values.size(); ++k) values[k] += weak[k];
  const auto peak = highestPeak(amplitudeSpectrum(values, rate_Hz, SpectrumWindow::blackmanHarris), 44.5, 60.0);
  QVERIFY(peak.has_value());
  QVERIFY(std::abs(peak->frequency_Hz - 47.1) < 0.05);
  QVERIFY(std::abs(peak->amplitude - 1e-3) < 1e-5);
  const auto hidden = highestPeak(amplitudeSpectrum(values, rate_Hz, SpectrumWindow::rectangular), 44.5, 60.0);
  QVERIFY(hidden->amplitude > 5e-3);  // by what leaks of the strong one without a window
}

void TestSpectrum::rampAndMean_areNoPeak() {
  std::vector<double> values = sine(1500, 12.0, 0.01, 0.0);
  for (size_t k = 0; k < values.size(); ++k) values[k] += 100.0 + 0.3 * static_cast<double>(k);
  const auto peak = highestPeak(amplitudeSpectrum(values, rate_Hz, SpectrumWindow::hann), 0.0, 500.0);
  QVERIFY(peak.has_value());
  QVERIFY(std::abs(peak->frequency_Hz - 12.0) < 0.05);
  QVERIFY(std::abs(peak->amplitude - 0.01) < 1e-4);
}

void TestSpectrum::noise_isAsMuchAsItsVarianceSays() {
  constexpr std::uint64_t seed = 5;
  qInfo("seed %d", static_cast<int>(seed));
  Random random(seed);
  std::vector<double> values(40000);
  for (double& value : values) value = random.normal();
  const auto spectrum = amplitudeSpectrum(values, rate_Hz, SpectrumWindow::hann);
  double squares = 0.0;
  for (size_t k = 1; k + 1 < spectrum.amplitude.size(); ++k) squares += spectrum.amplitude[k] * spectrum.amplitude[k];
  const double variance = 0.5 * squares / 1.5;  // each line of Hann's is as wide as one and a half
  QVERIFY2(std::abs(variance - 1.0) < 0.04,     // four standard deviations
           qPrintable(QString::number(variance)));
}

void TestSpectrum::lengthOfAPrime_isCutToAQuickOne() {
  const auto spectrum = amplitudeSpectrum(sine(10007, 33.3, 2.0, 0.0), rate_Hz, SpectrumWindow::hann);
  QCOMPARE(spectrum.step_Hz, rate_Hz / 10000.0);
  QVERIFY(std::abs(highestPeak(spectrum, 0.0, 500.0)->amplitude - 2.0) < 0.02);
}

void TestSpectrum::tooLittle_givesNothing() {
  QVERIFY(amplitudeSpectrum(sine(15, 100.0, 1.0, 0.0), rate_Hz, SpectrumWindow::hann).amplitude.empty());
  QVERIFY(amplitudeSpectrum(sine(100, 100.0, 1.0, 0.0), 0.0, SpectrumWindow::hann).amplitude.empty());
  const auto still = amplitudeSpectrum(std::vector<double>(100, 24.1), rate_Hz, SpectrumWindow::hann);
  QCOMPARE(still.amplitude.size(), size_t{51});
  QVERIFY(!highestPeak(still, 0.0, 500.0));
  QVERIFY(!highestPeak(amplitudeSpectrum({}, rate_Hz, SpectrumWindow::hann), 0.0, 500.0));
  QVERIFY(!highestPeak(still, 600.0, 700.0));
}

QTEST_APPLESS_MAIN(TestSpectrum)
#include "tst_spectrum.moc"
