#include "diagnose/check/channel_quality.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "diagnose/effects/wording.h"
#include "diagnose/simulate/recorded_input.h"

namespace breakaway {

namespace {

constexpr double hardlyEver = 0.05;    ///< of the rows
constexpr double oftenRepeated = 0.2;  ///< of the rows while it moves
constexpr double oftenAtLimit = 0.05;
constexpr double muchJitter = 0.05;    ///< of the usual step
constexpr double mostlyRests = 0.7;    ///< of the time
constexpr double oneWay = 0.9;         ///< of the motion
constexpr double slowRate_Hz = 200.0;  ///< below it a winding and a breakaway hide within a row
constexpr double sameStep = 0.02;      ///< relative

/// The smallest difference of two neighbouring readings that comes often; 0 where readings hardly repeat one.
double stepOf(const std::vector<double>& values, const std::vector<char>& seen) {
  std::vector<double> steps;
  for (size_t k = 0; k + 1 < values.size(); ++k) {
    const double step = std::abs(values[k + 1] - values[k]);
    if (seen[k] && seen[k + 1] && step > 1e-12 * (1.0 + std::abs(values[k]))) steps.push_back(step);
  }
  if (steps.size() < 20) return 0.0;
  const double least = quantile(steps, 0.0);
  const auto whole = std::count_if(steps.begin(), steps.end(), [least](double one) {
    return std::abs(one / least - std::round(one / least)) < sameStep * std::max(1.0, one / least);
  });
  return static_cast<double>(whole) > 0.9 * static_cast<double>(steps.size()) && least > 0.0 ? least : 0.0;
}

double partOf(size_t some, size_t all) {
  return all > 0 ? static_cast<double>(some) / static_cast<double>(all) : 0.0;
}

/// Whether no measured channel of a row differs from the row before.
bool repeats(const Recording& recording, const Bench& bench, size_t row) {
  for (const std::string& name : {bench.positionChannel(), bench.velocityChannel(), std::string("current_A")}) {
    const auto values = recording.channel(name);
    if (!values.empty() && values[row] != values[row - 1]) return false;
  }
  return true;
}

void measureTimes(ChannelQuality& out, const Track& track) {
  std::vector<double> off;
  for (size_t k = 0; k + 1 < track.rows(); ++k) {
    const double step = track.time[k + 1] - track.time[k];
    out.longestGap_s = std::max(out.longestGap_s, step);
    out.missingRows += track.missingAfter(k);
    if (track.missingAfter(k) == 0) off.push_back(std::abs(step - track.usualStep_s));
  }
  out.jitter_s = off.empty() ? 0.0 : quantile(std::move(off), 0.5);
}

void measureMotion(ChannelQuality& out, const Bench& bench, const Recording& recording, const Track& track) {
  size_t moving = 0, forwards = 0, repeated = 0, unread = 0;
  double rest_s = 0.0, way = 0.0;
  std::vector<double> speeds;
  for (size_t k = 0; k < track.rows(); ++k) {
    const double v = track.motion.velocity[k];
    unread += track.seen[k] ? 0 : 1;
    speeds.push_back(std::abs(v));
    if (track.motion.resting[k]) {
      if (k > 0) rest_s += track.time[k] - track.time[k - 1];
      continue;
    }
    if (track.motion.way[k] * way < 0.0) ++out.reversals;
    way = track.motion.way[k];
    if (std::abs(v) < 4.0 * track.motion.velocityNoise) continue;
    ++moving;
    forwards += v > 0.0 ? 1 : 0;
    repeated += k > 0 && repeats(recording, bench, k) ? 1 : 0;
  }
  out.unreadPart = partOf(unread, track.rows());
  out.repeatedPart = partOf(repeated, moving);
  out.forwardsPart = partOf(forwards, moving);
  out.restPart = rest_s / std::max(out.duration_s, 1e-300);
  out.fastest = quantile(std::move(speeds), 0.99);
  const auto [low, high] = std::minmax_element(track.position.begin(), track.position.end());
  out.travel = *high - *low;
}

void measureDrive(ChannelQuality& out, const Bench& bench, const Recording& recording, const Track& track) {
  out.driveColumn = recordedInput(recording, bench);
  const std::vector<double>& drive = track.reference.empty() ? track.input : track.reference;
  const auto [low, high] = std::minmax_element(drive.begin(), drive.end());
  out.drivePeak = std::max(std::abs(*low), std::abs(*high));
  const auto count = [&drive, &track](auto holds) {
    return partOf(static_cast<size_t>(std::count_if(drive.begin(), drive.end(), holds)), track.rows());
  };
  const double atHigh = *high != 0.0 ? count([h = *high](double one) { return one == h; }) : 0.0;
  const double atLow = *low != 0.0 ? count([l = *low](double one) { return one == l; }) : 0.0;
  const double between = 1.0 - atHigh - atLow - count([](double one) { return one == 0.0; });
  // A command that goes between two levels stands at them by intention.
  out.atLimitPart = *low != *high && between > 0.2 ? atHigh + atLow : 0.0;
  out.driveReverses = count([](double one) { return one > 0.0; }) >= hardlyEver &&
                      count([](double one) { return one < 0.0; }) >= hardlyEver;
}

}  // namespace

ChannelQuality qualityOf(const Bench& bench, const Recording& recording, const Track& track) {
  ChannelQuality out;
  out.recording = recording.name();
  out.rows = track.rows();
  out.duration_s = track.time.back();
  out.rate_Hz = track.usualStep_s > 0.0 ? 1.0 / track.usualStep_s : 0.0;
  out.declaredCount = bench.count();
  out.readingNoise = track.readingNoise();
  out.readingStep = stepOf(track.speedAlone() ? track.speed : track.position, track.seen);
  out.currentNoise_A = bench.input == DriveInput::current ? track.inputNoise : track.currentNoise;
  measureTimes(out, track);
  measureMotion(out, bench, recording, track);
  measureDrive(out, bench, recording, track);
  return out;
}

std::vector<std::string> inWords(const ChannelQuality& q, const Bench& bench) {
  const Axis axis = bench.axis;
  const std::string unit = axis == Axis::rotary ? "rad" : "m";
  std::vector<std::string> out;
  out.push_back(
      fmt::format("{}: {} rows over {:.4g} s at {:.4g} Hz; moves over {}, up to {}, reverses {} times, stands {}",
                  q.recording, q.rows, q.duration_s, q.rate_Hz, travelText(q.travel, axis), speedText(q.fastest, axis),
                  q.reversals, percentText(q.restPart)));
  out.push_back(fmt::format("one reading is known to {:.2g} {}{}", q.readingNoise, unit,
                            q.currentNoise_A > 0.0 ? fmt::format(", the current to {:.2g} A", q.currentNoise_A) : ""));
  if (q.missingRows > 0)
    out.push_back(fmt::format("{} rows are missing, the longest pause is {:.3g} s: nobody knows what acted meanwhile",
                              q.missingRows, q.longestGap_s));
  if (q.jitter_s * q.rate_Hz > muchJitter)
    out.push_back(
        fmt::format("steps from row to row differ by {} typically: log at a steady rate", timeText(q.jitter_s)));
  if (q.rate_Hz > 0.0 && q.rate_Hz < slowRate_Hz)
    out.push_back(fmt::format("{:.3g} Hz is slow: what happens within {} can't be seen; log at 1 kHz if you can",
                              q.rate_Hz, timeText(1.0 / q.rate_Hz)));
  if (q.unreadPart > 0.0) out.push_back(percentText(q.unreadPart) + " of the rows have no position");
  if (q.repeatedPart > oftenRepeated)
    out.push_back(percentText(q.repeatedPart) +
                  " of the rows repeat the one before while it moves: the log is faster than what is measured, or the "
                  "encoder too coarse");
  if (q.readingStep > 0.0 && q.declaredCount > 0.0 && std::abs(q.readingStep / q.declaredCount - 1.0) > sameStep &&
      q.readingStep > q.declaredCount)
    out.push_back(fmt::format("readings come in steps of {:.4g} {}, {:.3g} of the counts that the bench declares",
                              q.readingStep, unit, q.readingStep / q.declaredCount));
  if (q.atLimitPart > oftenAtLimit)
    out.push_back(
        fmt::format("{} of the rows stand at the largest or smallest {}: it is clipped, or the drive "
                    "saturates; keep below that",
                    percentText(q.atLimitPart), q.driveColumn));
  if (!q.driveReverses)
    out.push_back(q.driveColumn + " hardly ever reverses: friction, load and offset look the same one way only");
  if (q.forwardsPart > oneWay || q.forwardsPart < 1.0 - oneWay)
    out.push_back("it moves one way nearly all the time: run it as long the other way");
  if (q.restPart > mostlyRests) out.push_back("it stands most of the time: little of the recording tells anything");
  return out;
}

}  // namespace breakaway
