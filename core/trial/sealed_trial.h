// A sealed trial: a rig with concealed physics, recorded; whoever diagnoses it sees bench and recordings only.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

/// What kind of trial: an effect's contract name (that effect alone), or one of the names below.
///   combination  two or three effects of different kinds
///   masked       one effect under a disturbance observer and a stiff loop
///   noisy        one effect under a coarse encoder or noisy current
///   weak         one effect, small
///   low          one effect under an excitation that hardly shows it
///   outside      physics that the catalogue doesn't hold
///   clean        nothing concealed, but a plant that is imperfect in small immaterial ways
///   imperfect    nothing concealed, on a sound rig as they are: torque that wanders, line error, few bits, lost rows
///   rough        one effect on such a rig
std::vector<std::string> trialFamilies();

/// A concealed effect and the plant's own values of it, named as the catalogue names its parameters where they mean the
/// same.
struct Concealed {
  std::string effect;
  std::vector<std::pair<std::string, double>> parameters;
};

struct SealedTrial {
  std::string family;
  std::uint64_t seed = 0;
  Bench bench;                        ///< what the technician believes: off by up to tens of per cent
  std::vector<Recording> recordings;  ///< names "recording.csv", "recording2.csv" …
  std::vector<Recording> heldout;     ///< separately recorded with other excitation; may be empty
  // Sealed until the answer is in:
  std::vector<Concealed> truth;  ///< empty for clean; for outside the plant's own name of the physics
  std::string outside;           ///< what an outside trial conceals; else empty
  double wanderShare = 0.0;      ///< of the Coulomb friction: rms of a torque that changes at random, as any rig's does
  double wander_s = 0.0;         ///< its correlation time
};

/// What of a trial isn't left to chance; 0: drawn.
struct TrialForm {
  double duration_s = 0.0;  ///< of the first recording
  double row_s = 0.0;
};

/// The trial of one family and seed, the same on every machine. Precondition: a name of trialFamilies().
SealedTrial makeTrial(const std::string& family, std::uint64_t seed, const TrialForm& form = {});

/// The family that `breakaway trial --seed N` draws.
std::string familyOf(std::uint64_t seed);

/// Writes bench.json, the recordings and the held-out recordings (heldout.csv …) into a folder.
Result<void> writeTrial(const SealedTrial& trial, const std::string& folder);

}  // namespace breakaway
