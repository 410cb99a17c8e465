#include "recording/import/drive_evidence.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

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
  const VectorXd rest = drive - overcome * overcome.colPivHouseholderQr().solve(drive);
  return all > 0.0 ? 1.0 - rest.squaredNorm() / all : 0.0;
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

}  // namespace breakaway
