#include <algorithm>
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// The measured current is late against the position by T (early when negative). Where current drives, what acted is
/// the recorded one, advanced by T.
class ChannelSkew final : public Effect, private InputPart, private CurrentSensorPart {
 public:
  std::string_view name() const override { return "channel_skew"; }
  std::string_view formula() const override { return "shown current = i(t − T) ≈ i − T di/dt"; }
  std::string_view source() const override {
    return "C. H. Knapp, G. C. Carter, 'The generalized correlation method for estimation of time delay', IEEE Trans. "
           "Acoustics, Speech, and Signal Processing 24(4), 1976: the delay between two channels";
  }
  std::vector<ParameterSpec> parameters(Axis) const override { return {{"skew_s", -1.0, 1.0}}; }
  const CurrentSensorPart* currentSensor() const override { return this; }
  const InputPart* input(DriveInput drive) const override { return drive == DriveInput::current ? this : nullptr; }
  Written written(std::span<const double>, Axis) const override {
    return {.lacking = "it says when the current was recorded, not what the motor does"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    if (seen.step_s <= 0.0) return {};
    if (seen.electrical && seen.currentSeen) return {Shape{{seen.step_s}}};
    if (!seen.currentDrive) return {};
    std::vector<Shape> shapes;
    for (const double rows : {1.0, 3.0, 8.0}) shapes.push_back({{rows * seen.step_s}});
    return shapes;
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    // A current that drives and is recorded before it acts is a delay by another name; how late within its row a
    // measured one was read is the base's (driveLateName).
    if (seen.currentDrive && p[0] <= (seen.driveMeasured ? seen.step_s : 0.0)) return false;
    return std::abs(p[0]) < std::min(0.1, 30.0 * seen.step_s);
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "The current is recorded {} {} than the position ({} rows). Look at the current's filter, and at when each "
        "channel is sampled.",
        timeText(std::abs(p[0])), p[0] > 0.0 ? message("later") : message("earlier"),
        digitsText(std::abs(p[0]) / seen.step_s));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"transport_delay"}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Give short pulses of {}, {} long and well apart: each marks its time on both channels.",
                   quantityText(0.7 * seen.peakCurrent, "A"), timeText(10.0 * seen.step_s));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    if (!(seen.peakCurrent > 0.0)) return {};
    Maneuver pulses;
    for (int k = 0; k < 10; ++k) pulses = pulses + currentPulses({0.7 * seen.peakCurrent}, 10.0 * seen.step_s, 0.5);
    return pulses;
  }
  std::string_view drawnOver() const override { return "frequency"; }

 private:
  double sensed(std::span<const double> p, double current, double slope) const override {
    return current - p[0] * slope;
  }
  double lag_s(std::span<const double> p) const override { return p[0]; }
  std::optional<double> otherwiseLate_rows() const override { return 0.5; }  // read at the row's instant
  void shape(std::span<const double> p, std::span<const double> time_s, std::span<double> input) const override {
    if (input.size() < 2) return;
    const std::vector<double> recorded(input.begin(), input.end());
    size_t row = 0;  // the last row at or before t + T, but for the last of all
    for (size_t k = 0; k < input.size(); ++k) {
      const double t = time_s[k] + p[0];
      while (row + 2 < recorded.size() && time_s[row + 1] <= t) ++row;
      const double part = std::clamp((t - time_s[row]) / (time_s[row + 1] - time_s[row]), 0.0, 1.0);
      input[k] = recorded[row] + part * (recorded[row + 1] - recorded[row]);
    }
  }
};

}  // namespace

const Effect& channelSkew() {
  static const ChannelSkew effect;
  return effect;
}

}  // namespace breakaway
