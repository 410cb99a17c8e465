#include <QTest>

#include "motor/bench.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestBench : public QObject {
  Q_OBJECT
 private slots:
  void fullBench_isReadBack();
  void motorSerial_isKeptByWriting();
  void motorSerialAsANumber_isRefused();
  void negativeInertia_isNamed();
  void unknownField_getsASuggestion();
  void unitOfTheOtherAxis_getsASuggestion();
};

static const char* const head =
    R"({"schema": "breakaway.bench/1", "axis": "rotary", "drive": {"input": "current_A"}, "motor": )";

void TestBench::fullBench_isReadBack() {
  const auto bench = readBenchText(std::string(head) + R"({"inertia_kg_m2": 9.1e-5}, "trusted": ["inertia_kg_m2"],
    "encoder": {"counts_per_rev": 4096}, "load": {"pendulum": {"mass_kg": 0.49, "length_m": 0.1}},
    "controller": {"mode": "velocity", "kp_A_s_per_rad": 0.02, "current_limit_A": 4}})",
                                   "b");
  QVERIFY2(bench.ok(), bench.ok() ? "" : bench.error().message().c_str());
  QCOMPARE(*bench->motor.inertia, 9.1e-5);
  QCOMPARE(bench->pendulum->mass_kg, 0.49);
  QCOMPARE(bench->controller.kp, 0.02);
  QCOMPARE(bench->inputChannel(), std::string("current_A"));
  QVERIFY(!bench->motor.coulomb.has_value());
}

void TestBench::motorSerial_isKeptByWriting() {
  const TemporaryFolder folder;
  const auto bench = readBenchText(std::string(head) + R"({}, "motor_serial": "0117 / B"})", "b");
  VERIFY_OK(bench);
  QCOMPARE(bench->motorSerial, std::string("0117 / B"));
  VERIFY_OK(writeBench(*bench, folder.path("b.json")));
  QCOMPARE(readBench(folder.path("b.json"))->motorSerial, std::string("0117 / B"));
  const auto unknown = readBenchText(std::string(head) + "{}}", "b");
  VERIFY_OK(unknown);
  VERIFY_OK(writeBench(*unknown, folder.path("u.json")));
  const auto text = readFile(folder.path("u.json"));
  VERIFY_OK(text);
  QVERIFY2(text->find("motor_serial") == std::string::npos, "an unknown motor has no field");
}

void TestBench::motorSerialAsANumber_isRefused() {
  VERIFY_ERROR(readBenchText(std::string(head) + R"({}, "motor_serial": 117})", "b.bench.json"),
               std::string("b.bench.json, field motor_serial: expected a text, found the number 117"));
}

void TestBench::negativeInertia_isNamed() {
  const auto bench = readBenchText(std::string(head) + R"({"inertia_kg_m2": -1}})", "b.bench.json");
  QVERIFY(!bench.ok());
  QCOMPARE(bench.error().message(),
           std::string("b.bench.json, field motor.inertia_kg_m2: expected a positive number, found the number -1"));
}

void TestBench::unknownField_getsASuggestion() {
  const auto bench = readBenchText(std::string(head) + R"({"inertia_kgm2": 1}})", "b");
  QVERIFY(!bench.ok());
  QCOMPARE(bench.error().message(),
           std::string("b, field motor.inertia_kgm2: is an unknown field, did you mean inertia_kg_m2?"));
}

void TestBench::unitOfTheOtherAxis_getsASuggestion() {
  const auto bench = readBenchText(std::string(head) + R"({"viscous_N_s_per_m": 1}})", "b");
  QVERIFY(!bench.ok());
  QVERIFY(bench.error().message().find("did you mean viscous_Nm_s_per_rad?") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestBench)
#include "tst_bench.moc"
