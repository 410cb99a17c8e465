#include "recording/import/drive_evidence.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "dense/dense_solve.h"
#include "recording/import/columns_beside.h"
#include "recording/import/settle_motion.h"

namespace breakaway {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// Means over spans of rows, a row each: of a drive, and of what it has to overcome (constant, direction, speed,
/// acceleration; as many rows × 4).
struct Spans {
  VectorXd drive;
  MatrixXd overcome;
};

Spans spansOf(const std::vector<double>& time_s, const std::vector<double>& speed, const std::vector<double>& drive,
              const std::vector<size_t>& pauses) {
  constexpr size_t mostSpans = 200;
  const size_t rows = speed.size(), length = std::max<size_t>(2, rows / mostSpans);
  const double standing = 0.02 * largest(speed);
  Spans spans{VectorXd(rows / length), MatrixXd(rows / length, 4)};
  Eigen::Index count = 0;
  for (size_t from = 0; from + length < rows; from += length) {
    const size_t to = from + length;
    const bool pause = std::any_of(pauses.begin(), pauses.end(), [&](size_t at) { return at > from && at <= to; });
    double driven = 0.0, moved = 0.0, way = 0.0;
    for (size_t k = from; k < to; ++k) {
      driven += drive[k] / static_cast<double>(length);
      moved += speed[k] / static_cast<double>(length);
      way += std::tanh(speed[k] / standing) / static_cast<double>(length);
    }
    const double gained = (speed[to] - speed[from]) / (time_s[to] - time_s[from]);
    if (pause || !std::isfinite(driven + moved + gained)) continue;
    spans.drive[count] = driven;
    spans.overcome.row(count++) << 1.0, way, moved, gained;
  }
  return {spans.drive.head(count), spans.overcome.topRows(count)};
}

/// Which part of the drive's variance acceleration and friction make.
double explainedBy(const VectorXd& drive, const MatrixXd& overcome) {
  constexpr Eigen::Index fewest = 20;
  if (drive.size() < fewest) return 0.0;
  const double all = (drive.array() - drive.mean()).matrix().squaredNorm();
  const VectorXd rest = leftByLeastSquares(overcome, drive);
  return all > 0.0 ? 1.0 - rest.squaredNorm() / all : 0.0;
}

/// The rows that are looked at.
std::vector<double> beginOf(const RawTable& table, size_t column) {
  constexpr size_t most = 100'000;
  const auto& values = table.columns[column].channel.values;
  return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(std::min(most, values.size()))};
}

/// The columns that would be taken as `to`, but for their place.
std::vector<size_t> firstAs(std::string_view to, const RawTable& table, const std::vector<int>& ranks,
                            const std::vector<Choice>& choices) {
  std::vector<size_t> first;
  for (size_t c = 0; c < choices.size(); ++c) {
    if (choices[c].name.to != to || table.columns[c].fault) continue;
    if (choices[c].byMap || choices[c].byTool) return {};
    if (!first.empty() && ranks[c] < ranks[first[0]]) first.clear();
    if (first.empty() || ranks[c] == ranks[first[0]]) first.push_back(c);
  }
  return first;
}

/// How fast it goes, in any unit; from row to row where only the angle tells.
std::vector<double> speedOf(const RawTable& table, const std::vector<size_t>& angles,
                            const std::vector<size_t>& speeds) {
  if (!speeds.empty()) return beginOf(table, speeds[0]);
  if (angles.empty()) return {};
  std::vector<double> angle = beginOf(table, angles[0]);
  if (const auto period = periodOf(angle, {}, std::nullopt)) unwind(angle, *period, {});
  return changesOf(angle);
}

/// Keeps the one of `alike` of which `evidence` is far more than of the first.
template <typename Evidence>
void preferOf(const std::vector<size_t>& alike, const RawTable& table, std::vector<Choice>& choices,
              const Evidence& evidence) {
  constexpr double farMore = 0.3, same = 0.95;
  constexpr size_t most = 6;
  if (alike.size() < 2 || alike.size() > most) return;
  const std::vector<double> first = beginOf(table, alike[0]);
  const double itsOwn = evidence(first);
  size_t best = alike[0];
  double bestsOwn = itsOwn + farMore;
  for (size_t k = 1; k < alike.size(); ++k) {
    const std::vector<double> other = beginOf(table, alike[k]);
    if (likenessOf(first, other).correlation >= same) continue;
    const double others = evidence(other);
    if (others <= bestsOwn) continue;
    best = alike[k];
    bestsOwn = others;
  }
  if (best == alike[0]) return;
  choices[best].name.guess = message("the motion goes with it more than with {}", table.columns[alike[0]].channel.name);
  for (const size_t c : alike) {
    if (c != best) setAside(choices[c], message("the motion goes with {} instead", table.columns[best].channel.name));
  }
}

}  // namespace

double drivenBy(const std::vector<double>& time_s, const std::vector<double>& speed, const std::vector<double>& drive,
                const std::vector<size_t>& pauses) {
  const Spans spans = spansOf(time_s, speed, drive, pauses);
  if (spans.drive.dot(spans.overcome.col(2)) <= 0.0) return 0.0;
  constexpr auto shares = std::to_array({0.11, 0.19, 0.27, 0.38, 0.5});
  double elsewhere = 0.0;
  for (const double share : shares) {
    const Eigen::Index left = spans.drive.size() - static_cast<Eigen::Index>(share * spans.drive.size());
    elsewhere += explainedBy(spans.drive.tail(left), spans.overcome.topRows(left)) / shares.size();
  }
  return explainedBy(spans.drive, spans.overcome) - elsewhere;
}

Following followingOf(const std::vector<double>& reference, const std::vector<double>& measured) {
  MatrixXd both(reference.size(), 2);
  Eigen::Index count = 0;
  for (size_t k = 0; k < reference.size(); ++k) {
    if (std::isfinite(reference[k]) && std::isfinite(measured[k])) both.row(count++) << reference[k], measured[k];
  }
  if (count == 0) return {};
  const MatrixXd about = both.topRows(count).rowwise() - both.topRows(count).colwise().mean();
  const double size = about.col(0).squaredNorm(), other = about.col(1).squaredNorm();
  if (!(size > 0.0) || !(other > 0.0)) return {};
  const double common = about.col(0).dot(about.col(1));
  return {common / std::sqrt(size * other), common / size};
}

double followedBy(const std::vector<double>& reference, const std::vector<double>& measured) {
  constexpr auto lags = std::to_array({0.0, 0.01, 0.03, 0.1});  // of the rows
  double most = -1.0;
  for (const double lag : lags) {
    const auto rows = static_cast<std::ptrdiff_t>(lag * static_cast<double>(measured.size()));
    const std::vector<double> shall{reference.begin(), reference.end() - rows},
        later{measured.begin() + rows, measured.end()};
    most = std::max(most, followingOf(shall, later).correlation);
  }
  return most;
}

void preferMotionsOwn(const RawTable& table, const std::vector<int>& ranks, std::vector<Choice>& choices) {
  const auto angles = firstAs("angle_rad", table, ranks, choices),
             speeds = firstAs("velocity_rad_per_s", table, ranks, choices);
  const std::vector<double> speed = speedOf(table, angles, speeds);
  if (speed.empty()) return;
  std::vector<double> rows(speed.size());
  std::iota(rows.begin(), rows.end(), 0.0);
  for (const std::string_view to : {"torque_Nm", "current_A", "voltage_V", "duty"}) {
    preferOf(firstAs(to, table, ranks, choices), table, choices,
             [&](const std::vector<double>& drive) { return std::max(0.0, drivenBy(rows, speed, drive, {})); });
  }
  for (const auto& [to, measured] :
       {std::pair("angle_reference_rad", angles), std::pair("velocity_reference_rad_per_s", speeds)}) {
    if (measured.empty()) continue;
    const std::vector<double> is = beginOf(table, measured[0]);
    preferOf(firstAs(to, table, ranks, choices), table, choices,
             [&](const std::vector<double>& shall) { return followedBy(shall, is); });
  }
}

}  // namespace breakaway
