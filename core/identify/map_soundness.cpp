#include "identify/map_soundness.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr double leastOverCoulomb = 0.9;  // breakaway falls to Coulomb friction at least
constexpr double mostOfNone = 0.25;       // of what starts it, likewise
constexpr double largeVariation = 0.1, leastCorrelation = 0.5, mostEmpty = 0.2;

struct Words {
  Message torque;
  const char* unit;
  Message pass, ways[2];
  double scale;
};

const Words& wordsOf(Axis axis) {
  static const Words rotor{
      message("torque"), "mNm", message("turns"), {message("clockwise"), message("counter-clockwise")}, 1e3};
  static const Words travel{message("force"), "N", message("passes"), {message("backwards"), message("forwards")}, 1.0};
  return axis == Axis::linear ? travel : rotor;
}

void belowCoulomb(const FrictionMap& map, std::vector<Message>& why) {
  double still = 0.0;
  for (const MapBin& bin : map.bins) still += bin.staticFriction_Nm() / static_cast<double>(map.bins.size());
  const Estimate& moving = map.coulombAverage_Nm;
  if (still > leastOverCoulomb * moving.value - 2.0 * moving.standardError) return;
  const Words& words = wordsOf(map.axis);
  why.push_back(
      message("what starts motion ({:.3g} {}) is less than what keeps it up ({:.3g} {}): play, a "
              "slipping coupling or a shaft that is pushed",
              words.scale * still, words.unit, words.scale * moving.value, words.unit));
}

/// What moves may take no friction at all, and surely takes next to none of what starts it: no oil does that, but a
/// load that came and went while one of the speeds was run.
void noneWhileMoving(const FrictionMap& map, std::vector<Message>& why) {
  double still = 0.0;
  for (const MapBin& bin : map.bins) still += bin.staticFriction_Nm() / static_cast<double>(map.bins.size());
  const Estimate& moving = map.coulombAverage_Nm;
  if (moving.low95() > 0.0 || moving.high95() > mostOfNone * still) return;
  const Words& words = wordsOf(map.axis);
  why.push_back(message(
      "what keeps motion up ({:.3g}, {:.3g} to {:.3g} {}) may be nothing beside what starts it ({:.3g} {}): the "
      "speeds contradict each other, as where a load comes and goes meanwhile",
      words.scale * moving.value, words.scale * moving.low95(), words.scale * moving.high95(), words.unit,
      words.scale * still, words.unit));
}

/// Of one turn's curve around its mean, part of that.
double variationOf(const std::vector<double>& curve) {
  const double middle = mean(curve);
  double squares = 0.0;
  for (const double one : curve) squares += (one - middle) * (one - middle);
  return middle != 0.0 ? std::sqrt(squares / static_cast<double>(curve.size())) / std::abs(middle) : 0.0;
}

void unlike(const FrictionMap& map, size_t way, std::vector<Message>& why) {
  if (map.turnStatic_Nm[way].size() < 2 || map.repeatability[way].correlation >= leastCorrelation) return;
  double variation = 0.0;
  for (const auto& turn : map.turnStatic_Nm[way]) variation = std::max(variation, variationOf(turn));
  if (variation < largeVariation) return;
  const Words& words = wordsOf(map.axis);
  why.push_back(message("{} {} correlate by {:.2f} only, though the breakaway {} varies by {:.0f} %", words.ways[way],
                        words.pass, map.repeatability[way].correlation, words.torque, 100.0 * variation));
}

/// Whether a breakaway was measured in the bin, or as near as the encoder lets a rotor be held.
bool isServed(const FrictionMap& map, size_t bin, size_t way, size_t reach) {
  const size_t n = map.bins.size();
  for (size_t k = 0; k <= std::min(reach, n - 1); ++k) {
    if (map.bins[(bin + k) % n].way[way].samples > 0 || map.bins[(bin + n - k) % n].way[way].samples > 0) return true;
  }
  return false;
}

void empty(const FrictionMap& map, size_t way, size_t reach, std::vector<Message>& why) {
  size_t none = 0;
  for (size_t k = 0; k < map.bins.size(); ++k) none += isServed(map, k, way, reach) ? 0 : 1;
  const auto all = static_cast<double>(map.bins.size());
  if (static_cast<double>(none) <= mostEmpty * all) return;
  why.push_back(message("{} of {} bins {} have no breakaway of their own: fewer bins (--bins) would have", none,
                        map.bins.size(), wordsOf(map.axis).ways[way]));
}

}  // namespace

std::vector<Message> unsoundness(const FrictionMap& map, size_t reach) {
  std::vector<Message> why;
  if (map.bins.empty()) return why;
  belowCoulomb(map, why);
  noneWhileMoving(map, why);
  for (size_t way = 0; way < 2; ++way) {
    unlike(map, way, why);
    empty(map, way, reach, why);
  }
  return why;
}

}  // namespace breakaway
