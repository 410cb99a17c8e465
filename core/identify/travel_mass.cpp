#include "identify/travel_mass.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace breakaway {

namespace {

/// Some blocks one after the other, in which the axis went one way.
struct Window {
  double impulse = 0.0, change = 0.0, duration = 0.0, travel = 0.0;
};

constexpr size_t massPlaces = 10, leastWindows = 20;
using WindowGroups = std::array<std::vector<Window>, 2 * massPlaces>;  // by place and way

/// A window is a fortieth of a stroke, or four blocks; speeds at its ends are over a quarter of it.
size_t windowBlocks(const std::vector<SpinBlock>& blocks) {
  size_t turns = 1;
  double before = 0.0;
  for (size_t k = 1; k < blocks.size(); ++k) {
    const double step = blocks[k].angle_rad - blocks[k - 1].angle_rad;
    if (step * before < 0.0) ++turns;
    if (step != 0.0) before = step;
  }
  return std::clamp<size_t>(blocks.size() / turns / 40, 4, 400);
}

WindowGroups windowsOf(const std::vector<SpinBlock>& blocks, double forceConstant) {
  const size_t width = windowBlocks(blocks), half = std::max<size_t>(1, width / 8);
  double low = blocks.front().angle_rad, high = low, fastest = 0.0;
  const auto speed = [&](size_t k) {
    return (blocks[k + half].angle_rad - blocks[k - half].angle_rad) /
           (blocks[k + half].end_s - blocks[k - half].end_s);
  };
  for (size_t k = half; k + half < blocks.size(); ++k) {
    low = std::min(low, blocks[k].angle_rad), high = std::max(high, blocks[k].angle_rad);
    fastest = std::max(fastest, std::abs(speed(k)));
  }
  WindowGroups groups;
  for (size_t k = half; k + width + half < blocks.size(); k += width) {
    bool oneWay = true;
    for (size_t j = k; j <= k + width; ++j)
      oneWay = oneWay && speed(j) * speed(k) > 0.0 && std::abs(speed(j)) > 0.1 * fastest;
    if (!oneWay) continue;
    Window window{0.0, speed(k + width) - speed(k), 0.0, blocks[k + width].angle_rad - blocks[k].angle_rad};
    for (size_t j = k + 1; j <= k + width; ++j) {
      window.impulse += forceConstant * blocks[j].current_A * blocks[j].duration_s;
      window.duration += blocks[j].duration_s;
    }
    const double part = (blocks[k + width / 2].angle_rad - low) / (high - low);
    const auto place = std::min(massPlaces - 1, static_cast<size_t>(part * static_cast<double>(massPlaces)));
    groups[2 * place + (speed(k) > 0.0 ? 1 : 0)].push_back(window);
  }
  return groups;
}

}  // namespace

Result<Estimate> massByStrokes(const std::vector<SpinBlock>& blocks, double forceConstant_N_per_A) {
  if (blocks.size() < 2 * leastWindows) return Error{"strokes", message("left too few blocks to tell the mass")};
  const WindowGroups groups = windowsOf(blocks, forceConstant_N_per_A);
  size_t windows = 0;
  for (const auto& group : groups) windows += group.size();
  if (windows < leastWindows) return Error{"strokes", message("went one way in too few windows to tell the mass")};
  // Friction over a window is C·Δt + B·Δx, with C of each place and way its own and one B.
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  double squares = 0.0, freedom = -2.0;
  for (const auto& group : groups) {
    double tt = 0.0;
    Eigen::Vector3d tx = Eigen::Vector3d::Zero();
    for (const Window& w : group) {
      tt += w.duration * w.duration;
      tx += w.duration * Eigen::Vector3d(w.change, w.travel, w.impulse);
    }
    if (group.size() < 2) continue;
    freedom += static_cast<double>(group.size()) - 1.0;
    for (const Window& w : group) {
      const Eigen::Vector3d left = Eigen::Vector3d(w.change, w.travel, w.impulse) - w.duration / tt * tx;
      normal += left.head<2>() * left.head<2>().transpose();
      right += left[2] * left.head<2>();
      squares += left[2] * left[2];
    }
  }
  const Eigen::Vector2d x = normal.ldlt().solve(right);
  const double scale = std::max(0.0, squares - right.dot(x)) / std::max(1.0, freedom);
  const double error = std::sqrt(scale * normal.inverse()(0, 0));
  if (!(x[0] > 0.0) || !std::isfinite(error)) return Error{"strokes", message("show no mass, expected a positive one")};
  return Estimate{x[0], std::hypot(error, 1.5e-3 * x[0])};
}

}  // namespace breakaway
