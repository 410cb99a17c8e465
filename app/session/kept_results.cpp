#include "session/kept_results.h"

#include "base/uuid.h"
#include "report/commission_report.h"
#include "report/diagnosis_report.h"
#include "session/language.h"

namespace breakaway {

KeptResults::KeptResults(Connection& connection, BenchRuns& bench, Comparison& comparison, BenchProject& project,
                         QObject* parent)
    : QObject(parent), bench_(bench), comparison_(comparison), project_(project) {
  connect(&connection, &Connection::runReported, this, &KeptResults::keepRun);
  connect(&comparison, &Comparison::diagnosisChanged, this, &KeptResults::keepDiagnosis);
}

void KeptResults::keepRun(const RunSnapshot& snapshot) {
  const auto* known = std::get_if<KnownPtr>(&snapshot.result);
  if (known == nullptr || *known == nullptr || snapshot.status.state != Procedure::State::finished) return;
  const bool map =
      snapshot.kind == RunKind::breakaway || snapshot.kind == RunKind::velocitySweep || snapshot.kind == RunKind::trial;
  NewRun run;
  run.at = utcNow();
  const KnownPtr done = *known;
  if (map && done->knows(Known::map)) {
    run.kind = "commission";
    run.write = [done, words = wordsOf(spokenLanguage())](const std::string& folder) {
      return writeCommission(*done, {}, folder, words);
    };
    project_.put(run, [this, board = boardName(done->identity)] { emit mapKept(board); });
  } else if (snapshot.kind == RunKind::identification && done->knows(Known::motor)) {
    run.kind = "identification";
    run.write = [done](const std::string& folder) { return writeIdentification(*done, folder); };
    project_.put(run);
  }
}

void KeptResults::keepDiagnosis() {
  const auto& diagnosis = comparison_.diagnosis();
  const auto& bench = comparison_.bench();
  const auto& recording = comparison_.recording();
  if (!diagnosis || !bench || !recording) return;
  NewRun run;
  run.at = utcNow();
  run.motor = bench->motorSerial;
  run.write = [diagnosis = *diagnosis, bench = *bench, recordings = comparison_.recordings(),
               heldout = comparison_.allHeldout(), words = wordsOf(spokenLanguage())](const std::string& folder) {
    return writeDiagnosisFolder(diagnosis, bench, recordings, heldout, folder, words);
  };
  project_.put(run);
}

}  // namespace breakaway
