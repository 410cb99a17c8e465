// How sweeps are laid out, around a rotor as over a linear axis' travel.
#pragma once

#include <span>
#include <vector>

#include "commission/known.h"
#include "identify/map_estimation.h"
#include "identify/velocity_friction.h"
#include "identify/zero_track.h"

namespace breakaway {

/// Long enough to bring the zero's noise to 0.3 % of the friction's current, within reason.
double sensorZeroing_s(const Commission& known);

/// Parts of the highest speed that a velocity sweep runs at: `own`, or for another number of speeds from `slowest` on
/// in equal ratios, in an order in which speed and time have little to do with each other.
std::vector<double> speedParts(std::span<const double> own, size_t speeds, double slowest);

/// Relative standard error of the torque constant, common to all torques.
double torqueScaleError(const Commission& known);

/// L/R in s, by which the current comes after the voltage; 0: not known.
double windingTime_s(const Commission& known);

/// Of a rotor, from what is known of its motor.
VelocityFrictionOptions frictionOptions(const Commission& known);

/// What map and breakaways are counted with; the torque constant is that of the current as it is shown.
MapOptions mapOptions(const Commission& known, const std::string& rig);

/// What a sweep has measured beyond the first `before`, counted from the sensor's zero as all its zeroings tell it: a
/// zero is known from the zeroings of its own part alone.
template <typename Measured>
void countFresh(const std::vector<ZeroReading>& zeros, double noiseRms_A, size_t before, std::vector<Measured>& all) {
  countFrom(ZeroTrack(zeros, noiseRms_A), std::span(all).subspan(before));
}

/// As many bins around the rotor as wanted, between half and twice of it so that each holds a whole number of lines, or
/// else of counts: a count more in every few bins would be a wave of its own. A coarse encoder's counts, where they are
/// fewer.
size_t binsOfWholeCounts(double countsPerRev, size_t wanted);

/// Breakaways that are missing, as a remark.
void remarkMissed(Commission& known);

/// What the map's file says beside its numbers: contradictions that the job went on in spite of, and loads on the
/// shaft.
void remarkMap(Commission& known);
/// The map's averages become the motor's, with the current's doubt.
void takeAverages(Commission& known);

}  // namespace breakaway
