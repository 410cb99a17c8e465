#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <cmath>
#include <random>
#include <vector>

#include "firmware_link/wire/leg_messages.h"
#include "firmware_link/wire/messages.h"

using namespace breakaway::wire;

class TestWire : public QObject {
  Q_OBJECT
 private slots:
  void checksum_isThePublishedOne();
  void frame_hasTheseBytes_data();
  void frame_hasTheseBytes();
  void commandsBytes_areTheManuals();
  void everyLengthAndContent_comesBackWithinOneFrame();
  void tooLongBody_isNotWritten();
  void anyBytes_giveFramesOrCountedErrors();
  void damagedFrame_costsItselfAlone();
  void bootTextBeforeAFrame_costsThatFrameAtMost();
  void frameTooLongTooShortOrOfAnotherVersion_isCounted();
  void everySingleWrongBit_isFound();
  void everyMessage_comesBackAndFits();
  void listLongerThanItMayBe_isRefused();
  void longerBodyOfALaterVersion_isRead();
  void sixteenBits_roundHoldAndSayWhatIsMissing();
  void sample_comesBackAsFineAsItsScale();
};

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes encoded(std::uint8_t type, std::uint16_t sequence, const Bytes& body) {
  Bytes out(mostFrame);
  out.resize(FrameEncoder::encode({type, sequence, body}, out));
  return out;
}

struct Taken {
  std::uint8_t type;
  std::uint16_t sequence;
  Bytes body;
};

std::vector<Taken> taken(FrameDecoder& decoder, const Bytes& bytes) {
  std::vector<Taken> frames;
  for (const std::uint8_t byte : bytes) {
    if (!decoder.take(byte)) continue;
    const Frame frame = decoder.frame();
    frames.push_back({frame.type, frame.sequence, {frame.body.begin(), frame.body.end()}});
  }
  return frames;
}

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Bytes text(const char* words) {
  const std::string all = words;
  return {all.begin(), all.end()};
}

}  // namespace

void TestWire::checksum_isThePublishedOne() {
  QCOMPARE(crc32c(text("123456789")), 0xE3069283u);
  QCOMPARE(crc32c(Bytes(32, 0x00)), 0x8A9136AAu);  // RFC 3720, B.4
  QCOMPARE(crc32c(Bytes(32, 0xFF)), 0x62A8AB43u);
  Bytes rising(32);
  for (std::size_t k = 0; k < rising.size(); ++k) rising[k] = static_cast<std::uint8_t>(k);
  QCOMPARE(crc32c(rising), 0x46DD794Eu);
}

/// The manual's own test vectors: somebody writes firmware by them.
void TestWire::frame_hasTheseBytes_data() {
  QTest::addColumn<int>("type");
  QTest::addColumn<int>("sequence");
  QTest::addColumn<QByteArray>("body");
  QTest::addColumn<QByteArray>("wire");
  QFile page(qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/resources/help/wire.md");
  QVERIFY(page.open(QIODevice::ReadOnly));
  static const QRegularExpression vector(
      R"(^\| ([^|]+) \| `([0-9a-f]{2})` \| (\d+) \| `([0-9a-f ]*)` \| `([0-9a-f ]+)` \|$)",
      QRegularExpression::MultilineOption);
  int rows = 0;
  for (auto it = vector.globalMatch(QString::fromUtf8(page.readAll())); it.hasNext(); ++rows) {
    const auto found = it.next();
    QTest::newRow(qPrintable(found.captured(1)))
        << found.captured(2).toInt(nullptr, 16) << found.captured(3).toInt()
        << QByteArray::fromHex(found.captured(4).toLatin1()) << QByteArray::fromHex(found.captured(5).toLatin1());
  }
  QVERIFY2(rows >= 7, "the manual's table of frames was not found");
}

void TestWire::frame_hasTheseBytes() {
  QFETCH(int, type);
  QFETCH(int, sequence);
  QFETCH(QByteArray, body);
  QFETCH(QByteArray, wire);
  const Bytes made =
      encoded(static_cast<std::uint8_t>(type), static_cast<std::uint16_t>(sequence), Bytes(body.begin(), body.end()));
  QCOMPARE(QByteArray(reinterpret_cast<const char*>(made.data()), static_cast<int>(made.size())).toHex(), wire.toHex());
}

void TestWire::commandsBytes_areTheManuals() {
  MotorCommand command;
  command.mode = MotorCommand::Mode::position;
  command.latch = 5;
  command.targetCounts = 14400;
  command.current_limit_A = 1.5f;
  Bytes room(mostBody);
  Writer out(room);
  out(command);
  const Bytes body(out.written().begin(), out.written().end());
  QCOMPARE(QByteArray(reinterpret_cast<const char*>(body.data()), static_cast<int>(body.size())),
           QByteArray::fromHex("0400050000000000403800000000c03f"));
}

void TestWire::everyLengthAndContent_comesBackWithinOneFrame() {
  std::mt19937 random(11);
  FrameDecoder decoder;
  for (const int kind : {0, 1, 2, 3}) {
    for (std::size_t length = 0; length <= mostBody; ++length) {
      Bytes body(length);
      for (auto& byte : body) {
        byte = static_cast<std::uint8_t>(kind == 0 ? 0 : kind == 1 ? 0xFF : kind == 2 ? random() % 3 : random());
      }
      const Bytes wire = encoded(static_cast<std::uint8_t>(random()), static_cast<std::uint16_t>(length), body);
      QVERIFY(wire.size() <= mostFrame && wire.size() > body.size() + headerSize + checksumSize);
      QCOMPARE(std::count(wire.begin(), wire.end(), 0), std::ptrdiff_t(1));
      QCOMPARE(wire.back(), std::uint8_t(0));
      const auto frames = taken(decoder, wire);
      QCOMPARE(frames.size(), std::size_t(1));
      QCOMPARE(frames[0].body, body);
      QCOMPARE(frames[0].sequence, static_cast<std::uint16_t>(length));
    }
  }
  QCOMPARE(decoder.counts().errors(), 0u);
}

void TestWire::tooLongBody_isNotWritten() {
  QVERIFY(encoded(1, 1, Bytes(mostBody + 1)).empty());
  Bytes small(20);
  QCOMPARE(FrameEncoder::encode({1, 1, Bytes(12)}, small), std::size_t(0));
}

void TestWire::anyBytes_giveFramesOrCountedErrors() {
  std::mt19937 random(12);
  FrameDecoder decoder;
  std::uint32_t ended = 0;
  bool any = false;
  for (int k = 0; k < 2'000'000; ++k) {
    const auto byte = static_cast<std::uint8_t>(random() % 5 == 0 ? random() % 3 : random());
    if (byte == 0 && any) ++ended;
    any = byte != 0;
    decoder.take(byte);
  }
  QVERIFY(ended > 1000);
  QCOMPARE(decoder.counts().good + decoder.counts().errors(), ended);
  QCOMPARE(decoder.counts().good, 0u);
}

void TestWire::damagedFrame_costsItselfAlone() {
  std::mt19937 random(13);
  const Bytes first = encoded(1, 1, Bytes(40, 7)), last = encoded(3, 3, Bytes(60, 9));
  for (int trial = 0; trial < 2000; ++trial) {
    Bytes middle = encoded(2, 2, Bytes(random() % 100, static_cast<std::uint8_t>(random())));
    const std::size_t at = random() % (middle.size() - 1);
    switch (trial % 3) {
      case 0:
        middle[at] = static_cast<std::uint8_t>(middle[at] ^ (1u << random() % 8));
        break;
      case 1:
        middle.erase(middle.begin() + static_cast<std::ptrdiff_t>(at));
        break;
      default:
        middle.insert(middle.begin() + static_cast<std::ptrdiff_t>(at), static_cast<std::uint8_t>(random()));
    }
    FrameDecoder decoder;
    const auto frames = taken(decoder, first + middle + last);
    QVERIFY2(frames.size() == 2, qPrintable(QString("trial %1").arg(trial)));
    QVERIFY(frames[0].type == 1 && frames[1].type == 3);
    QVERIFY(decoder.counts().errors() >= 1);
  }
}

void TestWire::bootTextBeforeAFrame_costsThatFrameAtMost() {
  FrameDecoder decoder;
  const Bytes frame = encoded(0x81, 5, Bytes(30, 1));
  const auto frames = taken(decoder, text("LPC1768 boot v2\r\nready\r\n") + frame + frame);
  QCOMPARE(frames.size(), std::size_t(1));
  QCOMPARE(decoder.counts().errors(), 1u);
}

void TestWire::frameTooLongTooShortOrOfAnotherVersion_isCounted() {
  FrameDecoder decoder;
  taken(decoder, Bytes(2000, 1) + Bytes{0});
  QCOMPARE(decoder.counts().tooLong, 1u);
  taken(decoder, Bytes{3, 1, 1, 0});
  QCOMPARE(decoder.counts().tooShort, 1u);
  taken(decoder, Bytes{0, 0, 0});
  QCOMPARE(decoder.counts().errors(), 2u);
  Bytes other{version + 1, 1, 0x11, 0x22};
  const std::uint32_t sum = crc32c(other);
  for (int k = 0; k < 4; ++k) other.push_back(static_cast<std::uint8_t>(sum >> (8 * k)));
  QVERIFY(std::count(other.begin(), other.end(), 0) == 0);
  taken(decoder, Bytes{9} + other + Bytes{0});
  QCOMPARE(decoder.counts().otherVersion, 1u);
}

void TestWire::everySingleWrongBit_isFound() {
  const Bytes wire = encoded(0x05, 77, text("a command whose value must not be another one"));
  for (std::size_t at = 0; at < wire.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes wrong = wire;
      wrong[at] = static_cast<std::uint8_t>(wrong[at] ^ (1u << bit));
      FrameDecoder decoder;
      QVERIFY(taken(decoder, wrong + Bytes{0}).empty());
    }
  }
}

template <typename Message>
static void comesBack(std::mt19937& random, unsigned values = 40) {
  // Whatever the bytes are, what was read from them writes the same ones again.
  Bytes bytes(mostBody), again(mostBody);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random() % values);
  Message message{};
  QVERIFY(readMessage(bytes, message));
  Writer out(again);
  out(message);
  QVERIFY(out.ok());
  const std::size_t size = out.written().size();
  QVERIFY(std::equal(again.begin(), again.begin() + static_cast<std::ptrdiff_t>(size), bytes.begin()));
  for (std::size_t shorter = 0; shorter < size; ++shorter) {
    Message part{};
    QVERIFY(!readMessage(std::span(bytes).first(shorter), part));
  }
}

void TestWire::everyMessage_comesBackAndFits() {
  std::mt19937 random(14);
  for (int k = 0; k < 20; ++k) {
    comesBack<Hello>(random);
    comesBack<DictionaryAsked>(random);
    comesBack<DictionaryEntry>(random);
    comesBack<ParameterList>(random);
    comesBack<MotorCommand>(random);
    comesBack<Heartbeat>(random);
    comesBack<Alive>(random);
    comesBack<Fault>(random);
    comesBack<FrictionChunk>(random);
    comesBack<FrictionUse>(random);
    comesBack<StaticFrictionUse>(random);
    comesBack<BridgeCurve>(random, BridgeCurve::mostPoints + 1);
    comesBack<Capture>(random);
    comesBack<CaptureAsked>(random);
    comesBack<CapturePage>(random);
    comesBack<StartHoming>(random);
    comesBack<StartBreakaway>(random);
    comesBack<StartSpeed>(random);
    comesBack<BatchHeader>(random);
  }
  Bytes room(mostBody);
  Writer fullest(room);
  DictionaryPage page;
  page.count = DictionaryPage::mostEntries;
  fullest(Code::ok), fullest(page);
  QVERIFY(fullest.ok());
  Writer list(room);
  ParameterList values;
  values.count = ParameterList::mostValues;
  list(Code::ok), list(values);
  QVERIFY(list.ok());
  QCOMPARE(mostSamples(usualChannels), std::size_t(16));
  QVERIFY(BatchHeader::size + mostSamples(allChannels) * sampleSize(allChannels) <= mostBody);
  Writer batch(room);
  batch(BatchHeader{});
  QCOMPARE(batch.written().size(), BatchHeader::size);
}

void TestWire::listLongerThanItMayBe_isRefused() {
  Bytes body(mostBody, 0);
  body[0] = ParameterList::mostValues + 1;
  ParameterList values;
  QVERIFY(!readMessage(body, values));
  QCOMPARE(values.count, std::uint8_t(0));
}

void TestWire::longerBodyOfALaterVersion_isRead() {
  Heartbeat heartbeat;
  QVERIFY(readMessage(Bytes{1, 0, 0, 0, 99, 98}, heartbeat));
  QCOMPARE(heartbeat.untilTick, 1u);
}

void TestWire::sixteenBits_roundHoldAndSayWhatIsMissing() {
  QCOMPARE(scaled16(1.4, 1.0), std::int16_t(1));
  QCOMPARE(scaled16(-1.6, 1.0), std::int16_t(-2));
  QCOMPARE(scaled16(1e9, 1.0), std::int16_t(32767));
  QCOMPARE(scaled16(-1e9, 1.0), std::int16_t(-32767));
  QCOMPARE(scaled16(std::nan(""), 1.0), missing16);
}

void TestWire::sample_comesBackAsFineAsItsScale() {
  const float scale = 4.5e-4f;
  float perUnit[channelCount];
  double scales[channelCount];
  std::fill(std::begin(perUnit), std::end(perUnit), 1.0f / scale);
  std::fill(std::begin(scales), std::end(scales), static_cast<double>(scale));
  Measured<float> sent;
  sent.angle_counts = -2'000'000'001;
  sent.flags = SampleFlag::enabled | SampleFlag::index;
  for (std::size_t k = 0; k < channelCount; ++k) sent.value[k] = 0.37f * static_cast<float>(k) - 1.9f;
  Bytes room(mostBody);
  Writer out(room);
  writeSample(sent, allChannels, perUnit, out);
  QCOMPARE(out.written().size(), sampleSize(allChannels));
  Reader in(out.written());
  Measured<double> came;
  readSample(in, allChannels, scales, came);
  QVERIFY(in.ok() && in.rest().empty());
  QCOMPARE(came.angle_counts, sent.angle_counts);
  QCOMPARE(came.flags, sent.flags);
  for (std::size_t k = 2; k < channelCount; ++k) {
    const bool whole = channelForms[k].format == Format::float32;
    const double error = std::abs(came.value[k] - static_cast<double>(sent.value[k]));
    QVERIFY(error <= (whole ? 0.0 : 0.51 * static_cast<double>(scale)));
  }
}

QTEST_APPLESS_MAIN(TestWire)
#include "tst_wire.moc"
