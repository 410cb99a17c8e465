// The unexplained torque over frequency: how far the axis answers its drive otherwise than the model does.
#pragma once

#include <complex>
#include <vector>

#include "diagnose/fit/unexplained.h"
#include "diagnose/verdict/block_maps.h"

namespace breakaway {

class ResidualSpectrum {
 public:
  /// Adds a track's whole seconds, the first one being block `firstBlock`; `noise` is that of one position reading,
  /// `row_s` the usual time from row to row.
  void add(const Unexplained& track, double noise, double row_s, size_t firstBlock);

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
  /// What the residual is held against. A drive's error (of its sensor, or of what was logged of it) goes along with
  /// the drive, an encoder's with the motion: only what goes along with both is the axis' own.
  enum class Beside { drive, motion };
  /// Squares of the held-out residual, second by second, over the bands that this spectrum hears, before and after what
  /// it foretells is taken off. When in its row a drive acted is not known: what a shift of up to one row explains of
  /// either is taken off first.
  struct Left {
    std::vector<double> before, after;
  };
  Left foretold(const ResidualSpectrum& heldout, Beside beside) const;
  /// Per band what goes along with the drive, per torque of the drive; 0 where it isn't heard.
  std::vector<std::complex<double>> answer() const;
  /// The torque that such an answer makes of a track's drive, instant by instant, Nm.
  static std::vector<double> foretoldTorque(const std::vector<std::complex<double>>& answer, const Unexplained& track);
  /// The residual's squares over all bands, in the map's unit.
  double total() const;

 private:
  struct Line {
    size_t block;
    double along, across;           ///< residual times drive, in phase and a quarter of a period late
    double drive, residual, noise;  ///< squares
    double frequency;               ///< rad/s

    /// The motion's torque is the drive's less the residual.
    std::complex<double> cross(Beside beside) const {
      return std::complex<double>(along, across) - (beside == Beside::motion ? residual : 0.0);
    }
    double squares(Beside beside) const { return beside == Beside::motion ? drive + residual - 2.0 * along : drive; }
    /// Without what a drive that acts `shift_s` earlier than it stands there would leave.
    Line without(double shift_s) const;
  };
  /// The shift that leaves least, at most one row either way, s.
  double shift_s() const;
  bool heard(size_t band) const;
  std::vector<std::vector<Line>> lines_;
  double row_s_ = 0.0;
  double scale_ = 0.0;  ///< from the squares of a line to its part of the mean square
};

}  // namespace breakaway
