// Bench jobs on rigs whose wiring fails at some moment, and how far the shaft went astray until that was noticed.
#pragma once

#include <string>
#include <vector>

#include "commission/commission.h"

namespace breakaway::test {

/// A fault of a rig file's `wiring`, and what a job that meets it may say.
struct WiringFault {
  std::string name;                ///< as the rig file has it
  std::string value;               ///< as JSON; empty: none
  std::vector<std::string> words;  ///< any of which names the cause
  bool may = false;                ///< may be measured and be said, and the job go on
  bool atStartOnly = false;        ///< makes no sense once the shaft has turned
  std::string text() const { return value.empty() ? name : name + " " + value; }
};

std::vector<WiringFault> wiringFaults(const std::string& preset);

/// One procedure of the job on a sound rig.
struct StepSpan {
  std::string name;
  double begin_s = 0.0, end_s = 0.0;
  double fastest_rad_per_s = 0.0;  ///< of the shaft
};

/// A short job: few bins, one turn, short runs. Recordings are not kept. With the bench file beside a rig file.
CommissionOptions shortJob(const std::string& rigFile);

std::vector<StepSpan> soundSteps(const std::string& preset, unsigned seed);

/// What came of a job.
struct WiringRun {
  int status = 0;
  std::string words;
  double tripped_s = 0.0;   ///< from the fault, or where motion went astray later from then on
  double beyond_rad = 0.0;  ///< travel beyond what belonged while the winding was driven: faster than the sound rig
                            ///< in this step, or than the reference, or against it
  double beyond_rad_per_s = 0.0;
  bool named = false;
};

/// `from_s` of the rig's time on.
WiringRun runWith(const WiringFault& fault, const std::string& preset, double from_s,
                  const std::vector<StepSpan>& sound, unsigned seed);

/// The same over a pseudo terminal to a board in a process of its own, at the pace that the host grants. Nobody sees
/// its shaft: what went beyond stays 0, and time counts from the fault to the last tick that was driven.
WiringRun runOverTerminal(const WiringFault& fault, const std::string& preset, double from_s, unsigned seed);

}  // namespace breakaway::test
