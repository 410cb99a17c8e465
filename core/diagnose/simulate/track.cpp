#include "diagnose/simulate/track.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/statistics.h"
#include "diagnose/simulate/recorded_input.h"
#include "recording/columns.h"

namespace breakaway {

namespace {

/// Squared differences of each value from the cubic through its four neighbours in time, in units of a reading's own
/// variance: what the motion hardly reaches.
std::vector<double> roughness(const std::vector<double>& time, const std::vector<double>& values,
                              const std::vector<char>& known) {
  std::vector<double> squares;
  for (size_t k = 2; k + 2 < values.size(); ++k) {
    if (!(known[k - 2] && known[k - 1] && known[k] && known[k + 1] && known[k + 2])) continue;
    double difference = values[k], variance = 1.0;
    for (const size_t j : {k - 2, k - 1, k + 1, k + 2}) {
      double weight = 1.0;  // Lagrange's
      for (const size_t i : {k - 2, k - 1, k + 1, k + 2})
        weight *= i == j ? 1.0 : (time[k] - time[i]) / (time[j] - time[i]);
      difference -= weight * values[j];
      variance += weight * weight;
    }
    squares.push_back(difference * difference / variance);
  }
  return squares;
}

/// Noise of one reading.
double readingNoise(const std::vector<double>& time, const std::vector<double>& values,
                    const std::vector<char>& known) {
  const std::vector<double> squares = roughness(time, values, known);
  if (squares.empty()) return 0.0;
  return std::sqrt(quantile(squares, 0.5) / 0.4549);  // the median of a χ² with one degree of freedom is 0.4549
}

/// The nearest times of a regular grid, gaps kept; empty where two rows share one.
std::vector<double> regular(const std::vector<double>& time) {
  std::vector<double> steps;
  steps.reserve(time.size());
  for (size_t k = 0; k + 1 < time.size(); ++k) steps.push_back(time[k + 1] - time[k]);
  const double usual = quantile(steps, 0.5);
  std::erase_if(steps, [usual](double one) { return one > 1.75 * usual; });
  double step = mean(steps);  // without missing rows the jitter is no part of it
  std::vector<double> out(time.size());
  for (int round = 0; round < 2; ++round) {
    double at = 0.0, along = 0.0, squares = 0.0;
    for (size_t k = 1; k < time.size(); ++k) {
      // Late by up to three quarters of a step is still the same row.
      at += std::max(1.0, std::floor((time[k] - time[0] - at * step) / step + 0.25));
      along += at * (time[k] - time[0]);
      squares += at * at;
      out[k] = at;
    }
    step = along / squares;
  }
  double most = 0.0;
  for (size_t k = 1; k < time.size(); ++k) {
    out[k] *= step;
    most = std::max(most, std::abs(out[k] - (time[k] - time[0])));
  }
  return most < step ? out : std::vector<double>{};
}

/// Times that jitter although the motion doesn't: rows were taken at regular times and dated badly.
void straighten(Track& track) {
  const std::vector<double> grid = regular(track.time);
  if (grid.empty()) return;
  double jitter = 0.0;
  for (size_t k = 0; k < grid.size(); ++k) jitter = std::max(jitter, std::abs(grid[k] - track.time[k]));
  if (jitter < 0.02 * (grid.back() / static_cast<double>(grid.size() - 1))) return;
  const auto typical = [&](const std::vector<double>& time) {
    const auto squares = roughness(time, track.speedAlone() ? track.speed : track.position, track.seen);
    return squares.empty() ? 0.0 : mean(squares);
  };
  if (typical(grid) > 0.5 * typical(track.time)) return;
  track.remarks.push_back(message(
      "{}: its times jitter by up to {} ms against regular ones, at which the motion is smoother: taken as regular",
      track.name, fmt::format("{:.3g}", 1e3 * jitter)));
  track.time = grid;
}

constexpr double mostBridged = 3.0;       ///< missing rows
constexpr double speedsTogether_s = 0.1;  ///< over which readings of speed add up to a position

/// The step in which readings are counted, the least one between neighbours of which all others are multiples; 0 where
/// there is none.
double countOf(const std::vector<double>& readings) {
  std::vector<double> steps;
  for (size_t k = 1; k < readings.size(); ++k) {
    const double step = std::abs(readings[k] - readings[k - 1]);
    if (step > 0.0) steps.push_back(step);
  }
  if (steps.size() < 20) return 0.0;
  const double least = *std::min_element(steps.begin(), steps.end());
  const auto whole = std::count_if(steps.begin(), steps.end(), [least](double step) {
    return std::abs(step / least - std::round(step / least)) < 0.02;
  });
  const double reach = *std::max_element(steps.begin(), steps.end()) / least;
  return reach < 1e4 && whole == std::ssize(steps) ? least : 0.0;
}

/// What was measured, with missing rows held; `track.time` is there. Errors: no value at all.
Result<void> takeReadings(Track& track, const Recording& recording, const std::string& channel, double count) {
  const auto readings = recording.channel(channel);
  const size_t rows = readings.size();
  std::vector<double> held(rows);
  track.seen.resize(rows);
  double last = std::nan("");
  size_t missing = 0;
  for (size_t k = 0; k < rows; ++k) {
    track.seen[k] = std::isfinite(readings[k]) ? 1 : 0;
    if (track.seen[k])
      last = readings[k] + 0.5 * count;
    else
      ++missing;
    held[k] = last;
  }
  if (missing == rows) return Error{recording.name() + ", column " + channel, "has no value at all"};
  for (size_t k = rows; k-- > 1;) {
    if (!std::isfinite(held[k - 1])) held[k - 1] = held[k];
  }
  if (missing > 0)
    track.remarks.push_back(message("{}: {} rows have no {} and are left out", recording.name(),
                                    std::to_string(missing),
                                    track.speedAlone() ? message("speed") : message("position")));
  (track.speedAlone() ? track.speed : track.position) = std::move(held);
  return {};
}

/// Robust standard deviation: single steps of a drive don't count.
double usualSize(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return quantile(std::move(values), 0.5) / 0.6745;
}

/// Where rows are missing, a drive that runs smoothly is put to its mean between the rows around; another holds, or has
/// leapt already. Says how far either may have been from what it was: usually, and by how the rows around differ.
void bridgeMissing(Track& track) {
  std::vector<double>& input = track.input;
  const std::vector<double> recorded = input;
  std::vector<double> changes, bends;
  bool complete = true;
  for (size_t k = 1; k < recorded.size(); ++k) {
    complete = complete && track.missingAfter(k - 1) == 0;
    changes.push_back(recorded[k] - recorded[k - 1]);
    if (k + 1 < recorded.size()) bends.push_back(recorded[k] - 0.5 * (recorded[k - 1] + recorded[k + 1]));
  }
  if (complete) return;
  const double change = usualSize(std::move(changes));
  const double bend = bends.empty() ? change : usualSize(std::move(bends));
  const bool smooth = bend < change;
  track.missingDoubt.assign(recorded.size(), 0.0);
  for (size_t k = 0; k + 1 < recorded.size(); ++k) {
    if (track.missingAfter(k) == 0) continue;
    const auto missing = static_cast<double>(track.missingAfter(k));
    const double leap = recorded[k + 1] - recorded[k];
    if (!smooth || missing > mostBridged) {
      track.missingDoubt[k] = std::hypot(change, leap * std::numbers::sqrt2 / 2.0);
      continue;
    }
    input[k] += 0.5 * missing / (missing + 1.0) * leap;
    // A cubic through the two rows before and after is off a line by this, amidst a single row that is missing.
    const double before = recorded[k > 0 ? k - 1 : k], after = recorded[std::min(k + 2, recorded.size() - 1)];
    track.missingDoubt[k] = std::hypot(bend, (recorded[k] + recorded[k + 1] - before - after) / 6.0);
  }
}

Result<std::vector<double>> inputOf(const Recording& recording, const Bench& names) {
  const std::string channel = recordedInput(recording, names);
  const auto values = recording.channel(channel);
  if (values.empty()) return Error{recording.name(), "has no column " + channel + ", which drives this bench"};
  std::vector<double> input(values.begin(), values.end());
  double last = std::nan("");
  for (double& value : input) {
    if (std::isfinite(value))
      last = value;
    else
      value = last;
  }
  if (!std::isfinite(last)) return Error{recording.name() + ", column " + channel, "has no value at all"};
  const auto first = std::find_if(input.begin(), input.end(), [](double value) { return std::isfinite(value); });
  std::fill(input.begin(), first, *first);
  if (channel != "duty") return input;
  const auto supply = recording.channel("supply_V");
  double volts = names.supply_V.value_or(std::nan(""));
  for (size_t k = 0; k < input.size(); ++k) {
    if (!supply.empty() && std::isfinite(supply[k])) volts = supply[k];
    input[k] *= volts;
  }
  if (!std::isfinite(volts)) {
    return Error{recording.name(), "is driven by duty but has no column supply_V, and the bench has no drive.supply_V"};
  }
  for (size_t k = input.size(); k-- > 1;) {
    if (!std::isfinite(input[k - 1])) input[k - 1] = input[k];
  }
  return input;
}

}  // namespace

Track Track::rowsFrom(size_t first, size_t last) const {
  Track out;
  const auto part = [=](const auto& from) {
    if (from.empty()) return from;
    return std::remove_cvref_t<decltype(from)>(from.begin() + static_cast<std::ptrdiff_t>(first),
                                               from.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  };
  out.name = name;
  out.time = part(time);
  out.position = part(position);
  out.speed = part(speed);
  out.input = part(input);
  out.reference = part(reference);
  out.referenceSpeed = part(referenceSpeed);
  out.push = part(push);
  out.seen = part(seen);
  out.bridged = part(bridged);
  out.connected = part(connected);
  out.current = part(current);
  out.voltage = part(voltage);
  out.supply = part(supply);
  out.missingDoubt = part(missingDoubt);
  out.temperature = part(temperature);
  out.supply_V = supply_V;
  out.drive = drive;
  out.origin_s = origin_s;
  out.usualStep_s = usualStep_s;
  out.noise = noise;
  out.quantisation = quantisation;
  out.speedNoise = speedNoise;
  out.speedCount = speedCount;
  out.inputNoise = inputNoise;
  out.currentNoise = currentNoise;
  return out;
}

Result<Track> makeTrack(const Recording& recording, Axis axis, DriveInput driveInput, std::optional<double> supply_V,
                        double count, bool byReference) {
  Bench names;
  names.axis = axis;
  names.input = driveInput;
  if (byReference) names.servo = ServoLaw{};
  names.supply_V = supply_V;
  Track track;
  track.name = recording.name();
  if (recording.rows() < 2) return Error{recording.name(), "has fewer than two rows"};
  const bool speedAlone = !recording.has(names.positionChannel());
  if (speedAlone && !recording.has(names.velocityChannel()))
    return Error{recording.name(), "has no column " + names.positionChannel() + " and no " + names.velocityChannel()};
  if (speedAlone) count = 0.0;
  auto input = inputOf(recording, names);
  if (!input) return input.error();
  if (byReference) {
    track.reference = std::move(*input);
    track.input.assign(recording.rows(), 0.0);
    if (const char* speeds = columnName(Quantity::velocityReference, axis); speeds != nullptr) {
      const auto speed = recording.channel(speeds);
      if (std::all_of(speed.begin(), speed.end(), [](double one) { return std::isfinite(one); }))
        track.referenceSpeed.assign(speed.begin(), speed.end());
    }
  } else {
    track.input = std::move(*input);
  }

  const size_t rows = recording.rows();
  const auto time = recording.time();
  track.origin_s = time[0];
  track.usualStep_s = recording.medianStep_s();
  track.time.resize(rows);
  track.connected.assign(rows, 1);
  for (size_t k = 0; k < rows; ++k) track.time[k] = time[k] - time[0];
  if (rows > 1) bridgeMissing(track);
  if (speedAlone) track.speed.resize(rows);
  if (auto taken =
          takeReadings(track, recording, speedAlone ? names.velocityChannel() : names.positionChannel(), count);
      !taken)
    return taken.error();
  straighten(track);
  if (speedAlone) integrateSpeed(track);
  const auto enabled = recording.channel("enabled");
  for (size_t k = 0; k < enabled.size(); ++k) track.connected[k] = enabled[k] == 0.0 ? 0 : 1;
  track.drive = driveInput;
  track.supply_V = supply_V.value_or(0.0);
  const auto supply = recording.channel("supply_V");
  if (std::all_of(supply.begin(), supply.end(), [](double one) { return std::isfinite(one); }))
    track.supply.assign(supply.begin(), supply.end());
  const auto temperature = recording.channel("temperature_degC");
  track.temperature.assign(temperature.begin(), temperature.end());
  const auto current = recording.channel("current_A");
  if (names.electrical() && !current.empty()) track.current.assign(current.begin(), current.end());
  const auto voltage = recording.channel("voltage_V");
  if (driveInput == DriveInput::current) track.voltage.assign(voltage.begin(), voltage.end());
  if (!track.current.empty()) {
    std::vector<char> known(rows);
    for (size_t k = 0; k < rows; ++k) known[k] = std::isfinite(track.current[k]) ? 1 : 0;
    track.currentNoise = readingNoise(track.time, track.current, known);
  }
  if (driveInput == DriveInput::current && !byReference)
    track.inputNoise = readingNoise(track.time, track.input, std::vector<char>(rows, 1));
  if (speedAlone) {
    track.speedCount = countOf(track.speed);
    track.speedNoise = std::max(readingNoise(track.time, track.speed, track.seen), track.speedCount / std::sqrt(12.0));
    track.noise = track.speedNoise * std::sqrt(track.usualStep_s * speedsTogether_s);
    track.remarks.push_back(
        message("{}: only the speed was measured; angles are its integral, and what goes with the angle is known from "
                "there on",
                recording.name()));
    return track;
  }
  track.quantisation = count / std::sqrt(12.0);
  track.noise = std::max(readingNoise(track.time, track.position, track.seen), track.quantisation);
  return track;
}

double heldMean(const std::vector<double>& time, const std::vector<double>& values, double from_s, double to_s,
                size_t near) {
  size_t row = near;
  while (row > 0 && time[row] > from_s) --row;
  while (row + 1 < time.size() && time[row + 1] <= from_s) ++row;
  double sum = 0.0, at = from_s;
  while (row + 1 < time.size() && time[row + 1] < to_s) {
    sum += values[row] * (time[row + 1] - at);
    at = time[++row];
  }
  return to_s > from_s ? (sum + values[row] * (to_s - at)) / (to_s - from_s) : values[row];
}

void integrateSpeed(Track& track) {
  track.position.assign(track.rows(), 0.0);
  for (size_t k = 1; k < track.rows(); ++k)
    track.position[k] =
        track.position[k - 1] + 0.5 * (track.speed[k] + track.speed[k - 1]) * (track.time[k] - track.time[k - 1]);
}

void bridgePositions(Track& track, double near_s) {
  const size_t n = track.rows();
  track.bridged.assign(n, 0);
  for (size_t k = 0; k < n;) {
    if (track.seen[k]) {
      ++k;
      continue;
    }
    const size_t first = k;
    while (k < n && !track.seen[k]) ++k;
    if (first == 0 || k == n) continue;
    const double from_s = track.time[first - 1], span_s = track.time[k] - from_s;
    const double from = track.position[first - 1], way = track.position[k] - from;
    for (size_t row = first; row < k; ++row) {
      track.position[row] = from + way * (track.time[row] - from_s) / span_s;
      track.bridged[row] = span_s <= near_s ? 1 : 0;
    }
  }
}

double longestRow_s(const std::vector<Track>& tracks) {
  double longest_s = 0.0;
  for (const Track& track : tracks) longest_s = std::max(longest_s, track.usualStep_s);
  return longest_s;
}

}  // namespace breakaway
