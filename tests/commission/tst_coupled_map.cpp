// A rotor whose encoder and load sit behind a stiff coupling: its map is as good as on one shaft.
#include <QTest>
#include <cmath>

#include "commission/commission.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_truth.h"
#include "support/temporary.h"

using namespace breakaway;

class TestCoupledMap : public QObject {
  Q_OBJECT
 private slots:
  void aStiffCoupling_leavesTheMapWithinItsAims();
};

void TestCoupledMap::aStiffCoupling_leavesTheMapWithinItsAims() {
  auto text = readFile(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/servo.rig.json");
  QVERIFY(text.ok());
  // Half of the rotor goes behind it; both swing against each other at 8000 rad/s.
  const std::string inertia = "\"inertia_kg_m2\": 6e-5";
  QVERIFY(text->find(inertia) != std::string::npos);
  text->replace(text->find(inertia), inertia.size(), "\"inertia_kg_m2\": 3e-5");
  text->replace(text->rfind('}'), 1,
                ", \"coupling\": {\"stiffness_Nm_per_rad\": 960, \"damping_Nm_s_per_rad\": 0.024, "
                "\"load_inertia_kg_m2\": 3e-5}}");
  const test::TemporaryFolder folder;
  const std::string uri = "simulated:" + folder.write("coupled.rig.json", *text);
  auto drive = openDrive(uri, 4);
  QVERIFY2(drive.ok(), drive ? "" : drive.error().message().c_str());
  CommissionOptions options;
  options.rig = "coupled";
  options.sweeps.bins = 36;
  options.sweeps.speedRun_s = 6.0;
  options.keepRecordings = false;
  const auto done = commission(**drive, options);
  QVERIFY2(done.ok(), done ? "" : done.error().message().c_str());
  const auto truth = trueMap(uri, done->map);
  QVERIFY(truth.ok());
  const std::pair<Estimate WayBin::*, double> aims[] = {
      {&WayBin::static_Nm, 0.03}, {&WayBin::coulomb_Nm, 0.03}, {&WayBin::viscous_Nm_s_per_rad, 0.08}};
  for (const auto& [curve, aim] : aims) {
    for (size_t w = 0; w < 2; ++w) {
      double squares = 0.0, level = 0.0;
      for (size_t k = 0; k < options.sweeps.bins; ++k) {
        const double right = (truth->bins[k].way[w].*curve).value;
        squares += std::pow((done->map.bins[k].way[w].*curve).value - right, 2);
        level += right;
      }
      const auto n = static_cast<double>(options.sweeps.bins);
      const double rms = std::sqrt(squares / n) / (level / n);
      QVERIFY2(rms < aim, qPrintable(QString::number(rms)));
    }
  }
  // All that turns.
  QVERIFY(std::abs(done->motor.inertia_kg_m2.value / 6e-5 - 1.0) < 0.02);
}

QTEST_APPLESS_MAIN(TestCoupledMap)
#include "tst_coupled_map.moc"
