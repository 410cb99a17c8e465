#include <QTest>

#include "plant/rig.h"
#include "support/random_rig.h"

using namespace breakaway;

class TestRig : public QObject {
  Q_OBJECT
 private slots:
  void randomRigs_areRead();
  void curve_isMeanTimesHarmonics();
  void unknownField_getsASuggestion();
  void negativeInertia_isNamed();
  void fractionalOrder_isRefused();
  void frictionBelowZero_isRefused();
  void unknownEffect_namesTheKnownOnes();
  void unknownEffectParameter_isRefused();
  void leftOutEffectParameter_takesItsDefault();
  void faults_areRead();
  void unknownFault_namesTheKnownOnes();
  void supplyAboveWhole_isRefused();
  void fallingDutyCurve_isRefused();
  void tolerancesBeyondReason_areRefused();
  void honestRandomRigs_areRead();
};

namespace {

std::string rigText(const std::string& inertia = "6e-5", const std::string& staticHarmonics = "[]",
                    const std::string& more = "") {
  std::string curves;
  for (const char* name : {"static_ccw", "coulomb_cw", "coulomb_ccw", "viscous_cw", "viscous_ccw"}) {
    curves += std::string("\"") + name + "\": {\"mean\": 0.01, \"harmonics\": []}, ";
  }
  return R"({"schema": "breakaway.rig/1", "name": "r", "loop_rate_Hz": 5000, "motor": {"torque_constant_Nm_per_A": 0.07,
    "back_emf_constant_V_s_per_rad": 0.07, "resistance_ohm": 1.2, "inductance_H": 0.0011, "inertia_kg_m2": )" +
         inertia + R"(}, "friction": {"static_cw": {"mean": 0.02, "harmonics": )" + staticHarmonics + "}, " + curves +
         R"("stribeck_velocity_rad_per_s": 1.5}, "encoder": {"counts_per_rev": 4096}, "bridge": {"supply_V": 24})" +
         more + "}";
}

std::string faultOf(const std::string& text) {
  const auto rig = readRigText(text, "r.rig.json");
  return rig.ok() ? std::string() : rig.error().message();
}

}  // namespace

void TestRig::randomRigs_areRead() {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const auto rig = readRigText(test::RandomRig(seed).text(), "random");
    QVERIFY2(rig.ok(), rig.ok() ? "" : (std::to_string(seed) + ": " + rig.error().message()).c_str());
  }
}

void TestRig::curve_isMeanTimesHarmonics() {
  const auto rig = readRigText(
      rigText("6e-5", "[[2, 0.25, 0.5]]", R"(, "position_torque": {"harmonics_Nm": [[12, 0.001, 1.0]]})"), "r");
  QVERIFY(rig.ok());
  const AngleTorques torques = torquesAt(physicsOf(*rig), 0.7);
  QCOMPARE(torques.static_Nm[0], 0.02 * (1.0 + 0.25 * std::cos(2.0 * 0.7 - 0.5)));
  QCOMPARE(torques.static_Nm[1], 0.01);
  QCOMPARE(torques.position_Nm, 0.001 * std::cos(12.0 * 0.7 - 1.0));
}

void TestRig::unknownField_getsASuggestion() {
  QCOMPARE(faultOf(rigText("6e-5", "[]", R"(, "efects": [])")),
           std::string("r.rig.json, field efects: is an unknown field, did you mean effects?"));
}

void TestRig::negativeInertia_isNamed() {
  QCOMPARE(faultOf(rigText("-1")),
           std::string("r.rig.json, field motor.inertia_kg_m2: expected a positive number, found the number -1"));
}

void TestRig::fractionalOrder_isRefused() {
  QVERIFY(faultOf(rigText("6e-5", "[[1.5, 0.1, 0]]")).find("whole number") != std::string::npos);
}

void TestRig::frictionBelowZero_isRefused() {
  QVERIFY(faultOf(rigText("6e-5", "[[1, 1.2, 0]]")).find("static_cw: falls below zero") != std::string::npos);
}

void TestRig::unknownEffect_namesTheKnownOnes() {
  const std::string fault = faultOf(rigText("6e-5", "[]", R"(, "effects": [{"effect": "gremlins"}])"));
  QVERIFY(fault.find("effects[0].effect: is \"gremlins\"") != std::string::npos);
  QVERIFY(fault.find("friction_warmup") != std::string::npos);
}

void TestRig::unknownEffectParameter_isRefused() {
  const std::string fault =
      faultOf(rigText("6e-5", "[]", R"(, "effects": [{"effect": "cogging", "parameters": {"ordr": 6}}])"));
  QVERIFY(fault.find("did you mean order?") != std::string::npos);
}

void TestRig::leftOutEffectParameter_takesItsDefault() {
  const auto rig =
      readRigText(rigText("6e-5", "[]", R"(, "effects": [{"effect": "constant_load", "parameters": {}}])"), "r");
  QVERIFY(rig.ok());
  QCOMPARE(torquesAt(physicsOf(*rig), 0.0).position_Nm, 0.002);
}

void TestRig::faults_areRead() {
  const auto rig =
      readRigText(rigText("6e-5", "[]", R"(, "faults": [{"fault": "encoder_jump", "start_s": 5, "counts": -7},
    {"fault": "blocked", "start_s": 2, "duration_s": 0.5}])"),
                  "r");
  QVERIFY(rig.ok());
  QCOMPARE(rig->faults.size(), size_t{2});
  QVERIFY(rig->faults[0].kind == FaultKind::encoderJump && rig->faults[0].counts == -7.0);
  QVERIFY(rig->faults[0].acts(1e9) && !rig->faults[0].acts(4.9));
  QVERIFY(rig->faults[1].acts(2.4) && !rig->faults[1].acts(2.6) && std::isnan(rig->faults[1].angle_rad));
}

void TestRig::unknownFault_namesTheKnownOnes() {
  const std::string fault = faultOf(rigText("6e-5", "[]", R"(, "faults": [{"fault": "fire"}])"));
  QVERIFY(fault.find("faults[0].fault: is \"fire\"") != std::string::npos);
  QVERIFY(fault.find("link_loss") != std::string::npos);
}

void TestRig::supplyAboveWhole_isRefused() {
  const std::string fault = faultOf(rigText("6e-5", "[]", R"(, "faults": [{"fault": "supply_drop", "part": 1.5}])"));
  QVERIFY2(fault.find("faults[0].part: is above 1") != std::string::npos, fault.c_str());
}

void TestRig::fallingDutyCurve_isRefused() {
  std::string text = rigText();
  const std::string supply = "\"supply_V\": 24";
  const auto with = [&](const std::string& curve) {
    std::string bent = text;
    return faultOf(bent.replace(bent.find(supply), supply.size(), supply + ", \"duty_curve\": " + curve));
  };
  QCOMPARE(with("[[0.1, 0.05], [0.2, 0.15]]"), std::string());
  QVERIFY(with("[[0.1, 0.05], [0.2, 0.04]]").find("bridge.duty_curve") != std::string::npos);
  QVERIFY(with("[[0.2, 0.05], [0.1, 0.15]]").find("bridge.duty_curve") != std::string::npos);
}

void TestRig::tolerancesBeyondReason_areRefused() {
  const std::string counts = "\"counts_per_rev\": 4096";
  const auto with = [&](const std::string& field) {
    std::string text = rigText();
    return faultOf(text.replace(text.find(counts), counts.size(), counts + ", " + field));
  };
  QCOMPARE(with("\"eccentricity_rad\": 0.001"), std::string());
  QVERIFY(with("\"eccentricity_rad\": 0.2").find("encoder.eccentricity_rad") != std::string::npos);
  QVERIFY(with("\"quadrature_error_counts\": 0.6").find("encoder.quadrature_error_counts") != std::string::npos);
  QVERIFY(with("\"index_width_counts\": 9").find("encoder.index_width_counts") != std::string::npos);
}

void TestRig::honestRandomRigs_areRead() {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const auto rig = readRigText(test::RandomRig(seed).text(true), "random");
    QVERIFY2(rig.ok(), rig.ok() ? "" : (std::to_string(seed) + ": " + rig.error().message()).c_str());
    QVERIFY(rig->bridge.dutyCurve.known());
  }
}

QTEST_APPLESS_MAIN(TestRig)
#include "tst_rig.moc"
