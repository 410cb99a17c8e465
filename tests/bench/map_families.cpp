#include "bench/map_families.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "support/random_rig.h"

namespace breakaway::test {

namespace {

using Json = nlohmann::json;

/// Parts of the mean Coulomb friction, drawn once a rig.
class Change {
 public:
  Change(Json& rig, unsigned seed) : rig_(rig), noise_(7919u * seed + 3u) {}

  double uniform(double low, double high) { return low + (high - low) * noise_.uniform(); }
  double coulomb_Nm() const { return rig_["friction"]["coulomb_ccw"]["mean"].get<double>(); }
  double way() { return noise_.uniform() < 0.5 ? -1.0 : 1.0; }

  /// A wheel of 17 to 41 teeth that friction and torque follow.
  void geared() {
    const double teeth = std::floor(uniform(17.0, 42.0));
    for (const char* curve : {"static_cw", "static_ccw", "coulomb_cw", "coulomb_ccw"})
      rig_["friction"][curve]["harmonics"].push_back({teeth, uniform(0.02, 0.06), uniform(0.0, 6.28)});
    rig_["position_torque"]["harmonics_Nm"].push_back({teeth, coulomb_Nm() * uniform(0.01, 0.05), uniform(0.0, 6.28)});
  }
  void fewCounts() {
    const double counts[] = {64, 100, 128, 200, 256, 400, 500, 1000};
    rig_["encoder"]["counts_per_rev"] = counts[static_cast<size_t>(uniform(0.0, 8.0))];
  }
  /// The converter's step is 2 to 8 times the noise, and a sixth of the friction's current or less.
  void coarseCurrent() {
    const double friction_A = coulomb_Nm() / rig_["motor"]["torque_constant_Nm_per_A"].get<double>();
    const double step_A = friction_A * uniform(0.04, 0.16);
    Json& sensor = rig_["current_sensor"];
    const double bits = uniform(0.0, 1.0) < 0.5 ? 8.0 : 10.0;
    sensor["adc_bits"] = static_cast<int>(bits);
    sensor["sensitivity_V_per_A"] = 5.0 / std::exp2(bits) / step_A;
    sensor["noise_rms_A"] = step_A / uniform(2.0, 8.0);
  }
  void arm() {
    rig_["position_torque"]["harmonics_Nm"].push_back({1, coulomb_Nm() * uniform(0.25, 2.0), uniform(0.0, 6.28)});
  }
  void load() { rig_["wiring"] = {{{"fault", "load_Nm"}, {"value", way() * coulomb_Nm() * uniform(0.25, 0.9)}}}; }
  void disc() {
    rig_["encoder"]["eccentricity_rad"] = 0.05 * std::pow(uniform(0.1, 1.0), 2);
    rig_["encoder"]["eccentricity_phase_rad"] = uniform(0.0, 6.28);
  }

 private:
  Json& rig_;
  Noise noise_;
};

}  // namespace

const std::vector<MapFamily>& mapFamilies() {
  static const std::vector<MapFamily> families{{"sound", "as in the table above", 2},
                                               {"geared", "friction and torque follow a wheel's teeth", 2},
                                               {"counts", "an encoder of 64 to 1000 counts", 2},
                                               {"current", "a converter whose step is 2 to 8 times the noise", 2},
                                               {"one turn", "one turn of the breakaway sweep each way", 1},
                                               {"arm", "an arm of 0.25 to 2 times the friction", 2},
                                               {"load", "a constant load of 0.25 to 0.9 times the friction", 2},
                                               {"disc", "an encoder's disc off its centre by up to 0.05 rad", 2}};
  return families;
}

std::string familyRig(const std::string& family, unsigned seed) {
  Json rig = Json::parse(RandomRig(seed).text());
  Change change(rig, seed);
  if (family == "geared") change.geared();
  if (family == "counts") change.fewCounts();
  if (family == "current") change.coarseCurrent();
  if (family == "arm") change.arm();
  if (family == "load") change.load();
  if (family == "disc") change.disc();
  return rig.dump(1);
}

size_t familyBins(const std::string& family, unsigned seed) {
  const double counts = Json::parse(familyRig(family, seed))["encoder"]["counts_per_rev"];
  return static_cast<size_t>(std::clamp(0.5 * counts, 16.0, 180.0));
}

}  // namespace breakaway::test
