// Where the rotor or the axis is now: a dial, or a strip of the travel.
#pragma once

#include <QStackedWidget>
#include <optional>

namespace breakaway {

class BenchRuns;
class Connection;
class LiveSamples;
class RotorDial;
class TravelStrip;

class PositionView : public QStackedWidget {
 public:
  PositionView(const Connection& connection, const BenchRuns& bench, const LiveSamples& live, QWidget* parent);

 private:
  bool refresh();
  /// How far the rotor has come since its homing began.
  void followHoming(std::optional<double> angle_rad);

  const Connection& connection_;
  const BenchRuns& bench_;
  const LiveSamples& live_;
  std::optional<double> begin_rad_;  ///< of the homing that runs
  RotorDial* dial_ = nullptr;
  TravelStrip* strip_ = nullptr;
};

}  // namespace breakaway
