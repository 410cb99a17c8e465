// Whether recordings hold what their columns say: a wrong scale or sign fits as well as the right one, and says nothing
// of itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/model/criteria.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

/// A column, or the bench's torque constant, in another scale or of another sign than it says.
struct Misreading {
  std::string what;      ///< "angle_rad", or the bench's field
  bool ofBench = false;  ///< `what` is the bench's
  double factor = 1.0;   ///< what stands there over what is true; −1: the sign
  std::string sentence;  ///< with the evidence, and the mistake that it looks like
  std::string mended;    ///< "angle_rad divided by 4"
  bool operator==(const Misreading&) const = default;
};

struct ScaleCheck {
  std::optional<Misreading> misread;  ///< beyond its doubt and beyond what a bench may be wrong by
  std::vector<std::string> remarks;   ///< beliefs of the bench that contradict the recordings without such a name
};

/// In SI a torque constant is the back-EMF constant, so that voltage, current and motion together tell a wrong scale by
/// the one constant that the bench says; resistance and inertia tell more, each as far as the bench can be trusted
/// (motor/beliefs.h). One column may be wrong, in all recordings alike. Energy tells signs: over a recording friction
/// takes what the drive gives. Errors: as prepare() of unusable recordings.
Result<ScaleCheck> checkScales(const Bench& bench, const std::vector<Recording>& recordings,
                               const Criteria& criteria = {});

/// The recording, or the bench, with what was misread put right.
Recording mended(const Recording& recording, const Misreading& misread);
std::vector<Recording> mended(std::vector<Recording> recordings, const std::optional<Misreading>& misread);
Bench mended(Bench bench, const Misreading& misread);

}  // namespace breakaway
