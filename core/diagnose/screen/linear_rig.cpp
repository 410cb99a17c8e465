#include "diagnose/screen/linear_rig.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "dense/dense_solve.h"
#include "diagnose/simulate/drive_reading.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr size_t mostRows = 5000;
constexpr size_t fewestSamples = 10;
constexpr double inductanceDoubt = 0.5;  ///< relative
constexpr double partOfResidual = 0.09;
constexpr double mostRatio = 1e7, coarseFactor = 8.0;  ///< of wander, in units of a reading's noise
constexpr double startDoubt_s = 0.01, longestStart_s = 0.1;
constexpr double shownReadings = 12.0;  ///< of noise: motion that shows
constexpr size_t turnMargin = 2;        ///< samples left out on each side of a reversal

}  // namespace

RecordedMotions recordedMotions(const Model& base, const std::vector<Track>& tracks) {
  const Physics physics = physicsOf(base);
  auto motions = std::make_shared<std::vector<RecordedMotion>>();
  for (const Track& track : tracks) motions->emplace_back(track, physics);
  return motions;
}

LinearRig::LinearRig(const Model& base, const std::vector<Track>& tracks, const std::vector<Window>& windows,
                     Torque torque, RecordedMotions recorded)
    : tracks_(tracks),
      physics_(physicsOf(base)),
      torque_(torque),
      motions_(recorded ? std::move(recorded) : recordedMotions(base, tracks)),
      recorded_(*motions_),
      windows_(windows.size()) {
  currentSeen_ = physics_.electrical && std::all_of(windows.begin(), windows.end(), [&](const Window& window) {
                   return !tracks[window.track].current.empty();
                 });
  gain_ = physics_.torquePerInput();
  cut(windows);

  const Eigen::Index baseColumns = 3 + (physics_.gravity > 0.0 ? 2 : 0) + (currentSeen_ ? 2 : 0);
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows_, baseColumns + 1);
  for (size_t t = 0; t < tracks_.size(); ++t) {
    const Track& track = tracks_[t];
    const size_t n = track.rows();
    const DriveReading reading(track, physics_.driveLate_s.value_or(0.0));
    const std::vector<double> means = reading.means(0, n);
    std::vector<double> drive(n), way(n), sine(n), cosine(n), speed(n), lag(n, 0.0);
    for (size_t k = 0; k < n; ++k) {
      const Situation& at = recorded_[t].at(k);
      drive[k] = (track.connected[k] ? gain_ * means[k] : 0.0) - physics_.load;
      if (k + 1 < n) lag[k + 1] = lag[k] + (track.connected[k] ? gain_ * reading.lag(k) : 0.0);
      way[k] = at.direction;
      sine[k] = std::sin(at.position);
      cosine[k] = std::cos(at.position);
      speed[k] = at.velocity;
    }
    addMechanical(lagged(t, drive, true), t, 2, 1.0, all.col(baseColumns));
    addMechanical(lag, t, 0, -1.0, all.col(baseColumns));
    addMechanical(track.position, t, 0, 1.0, all.col(0));
    addMechanical(track.position, t, 1, 1.0, all.col(1));
    addMechanical(way, t, 2, 1.0, all.col(2));
    if (physics_.gravity > 0.0) {
      addMechanical(sine, t, 2, 1.0, all.col(3));
      addMechanical(cosine, t, 2, 1.0, all.col(4));
    }
    std::vector<double> starting, direction, startSine, startCosine;
    for (const Start& one : starts_) {
      if (one.track != t) continue;
      starting.push_back(one.drive - physics_.load);
      direction.push_back(one.direction);
      startSine.push_back(sine[one.row]);
      startCosine.push_back(cosine[one.row]);
    }
    addStarts(starting, t, 1.0, all.col(baseColumns));
    addStarts(direction, t, 1.0, all.col(2));
    if (physics_.gravity > 0.0) {
      addStarts(startSine, t, 1.0, all.col(3));
      addStarts(startCosine, t, 1.0, all.col(4));
    }
    if (!currentSeen_) continue;
    addElectrical(track.current, t, 1.0, all.col(baseColumns));
    addElectrical(lagged(t, track.input, false), t, 1.0, all.col(baseColumns - 2));
    addElectrical(lagged(t, speed, false), t, 1.0, all.col(baseColumns - 1));
  }
  if (torque_ == Torque::wandering) {  // the motion is the response: −J₀ x in the place of ∬drive, and that of J x
    const Eigen::Index rows = mechanicalRows();
    all.col(0).head(rows).swap(all.col(baseColumns).head(rows));
    all.col(0).head(rows) *= -1.0;
    all.col(baseColumns).head(rows) *= -physics_.inertia;
    raw_ = all;
    noise_ = likeliest(raw_.topRows(rows), rows);
  }
  weights_ = Eigen::VectorXd::Ones(rows_);
  weigh(all);
  // Each set of rows in units of its typical residual: the sensor's noise and a part of what the base model leaves.
  const auto scale = [&](const std::vector<Stretch>& set, double factor, auto noiseOf) {
    if (set.empty()) return;
    double reading = 0.0;
    for (const Stretch& one : set) reading = std::max(reading, factor * noiseOf(tracks_[one.track]));
    const Eigen::Index first = set.front().at, rows = set.back().at + set.back().rows - first;
    const Eigen::MatrixXd columns = all.block(first, 0, rows, baseColumns);
    const Eigen::VectorXd response = all.block(first, baseColumns, rows, 1);
    const Eigen::VectorXd size = columns.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
    const Eigen::MatrixXd scaled = columns * size.asDiagonal();
    const double squares = leftByLeastSquares(scaled, response).squaredNorm();
    const double typical = std::sqrt(reading * reading + partOfResidual * squares / static_cast<double>(rows));
    weights_.segment(first, rows) /= std::max(typical, 1e-300);
  };
  scale(stretches_, physics_.inertia, [](const Track& track) { return track.noise; });
  scale(electrical_, 1.0, [](const Track& track) { return track.currentNoise; });
  for (const Start& one : starts_) {
    weights_[one.at] = 1.0 / std::max(startDoubt(one) + 0.03 * physics_.coulomb, 1e-300);
  }
  for (const auto* set : {&stretches_, &electrical_}) {
    for (const Stretch& one : *set) samples_ += static_cast<double>(one.last - one.first + 1);
  }
  samples_ += static_cast<double>(starts_.size());
  for (Eigen::Index c = 0; c < all.cols(); ++c) all.col(c).array() *= weights_.array();
  response_ = all.col(baseColumns);
  base_ = all.leftCols(baseColumns);
  if (physics_.electrical && physics_.inductance > 0.0) freeInductance();
}

/// When in its row a drive acts isn't known: ∫drive, to first order what a shift by a second changes of ∬drive.
Eigen::VectorXd LinearRig::driveShift() const {
  Eigen::VectorXd column = Eigen::VectorXd::Zero(rows_);
  for (size_t t = 0; t < tracks_.size(); ++t) {
    const Track& track = tracks_[t];
    std::vector<double> momentum(track.rows(), 0.0);
    for (size_t k = 0; k + 1 < momentum.size(); ++k) {
      const double drive = track.connected[k] != 0 ? gain_ * track.input[k] : 0.0;
      momentum[k + 1] = momentum[k] + drive * (track.time[k + 1] - track.time[k]);
    }
    addMechanical(momentum, t, 0, 1.0, column);
  }
  return column;
}

/// That such a change is about 0, give or take `doubt`: a row of the least squares beside the stretches', in units of a
/// reading's noise.
double LinearRig::knownTo(double doubt) const {
  double noise = 0.0;
  for (const Stretch& one : stretches_) noise = std::max(noise, physics_.inertia * tracks_[one.track].noise);
  return noise / std::max(doubt, 1e-300);
}

double LinearRig::longestRow_s() const {
  double step_s = 0.0;
  for (const Stretch& one : stretches_) step_s = std::max(step_s, tracks_[one.track].usualStep_s);
  return step_s;
}

Eigen::Index LinearRig::mechanicalRows() const {
  return stretches_.empty() ? 0 : stretches_.back().at + stretches_.back().rows;
}

Eigen::VectorXd LinearRig::physical(Eigen::VectorXd coefficients) const {
  if (torque_ == Torque::steady) return coefficients;
  const double gain = coefficients[0];
  coefficients[0] = physics_.inertia;
  coefficients.head(physics_.gravity > 0.0 ? 5 : 3) /= gain;
  return coefficients;
}

Eigen::VectorXd LinearRig::byInductance() const {
  constexpr double step = 0.02;
  Eigen::VectorXd change = Eigen::VectorXd::Zero(rows_);
  for (size_t t = 0; t < tracks_.size(); ++t) {
    const Track& track = tracks_[t];
    std::vector<double> drive(track.rows());
    for (size_t k = 0; k < drive.size(); ++k)
      drive[k] = track.connected[k] ? track.input[k] - physics_.backEmf * recorded_[t].at(k).velocity : 0.0;
    for (const double sign : {1.0, -1.0}) {
      const double inductance = physics_.inductance * (1.0 + sign * step);
      addMechanical(lagged(t, drive, true, inductance), t, 2, sign * gain_ / (2.0 * step), change);
      if (currentSeen_)
        addElectrical(lagged(t, drive, false, inductance), t, -sign / (physics_.resistance * 2.0 * step), change);
    }
  }
  return change;
}

void LinearRig::freeInductance() {
  Eigen::VectorXd change = byInductance();
  weigh(change);
  Eigen::MatrixXd more(rows_, base_.cols() + 1);
  more << base_, change;
  const Eigen::VectorXd scale = more.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  const Eigen::VectorXd solution = scale.cwiseProduct(leastSquares(more * scale.asDiagonal(), response_));
  // Beyond the doubt about an inductance something else is late.
  if (std::abs(solution[base_.cols()]) < inductanceDoubt) base_ = more;
}

void LinearRig::cut(const std::vector<Window>& windows) {
  size_t samples = 0;
  for (size_t w = 0; w < windows.size(); ++w) {
    const Window& window = windows[w];
    const RecordedMotion& recorded = recorded_[window.track];
    size_t first = window.first;
    for (size_t k = window.first; k <= window.last + 1; ++k) {
      const bool goesOn = k <= window.last && recorded.usable(k) &&
                          recorded.at(k).direction == recorded.at(std::max(first, k - (k > first ? 1 : 0))).direction;
      if (goesOn) continue;
      size_t from = first, to = k;  // [from, to)
      if (from > window.first) from += turnMargin;
      if (to <= window.last) to -= std::min(to, turnMargin);
      if (to > from && to - from >= fewestSamples) {
        stretches_.push_back({window.track, from, to - 1, w, 1, 1, 0, 0});
        samples += to - from;
      }
      first = k <= window.last && recorded.usable(k) && k > first ? k : k + 1;
    }
    if (currentSeen_) {
      electrical_.push_back({window.track, window.first, window.last, w, 1, 1, 0, 0});
      samples += window.last - window.first + 1;
    }
  }
  findStarts(windows);
  const size_t together = std::max<size_t>(1, (samples + mostRows - 1) / mostRows);
  for (auto* set : {&stretches_, &electrical_}) {
    for (Stretch& one : *set) {
      const size_t length = one.last - one.first + 1;
      one.samplesPerRow = std::clamp<size_t>(length / 12, 1, together);
      one.samplesTaken = torque_ == Torque::steady ? one.samplesPerRow : 1;
      one.at = rows_;
      one.rows = static_cast<Eigen::Index>(length / one.samplesPerRow);
      rows_ += one.rows;
      window_.insert(window_.end(), static_cast<size_t>(one.rows), one.window);
    }
  }
  for (Stretch& one : stretches_) {
    one.times = timesOf(one);
    one.impulses = impulsesOf(one);
  }
  for (Start& one : starts_) {
    one.at = rows_++;
    window_.push_back(one.window);
  }
}

void LinearRig::findStarts(const std::vector<Window>& windows) {
  for (size_t w = 0; w < windows.size(); ++w) {
    const Window& window = windows[w];
    const Track& track = tracks_[window.track];
    for (size_t k = window.first + 1; k < window.last; ++k) {
      if (!track.motion.resting[k] || track.motion.resting[k + 1] || !track.connected[k]) continue;
      // Which way it goes: the first motion that is clearly more than the rest's.
      size_t later = k + 1;
      while (later < window.last && std::abs(track.position[later] - track.position[k]) < 6.0 * track.noise) ++later;
      const double way = track.position[later] > track.position[k] ? 1.0 : -1.0;
      starts_.push_back({window.track, k, w, way, recorded_[window.track].at(k).driveTorque, 0});
    }
  }
}

/// How far the drive may be from what it was when motion began: what it changes within the time that motion takes to
/// show, if it began when the drive was smaller.
double LinearRig::startDoubt(const Start& one) const {
  const Track& track = tracks_[one.track];
  const std::vector<double>& time = track.time;
  const RecordedMotion& motion = recorded_[one.track];
  const auto before = [&](double back_s) {
    size_t row = one.row;
    while (row > 0 && time[one.row] - time[row] < back_s) --row;
    return row;
  };
  // Twice integrated, what the drive gains since then moves the axis.
  const auto movedSince = [&](size_t from) {
    double speed = 0.0, way = 0.0;
    for (size_t k = from; k < one.row; ++k) {
      const double dt = time[k + 1] - time[k];
      const double net = one.direction * (motion.at(k).driveTorque - motion.at(from).driveTorque);
      speed = std::max(0.0, speed + dt * net / physics_.inertia);
      way += dt * speed;
    }
    return way;
  };
  size_t early = before(startDoubt_s), late = one.row;
  for (double back_s = startDoubt_s; back_s < longestStart_s; back_s *= 1.25) {
    const size_t from = before(back_s);
    if (!track.motion.resting[from] || movedSince(from) > shownReadings * track.noise) break;
    early = from;
  }
  while (late + 1 < time.size() && time[late] - time[one.row] < startDoubt_s) ++late;
  const double change = std::abs(motion.at(late).driveTorque - motion.at(early).driveTorque);
  return 0.5 * change;
}

std::vector<RecordedStart> LinearRig::startsOf(size_t track) const {
  std::vector<RecordedStart> starts;
  for (const Start& one : starts_) {
    if (one.track == track) starts.push_back({one.row, one.direction});
  }
  return starts;
}

Eigen::VectorXd LinearRig::timesOf(const Stretch& one) const {
  const std::vector<double>& time = tracks_[one.track].time;
  Eigen::VectorXd times(one.rows);
  for (Eigen::Index r = 0; r < one.rows; ++r) {
    const size_t from = one.first + static_cast<size_t>(r) * one.samplesPerRow;
    double sum = 0.0;
    for (size_t k = from; k < from + one.samplesTaken; ++k) sum += time[k] - time[one.first];
    times[r] = sum / static_cast<double>(one.samplesTaken);
  }
  return times;
}

Eigen::VectorXd LinearRig::impulsesOf(const Stretch& one) const {
  const Track& track = tracks_[one.track];
  const double reading = physics_.inertia * track.noise;
  if (!(reading > 0.0)) return {};
  Eigen::VectorXd out = Eigen::VectorXd::Zero(one.rows);
  const double part = gain_ * gain_ * static_cast<double>(one.samplesTaken) / (reading * reading);
  for (size_t k = one.first; k < one.last; ++k) {
    const auto row = static_cast<Eigen::Index>((k + 1 - one.first) / one.samplesPerRow);
    if (row >= one.rows) break;
    double variance = track.missingInput(k);
    if (torque_ == Torque::wandering) variance += std::pow(track.inputNoise * (track.time[k + 1] - track.time[k]), 2);
    out[row] += part * variance;
  }
  return out;
}

TorqueNoise LinearRig::wander(const Eigen::MatrixXd& more) const {
  const Eigen::Index rows = mechanicalRows(), at = more.cols();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows + 1, at + 1 + raw_.cols());
  // How late the drive acts isn't known: by the winding's lag, which changes more after a step than a shift does, or
  // within its row. Both at once would take what wanders for themselves.
  const bool winds = physics_.electrical && physics_.inductance > 0.0;
  const Eigen::VectorXd late = winds ? byInductance() : driveShift();
  all.topRows(rows) << more.topRows(rows), late.head(rows), raw_.topRows(rows);
  all(rows, at) = knownTo(winds ? inductanceDoubt : 0.5 * longestRow_s());
  return likeliest(all, rows);
}

TorqueNoise LinearRig::likeliest(const Eigen::MatrixXd& all, Eigen::Index rows) const {
  if (rows < 2 * all.cols()) return {};                     // hardly ever moves
  const auto consider = [&](double ratio, double time_s) {  // its improbability
    Eigen::MatrixXd white = all;
    double logarithms = 0.0;
    for (const Stretch& one : stretches_)
      logarithms += whitenStretch({ratio, time_s, 0.0}, one, white.middleRows(one.at, one.rows));
    const Eigen::Index width = white.cols() - 1;
    const Eigen::VectorXd scale = white.leftCols(width).colwise().norm().cwiseMax(1e-300).cwiseInverse();
    white.leftCols(width) *= scale.asDiagonal();
    const double left = leftOfLastColumn(white);  // what the columns leave of the response
    const double free = static_cast<double>(white.rows() - width) - 2.0 * static_cast<double>(stretches_.size());
    const double unlikely = logarithms + 0.5 * free * std::log(left * left / free);
    return std::pair{unlikely, TorqueNoise{ratio, time_s, ratio * std::abs(left) / std::sqrt(free)}};
  };
  auto best = consider(0.0, 1.0);
  const auto tryTime = [&](double time_s) {
    auto own = consider(1.0, time_s);
    const auto tryRatio = [&](double ratio) {
      if (const auto other = consider(ratio, time_s); other.first < own.first) own = other;
    };
    for (double ratio = coarseFactor; ratio < mostRatio; ratio *= coarseFactor) tryRatio(ratio);
    for (double factor = std::sqrt(coarseFactor); factor > 1.2; factor = std::sqrt(factor)) {
      const double about = own.second.ratio;
      tryRatio(about * factor);
      tryRatio(about / factor);
    }
    if (own.first < best.first) best = own;
  };
  for (const double time_s : {0.003, 0.03, 0.3, 3.0}) tryTime(time_s);
  const double about_s = best.second.time_s;
  if (best.second.ratio > 0.0) {
    for (const double factor : {1.0 / 3.0, 3.0}) tryTime(factor * about_s);
  }
  return best.second;
}

double LinearRig::whitenStretch(const TorqueNoise& noise, const Stretch& one, Eigen::Ref<Eigen::MatrixXd> rows) const {
  Eigen::MatrixXd line(one.rows, 2);
  line.col(0).setOnes();
  line.col(1) = one.times.array() - one.times.mean();
  line.col(1) /= std::max(line.col(1).cwiseAbs().maxCoeff(), 1e-300);
  whiten(noise, one.times, line, one.impulses);
  const double logarithms = whiten(noise, one.times, rows, one.impulses);
  const Eigen::MatrixXd basis = basisOf(line);
  rows -= (basis * (basis.transpose() * rows)).eval();
  return logarithms;
}

void LinearRig::weigh(Eigen::Ref<Eigen::MatrixXd> columns) const {
  for (const Stretch& one : stretches_) whitenStretch(noise_, one, columns.middleRows(one.at, one.rows));
  for (Eigen::Index c = 0; c < columns.cols(); ++c) columns.col(c).array() *= weights_.array();
}

std::vector<size_t> LinearRig::tracksSeen() const {
  std::vector<size_t> tracks;
  for (const auto* set : {&stretches_, &electrical_}) {
    for (const Stretch& one : *set) tracks.push_back(one.track);
  }
  std::sort(tracks.begin(), tracks.end());
  tracks.erase(std::unique(tracks.begin(), tracks.end()), tracks.end());
  return tracks;
}

}  // namespace breakaway
