// An encoder's disc off its centre, as a motor shows it that turns freely.
#pragma once

#include <complex>
#include <vector>

#include "experiment/spin_block.h"
#include "identify/encoder_disc.h"

namespace breakaway {

/// A motor under voltage or constant current turns evenly but for what its torque varies by; a disc off its centre
/// shows it swinging once per turn, and a speed's change that it shows in part only makes the inertia look small. Fits
/// the balance of momentum from block to block, i = (J·Δω + C·s·Δt + B·Δθ + what goes with the angle)/Kt, with the
/// disc's swing taken off Δω. Its angle is counted from the blocks' zero. None where it doesn't clearly show, and none
/// that makes the speeds fit the back-EMF worse than without: in few turns, waves of torque and friction pass for a
/// disc's, of which the voltage knows nothing.
EncoderDisc spinDisc(const std::vector<SpinBlock>& blocks);

/// The blocks with the angles where the rotor really was.
std::vector<SpinBlock> freedOf(const EncoderDisc& disc, std::vector<SpinBlock> blocks);

/// ∫e^{jnθ} dt over a block, at even speed.
std::complex<double> waveOver(int order, double from_rad, double to_rad, double duration_s);

}  // namespace breakaway
