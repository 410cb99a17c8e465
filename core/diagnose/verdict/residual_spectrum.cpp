#include "diagnose/verdict/residual_spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr double lowest_Hz = 2.0, highest_Hz = 100.0;
constexpr double bandsPerOctave = 2.0;
constexpr double aboveNoise = 3.0;   ///< so many times the encoder's noise power a band must show
constexpr double leastMotion = 0.7;  ///< part of a second that must be usable

double edge(size_t band) {
  return lowest_Hz * std::exp2(static_cast<double>(band) / bandsPerOctave);
}

/// The band that a frequency lies in; a number beyond all of them below the lowest.
size_t bandOf(double frequency_Hz) {
  if (frequency_Hz < lowest_Hz) return std::numeric_limits<size_t>::max();
  return static_cast<size_t>(bandsPerOctave * std::log2(frequency_Hz / lowest_Hz) + 1e-9);
}

double hann(size_t k, size_t n) {
  return 0.5 - 0.5 * std::cos(turn_rad * (static_cast<double>(k) + 0.5) / static_cast<double>(n));
}

}  // namespace

void ResidualSpectrum::add(const Unexplained& track, double noise, double row_s, size_t firstBlock) {
  row_s_ = std::max(row_s_, row_s);
  const auto n = static_cast<size_t>(std::lround(1.0 / track.step_s));
  const double highest = std::min(highest_Hz, 0.1 / track.step_s);
  if (n < 40) return;
  Eigen::FFT<double> fft;
  std::vector<double> torque(n), drive(n);
  std::vector<std::complex<double>> torqueLines, driveLines;
  for (size_t from = 0; from + n <= track.time.size(); from += n) {
    double moving = 0.0, torqueMean = 0.0, driveMean = 0.0;
    for (size_t k = from; k < from + n; ++k) {
      moving += track.usable[k] != 0 ? 1.0 : 0.0;
      torqueMean += track.torque[k] / static_cast<double>(n);
      driveMean += track.drive[k] / static_cast<double>(n);
    }
    if (moving < leastMotion * static_cast<double>(n)) continue;
    for (size_t k = 0; k < n; ++k) {
      const double window = hann(k, n);
      torque[k] = window * (track.torque[from + k] - torqueMean);
      drive[k] = window * (track.drive[from + k] - driveMean);
    }
    fft.fwd(torqueLines, torque);
    fft.fwd(driveLines, drive);
    const double windowSquares = 0.375 * static_cast<double>(n);
    scale_ = 2.0 / (static_cast<double>(n) * windowSquares);
    for (size_t line = 1; line < n / 2; ++line) {
      const double frequency = static_cast<double>(line) / (static_cast<double>(n) * track.step_s);
      if (frequency < lowest_Hz || frequency >= highest) continue;
      const size_t band = bandOf(frequency);
      if (band >= lines_.size()) lines_.resize(band + 1);
      const std::complex<double> cross = torqueLines[line] * std::conj(driveLines[line]);
      const double slope = 2.0 * std::sin(std::numbers::pi * frequency * track.step_s) / track.step_s;
      const double reading = track.inertia * noise * slope * slope;
      lines_[band].push_back({firstBlock + static_cast<size_t>((static_cast<double>(from) + 0.5) * track.step_s),
                              cross.real(), cross.imag(), std::norm(driveLines[line]), std::norm(torqueLines[line]),
                              reading * reading * windowSquares, turn_rad * frequency});
    }
  }
}

bool ResidualSpectrum::heard(size_t band) const {
  double residual = 0.0, noise = 0.0;
  for (const Line& line : lines_[band]) {
    residual += line.residual;
    noise += line.noise;
  }
  return residual > aboveNoise * noise && residual > 0.0;
}

BlockMap ResidualSpectrum::map(size_t blocks) const {
  BlockMap map;
  map.sums.assign(2 * lines_.size(), std::vector<double>(blocks, 0.0));
  map.count.assign(2 * lines_.size(), 0.0);
  for (size_t band = 0; band < lines_.size(); ++band) {
    if (!heard(band)) continue;
    for (const Line& line : lines_[band]) {
      map.sums[2 * band][line.block] += line.along;
      map.sums[2 * band + 1][line.block] += line.across;
      map.count[2 * band] += line.drive;
    }
    map.count[2 * band + 1] = map.count[2 * band];
  }
  return map;
}

std::vector<ResidualSpectrum::Band> ResidualSpectrum::bands() const {
  std::vector<Band> out;
  size_t blocks = 0;
  for (const auto& band : lines_) {
    for (const Line& line : band) blocks = std::max(blocks, line.block + 1);
  }
  const BlockMap cells = map(blocks);
  for (size_t band = 0; band < lines_.size(); ++band) {
    Band one{.from_Hz = edge(band), .to_Hz = edge(band + 1), .count = static_cast<double>(lines_[band].size())};
    if (const double drive = cells.count[2 * band]; drive > 0.0) {
      // Per second there are so many lines of this part of the mean square.
      const double toTorque = std::sqrt(scale_ / (drive * std::max(1.0, one.count / (one.to_Hz - one.from_Hz))));
      one.torque = toTorque * std::hypot(cells.sum(2 * band), cells.sum(2 * band + 1));
      one.error = toTorque * std::hypot(cells.error(2 * band), cells.error(2 * band + 1)) / std::numbers::sqrt2;
    }
    out.push_back(one);
  }
  return out;
}

ResidualSpectrum::Line ResidualSpectrum::Line::without(double shift_s) const {
  const std::complex<double> gain(0.0, frequency * shift_s), whole(along, across);
  const std::complex<double> left = whole - gain * drive;
  Line out = *this;
  out.along = left.real();
  out.across = left.imag();
  out.residual = std::max(0.0, residual - 2.0 * (std::conj(gain) * whole).real() + std::norm(gain) * drive);
  return out;
}

double ResidualSpectrum::shift_s() const {
  double along = 0.0, squares = 0.0;
  for (size_t band = 0; band < lines_.size(); ++band) {
    if (!heard(band)) continue;
    for (const Line& line : lines_[band]) {
      along += line.frequency * line.across;
      squares += line.frequency * line.frequency * line.drive;
    }
  }
  return squares > 0.0 ? std::clamp(along / squares, -row_s_, row_s_) : 0.0;
}

ResidualSpectrum::Left ResidualSpectrum::foretold(const ResidualSpectrum& heldout, Beside beside) const {
  Left left;
  const double shift = shift_s();
  for (size_t band = 0; band < std::min(lines_.size(), heldout.lines_.size()); ++band) {
    std::complex<double> cross = 0.0;
    double squares = 0.0;
    for (const Line& line : lines_[band]) {
      const Line own = line.without(shift);
      cross += own.cross(beside);
      squares += own.squares(beside);
    }
    const std::complex<double> gain = heard(band) && squares > 0.0 ? cross / squares : 0.0;
    for (const Line& line : heldout.lines_[band]) {
      if (line.block >= left.before.size()) {
        left.before.resize(line.block + 1, 0.0);
        left.after.resize(line.block + 1, 0.0);
      }
      const Line own = line.without(shift);
      const double along = (std::conj(gain) * own.cross(beside)).real();
      left.before[own.block] += own.residual;
      left.after[own.block] += own.residual - 2.0 * along + std::norm(gain) * own.squares(beside);
    }
  }
  return left;
}

std::vector<std::complex<double>> ResidualSpectrum::answer() const {
  std::vector<std::complex<double>> out(lines_.size(), 0.0);
  for (size_t band = 0; band < lines_.size(); ++band) {
    if (!heard(band)) continue;
    std::complex<double> cross = 0.0;
    double squares = 0.0;
    for (const Line& line : lines_[band]) {
      cross += line.cross(Beside::drive);
      squares += line.squares(Beside::drive);
    }
    if (squares > 0.0) out[band] = cross / squares;
  }
  return out;
}

std::vector<double> ResidualSpectrum::foretoldTorque(const std::vector<std::complex<double>>& answer,
                                                     const Unexplained& track) {
  const auto n = 2 * static_cast<size_t>(std::lround(0.5 / track.step_s));
  std::vector<double> out(track.time.size(), 0.0), part(n);
  if (n < 40) return out;
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> lines;
  for (size_t from = 0; from + n <= out.size(); from += n / 2) {  // Hann windows half over each other add up to 1
    for (size_t k = 0; k < n; ++k) part[k] = track.drive[from + k] * hann(k, n);
    fft.fwd(lines, part);
    for (size_t line = 0; line < n; ++line) {
      const size_t alike = std::min(line, n - line);
      const size_t band = bandOf(static_cast<double>(alike) / (static_cast<double>(n) * track.step_s));
      const std::complex<double> gain = band < answer.size() ? answer[band] : 0.0;
      lines[line] *= line <= n / 2 ? gain : std::conj(gain);
    }
    fft.inv(part, lines);
    for (size_t k = 0; k < n; ++k) out[from + k] += part[k];
  }
  return out;
}

double ResidualSpectrum::total() const {
  double sum = 0.0;
  for (const auto& band : lines_) {
    for (const Line& line : band) sum += line.residual;
  }
  return sum;
}

}  // namespace breakaway
