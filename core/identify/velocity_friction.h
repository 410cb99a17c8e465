// Coulomb and viscous friction, on average and around the rotor, from runs at constant speed.
#pragma once

#include <array>
#include <vector>

#include "base/estimate.h"
#include "base/result.h"
#include "friction/measurements.h"
#include "identify/encoder_disc.h"

namespace breakaway {

struct VelocityFrictionOptions {
  double torqueConstant_Nm_per_A = 0.0;
  double scaleError = 0.0;  ///< relative standard error of the torque constant, common to all torques
  double inertia_kg_m2 = 0.0, inertiaError_kg_m2 = 0.0;  ///< with its standard error
  double noiseRms_A = 0.0;                               ///< of one sample of the current
  double tick_s = 0.0;         ///< of the board, at whose beginning a current is sampled; 0: any time
  double windingTime_s = 0.0;  ///< L/R, by which the current follows a tick's voltage
  double zeroError_A = 0.0;    ///< standard error of the current sensor's zero over the sweep, common to its runs
  size_t bins = 180;           ///< of the result
  size_t highestOrder = 110;   ///< harmonics of Coulomb friction that are looked at: a stepper's steps, a gear's teeth
  size_t highestViscousOrder = 12;
  /// Standard error of a harmonic, part of the mean torque, above which it says nothing of its own: of the current that
  /// keeps the rotor moving, and of the slowest runs that were left out of the line.
  double mostError = 0.02;
  double significance = 2.5;    ///< standard errors by which a harmonic of that current must stand out
  double angleError_rad = 0.0;  ///< standard error of where the index is, common to all runs
  bool evenBins = false;        ///< as wide as each other: they hold whole lines of the encoder (angle_cells.h)
  double beyondBins_rad = 0.0;  ///< by which the runs' samples lie beyond their bins' middles
  EncoderDisc disc;             ///< that the runs' angles and speeds are freed of (fitDisc)
  /// The breakaway map where it is known: whole torque that starts motion per equal bin from the index, by Way. It
  /// tells how far friction can fall with speed, so that slow runs can be freed of it; empty: runs that show it are
  /// left out.
  std::array<std::vector<double>, 2> static_Nm;
};

/// One way around the rotor: whole motor torque at zero speed and its slope, positive in the way's direction, per bin.
struct MovingFriction {
  std::vector<Estimate> coulomb_Nm;
  std::vector<Estimate> viscous_Nm_s_per_rad;
  Estimate coulombMean_Nm;
  Estimate viscousMean_Nm_s_per_rad;
  size_t leftOut = 0;  ///< slowest speeds at which friction still falls with speed: left out, or freed of it
};

/// Per run, current and speed are averaged over angle bins and taken to harmonics of the angle. The motor torque less
/// what accelerates, Kt·i_k − J·(½ω²)'_k, is fitted over the speeds by C_k + B_k·|ω| for each order k, weighted by its
/// own noise, so that fast runs count where the inertia doesn't drown them. With the breakaway map S, slow runs are
/// fitted as C_k + (S_k − C_k)·exp(−(ω/ω_s)²) + B_k·|ω| with one ω_s for both ways (Armstrong-Hélouvry, "Control of
/// Machines with Friction", 1991), a third of that fall being its doubt; and what of S is equal and opposite both ways
/// is expected of C, because cogging holds a moving rotor as it holds a standing one. Which harmonics are there is
/// weighed by how the curve's others are (harmonic_evidence.h); the standard errors hold that doubt. `way`: indexed by
/// Way. Errors: a way with fewer than two speeds.
Result<std::array<MovingFriction, 2>> fitMovingFriction(const std::vector<VelocityRun>& runs,
                                                        const VelocityFrictionOptions& options);

/// Mean current of a run over the angle, positive in its way.
Estimate meanCurrent_A(const VelocityRun& run);

/// Current that keeps it moving in the slowest run of a way, per bin of that run, positive in the way's direction,
/// smoothed to the harmonics up to `highestOrder`; empty when there is no such run.
std::vector<double> movingCurrent_A(const std::vector<VelocityRun>& runs, Way way,
                                    const VelocityFrictionOptions& options);

}  // namespace breakaway
