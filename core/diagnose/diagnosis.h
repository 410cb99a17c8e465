// What a diagnosis says, and the way to one: the top of the stair.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "base/time_limit.h"
#include "diagnose/fit/scale_check.h"
#include "diagnose/fit/torque_noise.h"
#include "diagnose/model/criteria.h"
#include "diagnose/model/model.h"
#include "diagnose/verdict/finding.h"
#include "diagnose/verdict/fit_score.h"
#include "diagnose/verdict/place.h"
#include "diagnose/verdict/proof.h"
#include "diagnose/verdict/verdict.h"
#include "motor/bench.h"
#include "motor/maneuver.h"
#include "recording/recording.h"

namespace breakaway {

struct Diagnosis {
  Verdict verdict = Verdict::nothingMissing;
  std::vector<Finding> findings;
  std::vector<Place> where;
  FitScore fit;
  Proof proof;
  TorqueNoise wander;  ///< torque that changes at random and has no place
  double unexplainedShare = 0.0;
  double unexplainedPValue = 1.0;
  Message nextSentence;
  std::vector<std::string> nextSeparates;
  Maneuver nextManeuver;  ///< the next experiment as a board can make it; empty where it takes hands
  double named_s = 0.0;
  std::vector<std::string> firstNames;  ///< what the screen named, if it was sure; else the findings
  double elapsed_s = 0.0;
  double cpu_s = 0.0;  ///< of all threads

  Model base;
  Model model;
  /// Held-out stretches of the first recording as [first row, last row + 1); empty with separate held-out recordings.
  std::vector<std::pair<size_t, size_t>> heldoutRows;
  std::vector<Message> remarks;  ///< statements on the input ("12 rows were left out: …")
  /// A column of the wrong scale or sign: then nothing is looked for, and the models are those of the recordings with
  /// that put right.
  std::optional<Misreading> misread;
  bool cutShort = false;  ///< DiagnoseOptions::time was over before all was looked for
  Criteria criteria;      ///< by which it was decided
};

struct DiagnoseOptions {
  unsigned seed = 1;
  double window_s = 0.5;
  Criteria criteria;  ///< by which it decides
  std::stop_token stop;
  TimeLimit time;  ///< the best answer within it
  std::function<void(double progress, const Message& activity)> progress;
};

/// Where simulation and recordings part, which physics was left out, and the proof. Without `heldout`, blocks of the
/// recordings themselves are held out, at least 1 s away from any training sample. Recordings of a wrong scale or sign
/// are undecided (fit/scale_check.h). A pure function of its arguments, apart from the times. Errors: a channel that
/// the bench needs is missing, a recording too short to fit, values that are all missing.
Result<Diagnosis> diagnose(const Bench& bench, const std::vector<Recording>& recordings,
                           const std::vector<Recording>& heldout, const DiagnoseOptions& options);

/// The verdict in one line.
Message headline(const Diagnosis& diagnosis);
/// An effect's name, which files have, as a message.
Message nameOfEffect(const std::string& name);
/// The verdict in words, some lines of plain text.
std::string inWords(const Diagnosis& diagnosis);
/// The text of diagnosis.json, indented or on one line, without a line end.
std::string diagnosisJson(const Diagnosis& diagnosis, bool oneLine);
Result<void> writeDiagnosis(const Diagnosis& diagnosis, const std::string& path);

}  // namespace breakaway
