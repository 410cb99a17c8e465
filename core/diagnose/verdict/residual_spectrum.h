// The unexplained torque over frequency: how far the axis answers its drive otherwise than the model does.
#pragma once

#include <vector>

#include "diagnose/verdict/block_maps.h"
#include "diagnose/verdict/unexplained.h"

namespace breakaway {

class ResidualSpectrum {
 public:
  /// Adds a track's whole seconds, the first one being block `firstBlock`; `noise` is that of one position reading.
  void add(const Unexplained& track, double noise, size_t firstBlock);

  struct Band {
    double from_Hz = 0.0, to_Hz = 0.0;
    double torque = 0.0;  ///< root mean square of what goes along with the drive, Nm
    double error = 0.0;   ///< its standard error
    double count = 0.0;   ///< lines of the spectrum
  };
  /// Bands, two per octave; `torque` is 0 where the encoder's noise drowns the rest.
  std::vector<Band> bands() const;
  /// The residual's part that goes along with the drive, one cell for each phase of a band.
  BlockMap map(size_t blocks) const;
  /// The residual's squares over all bands, in the map's unit.
  double total() const;

 private:
  struct Line {
    size_t block;
    double along, across;           ///< residual times drive, in phase and a quarter of a period late
    double drive, residual, noise;  ///< squares
  };
  bool heard(size_t band) const;
  std::vector<std::vector<Line>> lines_;
  double scale_ = 0.0;  ///< from the squares of a line to its part of the mean square
};

}  // namespace breakaway
