#include "diagnose/fit/channel_checks.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/statistics.h"
#include "diagnose/simulate/recorded_input.h"

namespace breakaway {

namespace {

constexpr double gapSteps = 5.0;  ///< usual steps
constexpr double shortestGap_s = 0.01;
constexpr double usualWays = 0.95;  ///< quantile of the ways from row to row
constexpr double leapWays = 20.0;   ///< times that, which no axis moves in a row
constexpr size_t fewestWays = 100;
constexpr size_t fewestWraps = 2;

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (size_t k = 0; k < a.size(); ++k) {
    ab += a[k] * b[k];
    aa += a[k] * a[k];
    bb += b[k] * b[k];
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

double wayAfter(const Track& track, size_t row) {
  return std::abs(track.position[row + 1] - track.position[row]);
}

void sayGaps(std::vector<std::string>& out, const Track& track) {
  const double usual = track.usualStep_s;
  size_t gaps = 0;
  double longest = 0.0;
  for (size_t k = 0; k + 1 < track.rows(); ++k) {
    const double step = track.time[k + 1] - track.time[k];
    if (!isGap(step, usual)) continue;
    ++gaps;
    longest = std::max(longest, step);
  }
  if (gaps > 0) {
    out.push_back(
        track.name +
        fmt::format(": rows are missing in {} place{}, for up to {:.3g} s; windows that hold such a place are left out",
                    gaps, gaps == 1 ? "" : "s", longest));
  }
}

void sayLeaps(std::vector<std::string>& out, const Bench& bench, const Track& track) {
  if (track.leaps.empty()) return;
  double largest = 0.0;
  for (const size_t row : track.leaps) largest = std::max(largest, wayAfter(track, row));
  out.push_back(
      track.name + ", column " + bench.positionChannel() +
      fmt::format(": leaps by up to {:.4g} {} within a row in {} place{}: bad readings or lost counts; windows that "
                  "hold such a place are left out",
                  largest, bench.axis == Axis::rotary ? "rad" : "m", track.leaps.size(),
                  track.leaps.size() == 1 ? "" : "s"));
}

void sayDrive(std::vector<std::string>& out, const Bench& bench, const Recording& recording, const Track& track,
              const Criteria& criteria) {
  const std::string input = recordedInput(recording, bench);
  std::vector<double> values;
  for (const double value : recording.channel(input)) {
    if (std::isfinite(value)) values.push_back(value);
  }
  if (values.empty()) return;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const std::string column = ", column " + input;
  if (*low == *high) {
    out.push_back(track.name + column +
                  fmt::format(": never changes ({:.4g} throughout): what it does to the axis can't be told", *low));
    return;
  }
  const auto partAt = [&values](double value) {
    return static_cast<double>(std::count(values.begin(), values.end(), value)) / static_cast<double>(values.size());
  };
  const double atHigh = *high != 0.0 ? partAt(*high) : 0.0, atLow = *low != 0.0 ? partAt(*low) : 0.0;
  // A command that goes between two levels, or in steps, stands at its levels by intention.
  size_t between = 0, changing = 0;
  for (size_t k = 1; k < values.size(); ++k) {
    if (values[k] == *high || values[k] == *low || values[k] == 0.0) continue;
    ++between;
    changing += values[k] != values[k - 1] ? 1 : 0;
  }
  const bool moves = 5 * between > values.size() && 10 * changing > between;
  if (std::max(atHigh, atLow) > criteria.soundPart && moves) {
    out.push_back(
        track.name + column +
        fmt::format(
            ": {:.0f} % of the rows stand at exactly {:.4g} or {:.4g}: if the recording clips what really acted, "
            "the model errs there",
            100.0 * (atHigh + atLow), *low, *high));
  }
}

void sayVelocity(std::vector<std::string>& out, const Bench& bench, const Recording& recording, const Track& track,
                 const Criteria& criteria) {
  const std::string column = bench.velocityChannel();
  const auto values = recording.channel(column);
  if (values.empty()) return;
  std::vector<double> recorded, slope;
  for (size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) continue;
    recorded.push_back(values[k]);
    slope.push_back(track.motion.velocity[k]);
  }
  const double same = correlation(recorded, slope);
  if (same < -criteria.half) {
    out.push_back(track.name + ", column " + column +
                  ": has the opposite sign of the angle's slope; the angle is believed, the column is not used");
  } else if (same < criteria.half && rms(slope) > criteria.farApart * track.motion.velocityNoise) {
    out.push_back(track.name + ", column " + column +
                  ": does not follow the angle's slope; the angle is believed, the column is not used");
  }
}

void sayDirection(std::vector<std::string>& out, const Bench& bench, const Track& track, const Criteria& criteria) {
  if (bench.pendulum) return;  // gravity may well drive the motor
  std::vector<double> drive, velocity;
  for (size_t k = 0; k < track.rows(); ++k) {
    if (track.connected[k] == 0 || track.motion.resting[k]) continue;
    drive.push_back(track.input[k]);
    velocity.push_back(track.motion.velocity[k]);
  }
  if (correlation(drive, velocity) < -criteria.energyBack) {
    out.push_back(track.name + ": the axis moves against " + bench.inputChannel() +
                  " most of the time: one of the two has the wrong sign, or something else drives");
  }
}

}  // namespace

bool isGap(double step_s, double usual_s) {
  return step_s > std::max(gapSteps * usual_s, shortestGap_s);
}

std::vector<size_t> leapsOf(const Track& track) {
  std::vector<double> ways;  // while it moves
  const auto near = [&track](size_t row) {
    return track.seen[row] && track.seen[row + 1] && !isGap(track.time[row + 1] - track.time[row], track.usualStep_s);
  };
  for (size_t row = 0; row + 1 < track.rows(); ++row) {
    if (near(row) && wayAfter(track, row) > track.noise) ways.push_back(wayAfter(track, row));
  }
  if (ways.size() < fewestWays) return {};
  const double limit = leapWays * std::max(quantile(ways, usualWays), track.noise);
  std::vector<size_t> leaps;
  for (size_t row = 0; row + 1 < track.rows(); ++row) {
    if (near(row) && wayAfter(track, row) > limit) leaps.push_back(row);
  }
  return leaps;
}

Result<void> checkUnwrapped(const Bench& bench, const Track& track) {
  const bool turns = bench.axis == Axis::rotary && track.leaps.size() >= fewestWraps &&
                     std::all_of(track.leaps.begin(), track.leaps.end(),
                                 [&track](size_t row) { return std::abs(wayAfter(track, row) - turn_rad) < 0.5; });
  if (!turns) return {};
  return Error{
      track.name + ", column " + bench.positionChannel(),
      fmt::format("wraps: it leaps by about a whole turn within a row in {} places, expected an angle that goes on "
                  "counting",
                  track.leaps.size())};
}

std::vector<std::string> channelRemarks(const Bench& bench, const Recording& recording, const Track& track,
                                        const Criteria& criteria) {
  std::vector<std::string> out;
  sayGaps(out, track);
  sayLeaps(out, bench, track);
  sayDrive(out, bench, recording, track, criteria);
  sayVelocity(out, bench, recording, track, criteria);
  sayDirection(out, bench, track, criteria);
  return out;
}

}  // namespace breakaway
