#include <QTest>
#include <random>

#include "firmware_link/vesc/vesc_angle.h"
#include "firmware_link/vesc/vesc_frame.h"
#include "firmware_link/vesc/vesc_messages.h"

using namespace breakaway;
using Bytes = std::vector<std::uint8_t>;

namespace {

Bytes hex(const char* text) {
  const QByteArray bytes = QByteArray::fromHex(text);
  return {bytes.begin(), bytes.end()};
}

/// All payloads in `bytes`, given in pieces of `piece` bytes.
std::vector<Bytes> decoded(const Bytes& bytes, size_t piece) {
  VescDecoder decoder;
  std::vector<Bytes> payloads;
  for (size_t at = 0; at < bytes.size(); at += piece) {
    decoder.add(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at)));
    while (auto one = decoder.next()) payloads.push_back(*one);
  }
  return payloads;
}

}  // namespace

class TestVescMessages : public QObject {
  Q_OBJECT
 private slots:
  void checksum_isXmodem();
  void frames_areThosePublished();
  void longFrame_hasTwoBytesOfLength();
  void frames_areFound_howeverTheyArrive();
  void damagedFrame_isDropped_andTheNextOneFound();
  void anyBytes_surviveWithoutGrowing();
  void longBursts_areDecodedOnce();
  void abandonedFrame_letsTheNextOneThrough();
  void version_isRead();
  void values_areReadByTheirMask();
  void values_ofOldFirmware_mayEndEarly();
  void shortOrForeignPayload_isNoAnswer();
  void commands_areHeldWithinTheWire();
  void faults_haveWords();
  void angle_unwraps_evenWhenReadingsAreFarApart();
};

void TestVescMessages::checksum_isXmodem() {
  const std::string digits = "123456789";
  QCOMPARE(crc16Xmodem(Bytes(digits.begin(), digits.end())), std::uint16_t(0x31c3));  // the published check value
}

void TestVescMessages::frames_areThosePublished() {
  QCOMPARE(vescFrame(vescRequest(VescMessage::firmwareVersion)), hex("020100000003"));
  QCOMPARE(vescFrame(vescRequest(VescMessage::values)), hex("020104408403"));
  QCOMPARE(vescFrame(vescSetCurrent(1.5)), hex("0205060000 05dc388103"));
  QCOMPARE(vescSetCurrent(-1.5), hex("06fffffa24"));
  QCOMPARE(vescSetDuty(-0.25), hex("05ffff9e58"));
  QCOMPARE(vescSetSpeed(4200.0), hex("0800001068"));
  QCOMPARE(vescSetPosition(359.5), hex("09156d88e0"));
  QCOMPARE(vescSelectValues(0x1a1e3), hex("320001a1e3"));
}

void TestVescMessages::longFrame_hasTwoBytesOfLength() {
  const Bytes payload(300, 0x55), frame = vescFrame(payload);
  QCOMPARE(frame.size(), size_t(306));
  QCOMPARE(Bytes(frame.begin(), frame.begin() + 3), hex("03012c"));
  QCOMPARE(decoded(frame, 7), std::vector<Bytes>{payload});
  const Bytes most(255, 1);
  QCOMPARE(vescFrame(most)[0], std::uint8_t(2));
  QCOMPARE(decoded(vescFrame(most), 1000), std::vector<Bytes>{most});
}

void TestVescMessages::frames_areFound_howeverTheyArrive() {
  std::vector<Bytes> sent{{0}, {4}, hex("06000005dc"), Bytes(400, 3), Bytes(64, 2)};
  Bytes wire;
  for (const Bytes& one : sent) {
    const Bytes frame = vescFrame(one);
    wire.insert(wire.end(), frame.begin(), frame.end());
  }
  for (const size_t piece : {1u, 2u, 3u, 5u, 64u, 1000u}) QCOMPARE(decoded(wire, piece), sent);
}

void TestVescMessages::damagedFrame_isDropped_andTheNextOneFound() {
  const Bytes good = vescFrame(hex("06000005dc"));
  for (size_t at = 0; at < good.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes wire = good;
      wire[at] = static_cast<std::uint8_t>(wire[at] ^ (1 << bit));
      for (int k = 0; k < 120; ++k) wire.insert(wire.end(), good.begin(), good.end());
      const auto found = decoded(wire, 11);
      QVERIFY2(found.size() >= 118 && found.size() <= 120, qPrintable(QString("byte %1 bit %2").arg(at).arg(bit)));
      for (const Bytes& one : found) QCOMPARE(one, hex("06000005dc"));
    }
  }
}

void TestVescMessages::anyBytes_surviveWithoutGrowing() {
  std::mt19937 random(20240607);
  VescDecoder decoder;
  size_t found = 0;
  for (int round = 0; round < 20000; ++round) {
    Bytes bytes(1 + random() % 40);
    for (auto& one : bytes) one = static_cast<std::uint8_t>(random() % 3 == 0 ? random() % 4 : random());
    decoder.add(bytes);
    while (const auto payload = decoder.next()) {
      ++found;
      readVescValues(*payload);
      readVescVersion(*payload);
    }
    QVERIFY(decoder.waiting() <= mostVescPayload + 6);
  }
  QVERIFY2(found < 200,
           qPrintable(QString("%1 frames in noise").arg(found)));  // one in 2¹⁶ × 2⁸ by chance, short ones more often
}

void TestVescMessages::longBursts_areDecodedOnce() {
  const Bytes good = vescFrame(hex("06000005dc"));
  Bytes wire;
  for (int k = 0; k < 20000; ++k) wire.insert(wire.end(), good.begin(), good.end());
  QCOMPARE(decoded(wire, wire.size()).size(), size_t(20000));
  Bytes starts(300'000, 3);  // each of them could begin a frame
  starts.insert(starts.end(), good.begin(), good.end());
  starts.insert(starts.end(), 600, 0);
  QCOMPARE(decoded(starts, starts.size()), std::vector<Bytes>{hex("06000005dc")});
}

void TestVescMessages::abandonedFrame_letsTheNextOneThrough() {
  VescDecoder decoder;
  decoder.add(hex("02ff0102"));  // promises 255 bytes
  QVERIFY(!decoder.next());
  decoder.add(vescFrame(hex("04")));
  QVERIFY(!decoder.next());
  QCOMPARE(decoder.rescue(), std::optional(hex("04")));
  QCOMPARE(decoder.waiting(), size_t(0));
  QVERIFY(!decoder.rescue());
  QCOMPARE(decoder.dropped(), size_t(4));
}

void TestVescMessages::version_isRead() {
  const auto version = readVescVersion(hex("000605 36305f4d4b3500 0102030405060708090a0b0c 0000"));
  QVERIFY(version.has_value());
  QCOMPARE(version->major, 6);
  QCOMPARE(version->minor, 5);
  QCOMPARE(version->hardware, std::string("60_MK5"));
  QCOMPARE(version->identity[0], std::uint8_t(1));
  QCOMPARE(version->identity[11], std::uint8_t(12));
  QCOMPARE(readVescVersion(hex("000217"))->minor, 23);  // old firmware says no more
  QVERIFY(!readVescVersion(hex("0006")));
}

void TestVescMessages::values_areReadByTheirMask() {
  // Mask: bridge temperature, Iq, duty, speed, supply, tachometer, fault, position.
  const auto values = readVescValues(hex("320001a1e1 00fb ffffff6a ff38 fffff448 00f0 fffffff9 05 0aba9500"));
  QVERIFY(values.has_value());
  QCOMPARE(values->bridge_degC, 25.1);
  QCOMPARE(values->iq_A, -1.5);
  QCOMPARE(values->duty, -0.2);
  QCOMPARE(values->electricalSpeed_rpm, -3000.0);
  QCOMPARE(values->supply_V, 24.0);
  QCOMPARE(values->tachometer, -7);
  QCOMPARE(values->fault, 5);
  QCOMPARE(values->position_deg, 180.0);
  QVERIFY(values->has(vescField::iq | vescField::position) && !values->has(vescField::motorTemperature));
}

void TestVescMessages::values_ofOldFirmware_mayEndEarly() {
  Bytes payload = hex("04 00fb 012e 00000096 00000000 00000000 00000096 00c8 00000bb8 00f0");
  payload.insert(payload.end(), 16, 0);  // ampere and watt hours
  const Bytes steps = hex("00000007 00000007 01");
  payload.insert(payload.end(), steps.begin(), steps.end());
  const auto values = readVescValues(payload);
  QVERIFY(values.has_value());
  QCOMPARE(values->tachometer, 7);
  QCOMPARE(values->fault, 1);
  QCOMPARE(values->motor_degC, 30.2);
  QVERIFY(values->has(vescField::fault) && !values->has(vescField::position));
}

void TestVescMessages::shortOrForeignPayload_isNoAnswer() {
  QVERIFY(!readVescValues({}));
  QVERIFY(!readVescValues(hex("00")));
  QVERIFY(!readVescValues(hex("320001")));
  QVERIFY(!readVescValues(hex("3200000003 00fb01")));  // a byte is missing
  QVERIFY(!readVescValues(hex("32ffffffff 00fb")));    // fields that nobody knows
  QVERIFY(!readVescVersion(hex("04060500")));
}

void TestVescMessages::commands_areHeldWithinTheWire() {
  QCOMPARE(vescSetCurrent(1e9), hex("067fffffff"));
  QCOMPARE(vescSetCurrent(-1e9), hex("0680000001"));
  QCOMPARE(vescSetCurrent(std::nan("")), hex("0600000000"));
  QCOMPARE(vescSetDuty(INFINITY), hex("0500000000"));
}

void TestVescMessages::faults_haveWords() {
  QVERIFY(vescFaultWords(0).empty());
  for (int fault = 1; fault < 34; ++fault) {
    const QString words = QString::fromStdString(vescFaultWords(fault));
    QVERIFY2(words.size() > 10 && !words.contains("not known here"), qPrintable(words));
  }
  QVERIFY(QString::fromStdString(vescFaultWords(2)).contains("too low"));
  QVERIFY(QString::fromStdString(vescFaultWords(29)).contains("low-voltage output"));
  QVERIFY(QString::fromStdString(vescFaultWords(30)).contains("slips"));
  QVERIFY(QString::fromStdString(vescFaultWords(31)).contains("forwards"));
  QVERIFY(QString::fromStdString(vescFaultWords(32)).contains("backwards"));
  QVERIFY(QString::fromStdString(vescFaultWords(33)).contains("speed limit"));
  QVERIFY(QString::fromStdString(vescFaultWords(34)).contains("fault 34"));
  QVERIFY(QString::fromStdString(vescFaultWords(77)).contains("fault 77"));
}

void TestVescMessages::angle_unwraps_evenWhenReadingsAreFarApart() {
  for (const double speed : {0.3, -0.3, 40.0, -900.0}) {
    VescAngle angle;
    const double turn = 2.0 * M_PI;
    double start = 0.0;
    for (int k = 0; k < 500; ++k) {
      const double time_s = 0.005 * k, truth = 1.0 + speed * time_s;
      const double read = angle.step(truth - turn * std::floor(truth / turn), speed * 1.02, time_s);
      if (k == 0) start = read - truth;
      QVERIFY(std::abs(read - truth - start) < 1e-9);
    }
  }
  QCOMPARE(commutationAngle_rad(42, 7.0), 2.0 * M_PI);
}

QTEST_APPLESS_MAIN(TestVescMessages)
#include "tst_vesc_messages.moc"
