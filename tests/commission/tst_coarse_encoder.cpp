#include <QTest>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "commission/commission.h"
#include "commission/sweep_layout.h"
#include "firmware_link/simulated_board.h"
#include "support/linear_rig.h"
#include "support/temporary.h"

using namespace breakaway;

class TestCoarseEncoder : public QObject {
  Q_OBJECT
 private slots:
  void bins_holdWholeCounts();
  void fewCounts_areHomedAndHeld();
  void anAxisThatJumpsFromCountToCount_tellsItsViscousFriction();
};

void TestCoarseEncoder::bins_holdWholeCounts() {
  QCOMPARE(binsOfWholeCounts(14400, 360), size_t{360});
  QCOMPARE(binsOfWholeCounts(4000, 360), size_t{500});  // of two lines; 400 would be of two and a half
  QCOMPARE(binsOfWholeCounts(4096, 360), size_t{256});
  QCOMPARE(binsOfWholeCounts(64, 360), size_t{64});     // of single counts
  QCOMPARE(binsOfWholeCounts(4099, 360), size_t{360});  // a prime
  QCOMPARE(binsOfWholeCounts(0, 360), size_t{360});
}

/// With gains and speeds of a fine encoder the loop swings between its limits and never comes home.
void TestCoarseEncoder::fewCounts_areHomedAndHeld() {
  const auto text = readFile(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/servo.rig.json");
  QVERIFY(text.ok());
  auto rig = nlohmann::json::parse(*text);
  rig["encoder"]["counts_per_rev"] = 256;
  test::TemporaryFolder folder;
  auto drive = openDrive("simulated:" + folder.write("coarse.rig.json", rig.dump()), 1);
  QVERIFY(drive.ok());
  CommissionOptions options;
  options.keepRecordings = false;
  options.sweeps.bins = 32;
  options.sweeps.speedRun_s = 12.0;
  const auto done = commission(**drive, options);
  QVERIFY2(done.ok(), done.ok() ? "" : done.error().message().c_str());
  QCOMPARE(done->runs.size(), size_t{12});
  QVERIFY(std::abs(done->map.coulombAverage_Nm.value - 0.017) < 0.03 * 0.017);
}

/// Slow strokes creep and jump: their mean forces had been taken for those of their mean speeds.
void TestCoarseEncoder::anAxisThatJumpsFromCountToCount_tellsItsViscousFriction() {
  test::LinearAxis axis;
  axis.length_m = 0.3;
  axis.counts_per_m = 4000.0;
  axis.mass_kg = 3.8;
  axis.coulomb_N = 8.3;
  axis.forceConstant_N_per_A = 18.5;
  axis.resistance_ohm = 2.0;
  axis.supply_V = 12.0;
  test::TemporaryFolder folder;
  auto drive = openDrive("simulated:" + folder.write("axis.rig.json", test::linearRigText(axis, 7)), 1);
  QVERIFY(drive.ok());
  CommissionOptions options;
  options.keepRecordings = false;
  options.sweeps.bins = 40;
  options.sweeps.speedRun_s = 12.0;
  const auto done = commission(**drive, options);
  QVERIFY2(done.ok(), done.ok() ? "" : done.error().message().c_str());
  const double viscous = 0.6 * axis.coulomb_N * axis.forceConstant_N_per_A / axis.supply_V;
  const Estimate found = done->map.viscousAverage_Nm_s_per_rad;
  const QString words = QString("%1 ± %2 for %3").arg(found.value).arg(found.standardError).arg(viscous);
  QVERIFY2(std::abs(found.value - viscous) < 0.1 * viscous, qPrintable(words));
  QVERIFY2(std::abs(found.value - viscous) < 3.0 * found.standardError, qPrintable(words));
  const auto leftOut = [](const Message& remark) {
    return std::string(remark.c_str()).find("the axis sticks and slips") != std::string::npos;
  };
  QVERIFY(std::any_of(done->remarks.begin(), done->remarks.end(), leftOut));
}

QTEST_APPLESS_MAIN(TestCoarseEncoder)
#include "tst_coarse_encoder.moc"
