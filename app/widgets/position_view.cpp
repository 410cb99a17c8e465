#include "widgets/position_view.h"

#include <cmath>

#include "base/numbers.h"
#include "experiment/homing.h"
#include "session/bench_runs.h"
#include "session/connection.h"
#include "session/live_samples.h"
#include "widgets/rotor_dial.h"
#include "widgets/travel_strip.h"
#include "widgets/while_shown.h"

using namespace std::chrono_literals;

namespace breakaway {

PositionView::PositionView(const Connection& connection, const BenchRuns& bench, const LiveSamples& live,
                           QWidget* parent)
    : QStackedWidget(parent),
      connection_(connection),
      bench_(bench),
      live_(live),
      dial_(new RotorDial(this)),
      strip_(new TravelStrip(this)) {
  addWidget(dial_);
  addWidget(strip_);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  setMinimumSize(1, 1);  // where there is no room for it, it draws nothing
  connect(&connection_, &Connection::changed, this, &PositionView::refresh);
  new WhileShown(this, 33ms, [this] { return refresh(); });
}

bool PositionView::refresh() {
  const auto newest = live_.current();
  const auto at = newest ? std::optional(newest->angle_rad) : std::nullopt;
  const auto index = bench_.index_rad() ? std::optional(bench_.index_rad()->value) : std::nullopt;
  if (!connection_.linear()) {
    setCurrentWidget(dial_);
    dial_->show(at, index);
    followHoming(at);
    return newest.has_value();
  }
  setCurrentWidget(strip_);
  const bool homed = bench_.axisIsHomed();
  strip_->show(at, homed ? std::optional(bench_.known().counted) : std::nullopt, homed ? index : std::nullopt);
  return newest.has_value();
}

void PositionView::followHoming(std::optional<double> angle_rad) {
  const bool homing = connection_.runs(RunKind::homing) && connection_.run().running();
  const bool searches = homing && Homing::searches(connection_.run().status.activity);
  if (!homing) begin_rad_.reset();
  if (searches && !begin_rad_) begin_rad_ = angle_rad;
  if (!begin_rad_ || !angle_rad) return dial_->showWay({}, {});
  const double most_rad = HomingOptions().mostTurns * turn_rad - std::abs(*angle_rad - *begin_rad_);
  dial_->showWay(begin_rad_, searches ? std::optional(std::max(0.0, most_rad)) : std::nullopt);
}

}  // namespace breakaway
