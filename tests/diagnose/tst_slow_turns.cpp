// A rotor that falls from one cogging well into the next, with nothing but a measured current to replay it from.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "diagnose/diagnosis.h"
#include "diagnose/fit/torque_residual.h"
#include "motor/bench.h"
#include "recording/csv.h"

using namespace breakaway;

/// The plant, made by another program than ours: cogging of 4.3 mNm, 12 per turn, friction of 1.1 mNm; a speed loop
/// turns it slowly both ways.
class TestSlowTurns : public QObject {
  Q_OBJECT
 private slots:
  void coggingBeyondFriction_isNamed();
};

void TestSlowTurns::coggingBeyondFriction_isNamed() {
  const std::string file =
      (qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/tests/data/diagnose/slow_turns_in_cogging").toStdString();
  const auto bench = readBench(file + ".bench.json");
  const auto recording = readCsv(file + ".csv");
  if (!bench || !recording) qFatal("no data");
  const auto diagnosis = diagnose(*bench, {*recording}, {}, {});
  if (!diagnosis) qFatal("%s", diagnosis.error().message().c_str());
  const std::string words = inWords(*diagnosis);
  // Over half a second no model can foresee which well the rotor falls into: the torque tells.
  QCOMPARE(diagnosis->fit.channel, std::string("torque_Nm"));
  QVERIFY2(diagnosis->fit.improvementLow95 > 0.5, words.c_str());
  QVERIFY2(diagnosis->verdict == Verdict::named || diagnosis->verdict == Verdict::ambiguous, words.c_str());
  QCOMPARE(diagnosis->findings.size(), size_t{1});
  QCOMPARE(diagnosis->findings.front().effect, std::string("cogging"));
  for (const Parameter& one : diagnosis->findings.front().parameters) {
    if (one.name == "order") QCOMPARE(one.value, 12.0);
    if (one.name == "amplitude_Nm") QVERIFY2(std::abs(one.value / 4.3e-3 - 1.0) < 0.15, words.c_str());
  }
  const double coulomb = *diagnosis->model.baseValue("coulomb_Nm");
  QVERIFY2(std::abs(coulomb / 1.1e-3 - 1.0) < 0.15, words.c_str());
  QVERIFY2(*diagnosis->model.baseValue("viscous_Nm_s_per_rad") < 1e-4, words.c_str());

  // The picture over time shows what the number says.
  const auto track = makeTrack(*recording, diagnosis->model.axis, diagnosis->model.input, diagnosis->model.supply_V,
                               diagnosis->model.count);
  for (const auto& [model, counted] :
       {std::pair{&diagnosis->base, diagnosis->fit.heldoutBefore}, {&diagnosis->model, diagnosis->fit.heldoutAfter}}) {
    const TorqueTrace trace = torqueTrace(*model, *track);
    double squares = 0.0;
    size_t instants = 0;
    for (size_t k = 0; k < trace.torque.size(); ++k) {
      const bool isHeldOut = std::any_of(diagnosis->heldoutRows.begin(), diagnosis->heldoutRows.end(), [&](auto& rows) {
        return trace.row[k] >= rows.first && trace.row[k] < rows.second;
      });
      if (!isHeldOut || std::isnan(trace.torque[k])) continue;
      squares += trace.torque[k] * trace.torque[k];
      ++instants;
    }
    const double drawn = std::sqrt(squares / static_cast<double>(instants));
    QVERIFY2(instants > 100 && std::abs(drawn / counted - 1.0) < 0.1,
             qPrintable(QString("drawn %1, counted %2 over %3").arg(drawn).arg(counted).arg(instants)));
  }
}

QTEST_APPLESS_MAIN(TestSlowTurns)
#include "tst_slow_turns.moc"
