#include "bench/map_score.h"

#include <cmath>
#include <functional>
#include <sstream>
#include <vector>

#include "support/map_bound.h"

namespace breakaway::test {

namespace {

template <typename Use>
void eachNumber(MapScore& score, Use use) {
  const auto curve = [&use](CurveScore& one) {
    for (double* value : {&one.rms, &one.bound, &one.mean, &one.covered}) use(*value);
  };
  for (WayScore& way : score.way) {
    for (CurveScore* one : {&way.still, &way.coulomb, &way.viscous}) curve(*one);
    use(way.correlation);
    use(way.noiseOverSpread);
  }
  curve(score.friction);
  curve(score.position);
  for (double* value : {&score.rig_s, &score.cpu_s, &score.missed}) use(*value);
}

using Read = std::function<Estimate(const MapBin&)>;

CurveScore compared(const FrictionMap& map, const FrictionMap& truth, const Read& read, double level, double bound) {
  CurveScore score;
  for (size_t k = 0; k < truth.bins.size(); ++k) {
    const Estimate measured = read(map.bins[k]);
    const double error = measured.value - read(truth.bins[k]).value;
    score.rms += error * error;
    score.mean += error;
    score.covered += std::abs(error) <= 1.959964 * measured.standardError ? 1.0 : 0.0;
  }
  const auto n = static_cast<double>(truth.bins.size());
  return {std::sqrt(score.rms / n) / level, bound / level, score.mean / n / level, score.covered / n};
}

double meanOf(const FrictionMap& map, const Read& read) {
  double sum = 0.0;
  for (const MapBin& bin : map.bins) sum += read(bin).value;
  return sum / static_cast<double>(map.bins.size());
}

double spreadOf(const FrictionMap& map, const Read& read) {
  const double middle = meanOf(map, read);
  double squares = 0.0;
  for (const MapBin& bin : map.bins) squares += std::pow(read(bin).value - middle, 2);
  return std::sqrt(squares / static_cast<double>(map.bins.size()));
}

}  // namespace

std::string MapScore::line() const {
  std::ostringstream out;
  out.precision(9);
  out << rig << '\t' << failure << '\t';
  MapScore copy = *this;
  eachNumber(copy, [&out](double& value) { out << value << ' '; });
  return out.str();
}

std::optional<MapScore> MapScore::fromLine(const std::string& line) {
  const size_t first = line.find('\t'), second = first == std::string::npos ? first : line.find('\t', first + 1);
  if (second == std::string::npos) return {};
  MapScore score;
  score.rig = line.substr(0, first);
  score.failure = line.substr(first + 1, second - first - 1);
  std::istringstream in(line.substr(second + 1));
  eachNumber(score, [&in](double& value) { in >> value; });
  return in ? std::optional<MapScore>(score) : std::nullopt;
}

void compare(const Commission& done, const FrictionMap& truth, const Rig& rig, MapScore& score) {
  const FrictionMap& map = done.map;
  for (const Way way : {Way::cw, Way::ccw}) {
    const auto w = static_cast<size_t>(way);
    const Read still = [w](const MapBin& bin) { return bin.way[w].static_Nm; };
    const Read coulomb = [w](const MapBin& bin) { return bin.way[w].coulomb_Nm; };
    const Read viscous = [w](const MapBin& bin) { return bin.way[w].viscous_Nm_s_per_rad; };
    WayBound bound;
    boundMoving(rig, done.runs, way, done.zeroing_s, bound);
    bound.static_Nm =
        boundStatic(rig, done.events, way, static_cast<double>(done.zeroings) * done.zeroing_s * rig.loopRate_Hz);
    WayScore& one = score.way[w];
    one.still = compared(map, truth, still, meanOf(truth, still), bound.static_Nm);
    one.coulomb = compared(map, truth, coulomb, meanOf(truth, coulomb), bound.coulomb_Nm);
    one.viscous = compared(map, truth, viscous, meanOf(truth, viscous), bound.viscous_Nm_s_per_rad);
    one.correlation = map.repeatability[w].correlation;
    one.noiseOverSpread = map.repeatability[w].rmsDifference_Nm / std::sqrt(2.0) / spreadOf(truth, still);
  }
  const auto halves = [](const MapBin& bin) {
    return 0.5 * std::hypot(bin.way[0].static_Nm.standardError, bin.way[1].static_Nm.standardError);
  };
  const Read friction = [&](const MapBin& bin) { return Estimate{bin.staticFriction_Nm(), halves(bin)}; };
  const Read position = [&](const MapBin& bin) { return Estimate{bin.positionTorque_Nm(), halves(bin)}; };
  const double level = meanOf(truth, friction);
  const double bound =
      std::hypot(score.way[0].still.bound * meanOf(truth, [](const auto& b) { return b.way[0].static_Nm; }),
                 score.way[1].still.bound * meanOf(truth, [](const auto& b) { return b.way[1].static_Nm; }));
  score.friction = compared(map, truth, friction, level, 0.5 * bound);
  score.position = compared(map, truth, position, level, 0.5 * bound);
  score.rig_s = done.rigTime_s;
  score.missed = static_cast<double>(done.missed);
}

}  // namespace breakaway::test
