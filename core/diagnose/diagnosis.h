// What a diagnosis says: contracts section 4.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/simulate/model.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

enum class Verdict { nothingMissing, named, ambiguous, outsideCatalogue };

struct Finding {
  std::string effect;
  double share = 0.0;  ///< part of the base model's excess squared error over the floor that it takes away, 0 … 1
  double pValue = 1.0;
  std::vector<std::string> ambiguousWith;
  std::vector<Parameter> parameters;
  std::string sentence;
};

/// What a map of the unexplained shows. `friction` is the same torque counted along the motion: what resists whichever
/// way it goes.
enum class Unknown { torque, friction, voltage };

/// A stretch of one axis on which simulation and recording part.
struct Place {
  std::string axis;  ///< time, angle, velocity, acceleration, current, reversal, frequency, temperature
  double from = 0.0;
  double to = 0.0;
  std::string unit;
  double share = 0.0;
  double pValue = 1.0;
  std::string sentence;
  double size = 0.0;            ///< mean of the unexplained there, as an absolute value
  std::string sizeUnit = "Nm";  ///< or N, or V
  Unknown shows = Unknown::torque;
  bool ofSomeSpeeds = false;  ///< it shows there at some speeds only
};

/// RMSE of the position over windows that restart every window_s, as simulate() does it.
struct FitScore {
  std::string channel;
  double window_s = 0.5;
  double trainBefore = 0.0, trainAfter = 0.0;
  double heldoutBefore = 0.0, heldoutAfter = 0.0;
  double improvementLow95 = 0.0, improvementHigh95 = 0.0;
  bool separateRecording = false;
  double floor = 0.0;
};

/// A held-out window.
struct Block {
  std::string recording;
  double start_s = 0.0;              ///< on the recording's clock
  size_t track = 0;                  ///< among the training recordings, then the held-out ones
  double before = 0.0, after = 0.0;  ///< RMSE
};

/// What else the held-out data says.
struct Proof {
  double achieved = 0.0;         ///< (before² − after²)/(before² − floor²)
  double lag1 = 0.0;             ///< autocorrelation, from window to window, of what each window ends with
  double whitenessPValue = 1.0;  ///< that a complete model shows as much of it
  Block worst, typical;          ///< by the error after
};

struct Diagnosis {
  Verdict verdict = Verdict::nothingMissing;
  std::vector<Finding> findings;
  std::vector<Place> where;
  FitScore fit;
  Proof proof;
  double unexplainedShare = 0.0;
  double unexplainedPValue = 1.0;
  std::string nextSentence;
  std::vector<std::string> nextSeparates;
  double named_s = 0.0;
  std::vector<std::string> firstNames;  ///< what the screen named, if it was sure; else the findings
  double elapsed_s = 0.0;

  Model base;
  Model model;
  /// Held-out stretches of the first recording as [first row, last row + 1); empty with separate held-out recordings.
  std::vector<std::pair<size_t, size_t>> heldoutRows;
  std::vector<std::string> remarks;  ///< statements on the input ("12 rows were left out: …")
};

struct DiagnoseOptions {
  unsigned seed = 1;
  double window_s = 0.5;
  std::stop_token stop;
  std::function<void(double progress, const std::string& activity)> progress;
};

/// Where simulation and recordings part, which physics was left out, and the proof. Without `heldout`, blocks of the
/// recordings themselves are held out, at least 1 s away from any training sample. A pure function of its arguments,
/// apart from the two times. Errors: a channel that the bench needs is missing, a recording too short to fit, values
/// that are all missing.
Result<Diagnosis> diagnose(const Bench& bench, const std::vector<Recording>& recordings,
                           const std::vector<Recording>& heldout, const DiagnoseOptions& options);

/// The verdict in words, some lines of plain text.
std::string inWords(const Diagnosis& diagnosis);
/// The contract's name: nothing_missing, named, ambiguous, outside_catalogue.
std::string nameOf(Verdict verdict);
/// The text of diagnosis.json, indented or on one line, without a line end.
std::string diagnosisJson(const Diagnosis& diagnosis, bool oneLine);
Result<void> writeDiagnosis(const Diagnosis& diagnosis, const std::string& path);

}  // namespace breakaway
