// The parts of the table of concealable physics, and what their files share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "trial/trial_effects.h"

namespace breakaway {

std::vector<TrialEffect> frictionEffects();
std::vector<TrialEffect> torqueEffects();
std::vector<TrialEffect> driveEffects();
std::vector<TrialEffect> mechanicalEffects();

/// `what` with the unit of torque or force, of viscous friction, of speed, of stiffness, of the position.
std::string torqueNamed(const std::string& what, const TrialRig& rig);
std::string viscousNamed(const std::string& what, const TrialRig& rig);
std::string speedNamed(const std::string& what, const TrialRig& rig);
std::string stiffnessNamed(const std::string& what, const TrialRig& rig);
std::string positionNamed(const std::string& what, const TrialRig& rig);

/// A wave with an integer order between two bounds and any phase.
Harmonic drawnWave(double amplitude, int lowestOrder, int highestOrder, Random& random);
std::vector<std::pair<std::string, double>> waveTruth(const std::string& amplitudeName, const Harmonic& wave);

}  // namespace breakaway
