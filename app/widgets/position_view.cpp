#include "widgets/position_view.h"

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
    return newest.has_value();
  }
  setCurrentWidget(strip_);
  const bool homed = bench_.axisIsHomed();
  strip_->show(at, homed ? std::optional(bench_.known().counted) : std::nullopt, homed ? index : std::nullopt);
  return newest.has_value();
}

}  // namespace breakaway
