#include <QTest>
#include <cmath>

#include "diagnose/diagnosis.h"
#include "diagnose/fit/inverse_fit.h"
#include "diagnose/fit/preparation.h"
#include "diagnose/simulate/simulation.h"
#include "recording/csv.h"
#include "support/real_recordings.h"
#include "support/sanitized.h"
#include "support/temporary.h"
#include "support/within.h"

using namespace breakaway;

/// A. Janot, M. Gautier, M. Brunot, 'Data Set and Reference Models of EMPS', Nonlinear System Identification
/// Benchmarks, 2019: a prismatic axis, force recorded at 1 kHz.
class TestEmpsReal : public QObject {
  Q_OBJECT
 private slots:
  void inverseFit_reproducesThePublishedParameters();
  void diagnosis_namesViscousAsymmetryAndProvesIt();

 private:
  static Bench bench() { return *readBench(test::realRecordings() + "/emps/emps.bench.json"); }
  static Recording recording() { return *readCsv(test::realRecordings() + "/emps/DATA_EMPS.csv"); }
};

namespace {

/// Root mean square position error over 1 s windows in m, rows of the first window left out.
double windowError_m(const Model& model, const Recording& recording) {
  const auto trace = simulate(model, recording, {.restartEvery_s = 1.0});
  if (!trace) qFatal("%s", trace.error().message().c_str());
  const auto position = recording.channel("position_m");
  double squares = 0.0;
  for (size_t k = trace->restarts[1]; k < position.size(); ++k) {
    squares += std::pow(trace->position[k] - position[k], 2);
  }
  return std::sqrt(squares / static_cast<double>(position.size() - trace->restarts[1]));
}

}  // namespace

void TestEmpsReal::inverseFit_reproducesThePublishedParameters() {
  NEEDS_REAL_RECORDINGS();
  const auto prepared = prepare(bench(), {recording()}, {}, 0.5, HeldOut::none);
  VERIFY_OK(prepared);
  Model model = prepared->starts.front();
  model.effects = {{"constant_load", {}}};
  const auto fit = fitInverse(model, prepared->tracks);
  VERIFY_OK(fit);
  const double M = *fit->model.baseValue("mass_kg"), Fv = *fit->model.baseValue("viscous_N_s_per_m"),
               Fc = *fit->model.baseValue("coulomb_N"), offset = fit->model.effects.front().parameters.front().value;
  VERIFY_WITHIN(M, 95.109, 0.01);
  VERIFY_WITHIN(Fv, 203.50, 0.01);
  VERIFY_WITHIN(Fc, 20.394, 0.01);
  VERIFY_WITHIN(offset, -3.165, 0.01);
}

void TestEmpsReal::diagnosis_namesViscousAsymmetryAndProvesIt() {
  NEEDS_REAL_RECORDINGS();
  if (test::sanitized) QSKIP(test::likeOthers);
  const auto diagnosis = diagnose(bench(), {recording()}, {}, {});
  VERIFY_OK(diagnosis);
  QVERIFY2(diagnosis->verdict == Verdict::named, inWords(*diagnosis).c_str());
  bool found = false;
  for (const Finding& finding : diagnosis->findings) found = found || finding.effect == "viscous_asymmetry";
  QVERIFY2(found, inWords(*diagnosis).c_str());
  const FitScore& fit = diagnosis->fit;
  QVERIFY2(fit.improvementLow95 > 0.5 && fit.improvementLow95 < fit.improvementHigh95 && fit.improvementHigh95 < 1.0,
           qPrintable(QString("%1 %2").arg(fit.improvementLow95).arg(fit.improvementHigh95)));

  const double before_mm = 1e3 * windowError_m(diagnosis->base, recording()),
               after_mm = 1e3 * windowError_m(diagnosis->model, recording());
  qInfo("1 s windows: %.3f mm before, %.3f mm after", before_mm, after_mm);
  QVERIFY2(before_mm > 4.3 && before_mm < 4.7, qPrintable(QString::number(before_mm)));
  QVERIFY2(after_mm > 0.1 && after_mm <= 0.48, qPrintable(QString::number(after_mm)));
}

QTEST_APPLESS_MAIN(TestEmpsReal)
#include "tst_emps_real.moc"
