#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// The sensor shows a current where none flows. Where current drives, the recorded current is what the sensor shows,
/// and for the motion the offset is one and the same as a constant load: only a recorded voltage tells
/// (sensorOffset()).
class CurrentSensorOffset final : public Effect, private InputPart, private CurrentSensorPart {
 public:
  std::string_view name() const override { return "current_sensor_offset"; }
  std::string_view formula() const override { return "shown current = i + c"; }
  std::string_view source() const override {
    return "D.-W. Chung, S.-K. Sul, 'Analysis and compensation of current measurement error in vector-controlled AC "
           "motor drives', IEEE Trans. Industry Applications 34(2), 1998";
  }
  std::vector<ParameterSpec> parameters(Axis) const override { return {{"offset_A", -1e9, 1e9}}; }
  const CurrentSensorPart* currentSensor() const override { return this; }
  const InputPart* input(DriveInput drive) const override { return drive == DriveInput::current ? this : nullptr; }
  Written written(std::span<const double>, Axis) const override {
    return {.input = "drive_input = drive_input - p0;", .sensed = "current + p0"};
  }
  std::optional<JointShare> joint(std::span<const double> p) const override { return JointShare{.inputOffset = p[0]}; }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    if (!seen.electrical || !seen.currentSeen || seen.peakCurrent <= 0.0) return {};
    return {Shape{{0.02 * seen.peakCurrent}}};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    // Zeroing leaves most sensors off by some tenths of a percent.
    return std::abs(p[0]) > 0.008 * seen.peakCurrent && std::abs(p[0]) < 0.5 * seen.peakCurrent;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const Message shows =
        seen.currentDrive
            ? message("the recorded voltage says so, and a motor driven by it is pushed {}", wayText(-p[0], seen.axis))
            : message("the motion knows nothing of it");
    return message(
        "The current sensor shows {} {} at every current ({} of the peak); {}. Zero the sensor with the drive off, and "
        "look at its reference and temperature.",
        quantityText(std::abs(p[0]), "A"), p[0] > 0.0 ? message("too much") : message("too little"),
        percentText(std::abs(p[0]) / seen.peakCurrent), shows);
  }
  std::vector<std::string_view> lookAlikes() const override { return {"constant_load", "coulomb_asymmetry"}; }
  Message neededExcitation(const Excitation&) const override {
    return message("Record one second with the drive off, then move both ways with voltage and current recorded.");
  }

 private:
  double sensed(std::span<const double> p, double current, double) const override { return current + p[0]; }
  std::string_view sameForMotion() const override { return "constant_load"; }
  void shape(std::span<const double> p, std::span<const double>, std::span<double> input) const override {
    for (double& value : input) value -= p[0];
  }
};

}  // namespace

const Effect& currentSensorOffset() {
  static const CurrentSensorOffset effect;
  return effect;
}

}  // namespace breakaway
