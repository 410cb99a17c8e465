// Loads behind a spring or a gap, which a regression hardly shows: their shapes by simulation.
#pragma once

#include <optional>
#include <vector>

#include "diagnose/search/model_fit.h"
#include "diagnose/search/worth.h"

namespace breakaway {

/// Whether the effect brings a load along that has a motion of its own.
bool swings(const Pick& pick);
bool swings(const Model& model);
/// Whether its load hangs behind a gap.
bool inPlay(const Pick& pick);

/// Whether a load leaves hardly any of another model's squared error, in windows at whose start its place
/// is fitted. A load can follow a part of other physics, but not so much of it. After restarts, where its place is
/// guessed and it may run away, such a load need not do as clearly better.
bool loadFollowsAll(const FitResult& loaded, const FitResult& other, const Criteria& criteria);

/// Looks for loads beside one model. Impacts make the error of whole windows a wilderness; in windows so short that
/// they hold few impacts, and in longer ones for wide gaps, the best of a grid of shapes leads to the right valley.
class SwingingLoads {
 public:
  /// Preconditions: `input` and `worth` outlive it; `model` has no load that swings.
  SwingingLoads(const SearchInput& input, const Worth& worth, const Model& model);

  /// The catalogue's loads, each as the screen sees it best, or else at its first shape.
  static std::vector<Pick> offered(const SearchInput& input, const Screen& screen);
  /// The best fit of the model with the load to all training windows, from the shapes that do best: of the pick's own
  /// and those on offer, and then a step at a time from there. Not usable where no shape does anything.
  FitResult fitted(const Pick& pick) const;

 private:
  /// Windows of one length, evenly apart.
  struct View {
    std::vector<Window> windows;
    std::vector<double> own;  ///< the model's mean squared errors there
    double unit = 0.0;        ///< squared errors much below it don't count
  };
  struct Shaped {
    std::vector<double> parameters;
    double left = 1.0;
  };
  View viewOf(double window_s, size_t most) const;
  /// Geometric mean over the view's windows of what the load leaves of the model's squared error.
  double leftBy(const Pick& pick, const View& view) const;
  std::vector<std::vector<double>> grid(const Pick& pick) const;
  /// The effect's variants of each shape.
  std::vector<std::vector<double>> variants(const std::vector<std::vector<double>>& shapes, const Pick& pick) const;
  std::vector<std::vector<double>> spread(const Pick& pick) const;
  std::vector<Shaped> bestOf(const std::vector<std::vector<double>>& candidates, const Pick& pick, const View& view,
                             size_t most) const;
  /// Simulated steps of so many runs over windows and of their restarts; each row takes as many as the load's shape
  /// asks for, and one that takes long counts several times.
  double stepsOf(const std::vector<Window>& windows, const Pick& pick, double runs) const;
  static void sortByLeft(std::vector<Shaped>& shapes);
  void walk(Shaped& best, const Pick& pick, const View& view) const;
  /// The model with the load, all of it fitted to the view's windows: what a load that swings made of inertia and
  /// friction in whole windows hides it from its shapes alone. Nothing where that leaves nearly as much.
  std::optional<Model> fittedTo(const View& view, const Pick& pick) const;

  const SearchInput& input_;
  const Criteria& limits_;
  const Worth& worth_;
  const Model model_;
};

/// Geometric mean of what the first leaves of the second, window by window. Windows that err by less than `hardly` of
/// the second's mean, as those at rest do, hardly count.
double typicalPart(const std::vector<double>& squares, const std::vector<double>& ofSquares, double hardly);

}  // namespace breakaway
