#include <algorithm>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr double leastLate = -0.7, mostLate = -3.5;  ///< rows by which a log may stamp its commands late

/// The command acts later than the recording says, or was stamped late and acts earlier (T below 0); each row's share
/// of what comes before or after is exact for a held command.
class TransportDelay final : public Effect, private InputPart {
 public:
  std::string_view name() const override { return "transport_delay"; }
  std::string_view formula() const override { return "u(t) → u(t − T)"; }
  std::string_view source() const override {
    return "K. J. Åström, B. Wittenmark, 'Computer-Controlled Systems', Prentice Hall 1997, chapter 2: sampling a "
           "system with time delay";
  }
  std::vector<ParameterSpec> parameters(Axis) const override { return {{"delay_s", -1.0, 10.0}}; }
  const InputPart* input(DriveInput) const override { return this; }
  Written written(std::span<const double> p, Axis) const override {
    if (p[0] < 0.0) return {.lacking = "it would act before it is commanded"};
    return {.delay = "p0"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (seen.byReference || seen.step_s <= 0.0) return shapes;
    for (const double rows : {-1.0, -2.0}) shapes.push_back({{rows * seen.step_s}});
    for (double rows = 0.5; rows < 21.0; rows *= 1.7) shapes.push_back({{rows * seen.step_s}});
    return shapes;
  }
  std::vector<double> scaled(const Shape& shape, std::span<const double> amplitude) const override {
    const bool late = shape[0][0] < 0.0;
    return {shape[0][0] * std::clamp(amplitude[0], late ? 0.75 : 0.05, late ? 1.6 : 3.0)};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    // Within a row nobody knows when a logged command acted.
    if (p[0] < 0.0 && seen.driveMeasured) return false;  // it isn't commanded: channel_skew
    if (p[0] < 0.0) return p[0] < leastLate * seen.step_s && p[0] > mostLate * seen.step_s;
    // What a drive's own loop takes is the base's.
    return p[0] > std::max(0.02 * seen.step_s, seen.followsWithin_s) && p[0] < std::min(0.2, 0.05 * seen.duration_s);
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    if (p[0] < 0.0) {
      return message(
          "What is commanded acted {} earlier than the recording says ({} rows): the log stamps its commands late. "
          "Look at when rows get their time.",
          timeText(-p[0]), digitsText(-p[0] / seen.step_s));
    }
    return message(
        "What is commanded acts {} later than the recording says ({} rows): communication, the drive's own cycle or a "
        "filter. Look at when rows get their time, and at the drive's cycle time.",
        timeText(p[0]), digitsText(p[0] / seen.step_s));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"channel_skew", "compliance"}; }
  std::vector<Tell> tells() const override { return {{"compliance", message("delays all frequencies alike")}}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Step the command between ±{} at random times, at least {} apart.", digitsText(0.5 * seen.peakInput),
                   timeText(20.0 * seen.step_s));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    if (!(seen.peakCurrent > 0.0)) return {};
    Maneuver steps;
    for (const double rows : {31.0, 20.0, 43.0, 26.0, 37.0})
      steps = steps + currentPulses({0.5 * seen.peakCurrent}, rows * seen.step_s, 20.0 * seen.step_s);
    return steps + steps + steps + steps;
  }
  std::string_view drawnOver() const override { return "frequency"; }

 private:
  double delay_s(std::span<const double> p) const override { return std::max(p[0], 0.0); }
  std::optional<double> otherwiseLate_rows() const override { return 0.0; }  // a command acts from its row on
  void shape(std::span<const double> p, std::span<const double> time_s, std::span<double> input) const override {
    const std::vector<double> held(input.begin(), input.end());
    const size_t rows = held.size();
    // Row k takes the mean of the held command over [t_k − T, t_{k+1} − T]; `row` is where its begin falls.
    size_t row = 0;
    for (size_t k = 0; k + 1 < rows; ++k) {
      double from = time_s[k] - p[0];
      const double to = time_s[k + 1] - p[0];
      while (row + 1 < rows && time_s[row + 1] <= from) ++row;
      double sum = 0.0;
      for (size_t part = row; from < to; ++part) {
        const double end = part + 1 < rows ? std::min(time_s[part + 1], to) : to;
        if (end <= from) continue;
        sum += held[part] * (end - from);
        from = end;
      }
      input[k] = sum / (time_s[k + 1] - time_s[k]);
    }
    if (rows > 1) input[rows - 1] = input[rows - 2];
  }
};

}  // namespace

const Effect& transportDelay() {
  static const TransportDelay effect;
  return effect;
}

}  // namespace breakaway
