#include <QTest>
#include <bit>
#include <functional>
#include <limits>

#include "firmware_link/board/parameters.h"
#include "firmware_link/board_drive.h"
#include "firmware_link/board_link.h"
#include "support/firmware_stream.h"

using namespace breakaway;
using namespace breakaway::test;

class TestDescription : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void numberThatNoBoardHas_isRefusedInOneLine_data();
  void numberThatNoBoardHas_isRefusedInOneLine();
  void plainBoard_isTaken();
};

namespace {

using Alter = std::function<void(std::uint8_t type, std::vector<std::uint8_t>& body)>;

/// Changes the body of what a board answers, behind the code.
class AlteredStream final : public ByteStream {
 public:
  AlteredStream(std::unique_ptr<ByteStream> inner, Alter alter) : inner_(std::move(inner)), alter_(std::move(alter)) {}
  Result<void> write(std::span<const std::uint8_t> bytes) override { return inner_->write(bytes); }
  Result<void> read(std::vector<std::uint8_t>& bytes, double wait_s) override {
    std::vector<std::uint8_t> came;
    if (auto read = inner_->read(came, wait_s); !read) return read;
    for (const std::uint8_t byte : came) {
      if (!decoder_.take(byte)) continue;
      const wire::Frame frame = decoder_.frame();
      std::vector<std::uint8_t> body(frame.body.begin(), frame.body.end());
      if (frame.type < wire::unasked && body.size() > 1 && body[0] == 0) alter_(frame.type & 0x7fu, body);
      std::array<std::uint8_t, wire::mostFrame> room{};
      const std::size_t size = wire::FrameEncoder::encode({frame.type, frame.sequence, body}, room);
      bytes.insert(bytes.end(), room.begin(), room.begin() + static_cast<std::ptrdiff_t>(size));
    }
    return {};
  }

 private:
  std::unique_ptr<ByteStream> inner_;
  Alter alter_;
  wire::FrameDecoder decoder_;
};

template <typename Message>
Alter changing(wire::Type of, const std::function<void(Message&)>& change) {
  return [of, change](std::uint8_t type, std::vector<std::uint8_t>& body) {
    Message message;
    if (type != static_cast<std::uint8_t>(of) || !wire::readMessage(std::span(body).subspan(1), message)) return;
    change(message);
    const auto altered = bodyOf(message);
    body.assign(1, 0);
    body.insert(body.end(), altered.begin(), altered.end());
  };
}

Alter telling(std::uint16_t id, float value) {
  return changing<wire::ParameterList>(wire::Type::readParameters, [=](wire::ParameterList& list) {
    for (std::size_t k = 0; k < list.count; ++k) {
      if (list.value[k].id == id) list.value[k].word = std::bit_cast<std::uint32_t>(value);
    }
  });
}

Alter describing(std::size_t entry, float wire::DictionaryEntry::*field, float value) {
  return changing<wire::DictionaryPage>(wire::Type::dictionary, [=](wire::DictionaryPage& page) {
    if (entry >= page.first && entry < page.first + std::size_t(page.count))
      page.entry[entry - page.first].*field = value;
  });
}

Result<std::unique_ptr<Drive>> opened(Alter alter) {
  const auto far = std::make_shared<FirmwareStream::Far>(presetRig("servo"));
  return openBoardDrive(std::make_unique<AlteredStream>(std::make_unique<FirmwareStream>(far), std::move(alter)),
                        {.place = "board tcp:x:1"});
}

}  // namespace

Q_DECLARE_METATYPE(Alter)

void TestDescription::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestDescription::numberThatNoBoardHas_isRefusedInOneLine_data() {
  QTest::addColumn<Alter>("alter");
  QTest::addColumn<QString>("field");
  using wire::Hello, wire::DictionaryEntry;
  const float absurd[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f,
                          -1e30f};
  for (const float value : absurd) {
    const auto row = [value](const Alter& alter, const QString& field) {
      QTest::addRow("%s = %g", qPrintable(field), static_cast<double>(value)) << alter << field;
    };
    row(changing<Hello>(wire::Type::hello, [value](Hello& hello) { hello.loopRate_Hz = value; }), "loop_rate_Hz");
    row(changing<Hello>(wire::Type::hello, [value](Hello& hello) { hello.supply_V = value; }), "supply_V");
    for (std::size_t k = 0; k < board::parameterCount; ++k) {
      const board::ParameterForm& form = board::parameterForms[k];
      if (form.format == wire::Format::float32) row(telling(static_cast<std::uint16_t>(k), value), form.name);
      row(describing(k, &DictionaryEntry::least, value), QString("the least ") + form.name);
      row(describing(k, &DictionaryEntry::most, value), QString("the most ") + form.name);
    }
    for (std::size_t k = 0; k < wire::channelCount; ++k) {
      if (wire::channelForms[k].format != wire::Format::int16) continue;
      row(describing(board::parameterCount + k, &DictionaryEntry::scale, value),
          QString("the scale of ") + wire::channelForms[k].name);
    }
  }
  for (const std::uint32_t counts : {0u, 4000000000u})
    QTest::addRow("%u counts", counts) << changing<Hello>(wire::Type::hello, [counts](Hello& hello) {
      hello.countsPerRev = counts;
    }) << "counts_per_rev";
  for (const float none : {0.0f, -5.0f})
    QTest::addRow("supply_V = %g", static_cast<double>(none))
        << changing<Hello>(wire::Type::hello, [none](Hello& hello) { hello.supply_V = none; }) << "supply_V";
  QTest::newRow("no entries") << changing<Hello>(wire::Type::hello, [](Hello& hello) { hello.entries = 0; })
                              << "dictionary_entries";
}

void TestDescription::numberThatNoBoardHas_isRefusedInOneLine() {
  QFETCH(Alter, alter);
  QFETCH(QString, field);
  const auto drive = opened(alter);
  QVERIFY(!drive.ok());
  const QString words = QString::fromStdString(drive.error().message());
  QVERIFY2(words.startsWith("board tcp:x:1: says of itself " + field + " = ") && words.contains(", expected "),
           qPrintable(words));
  QVERIFY(!words.contains('\n'));
}

void TestDescription::plainBoard_isTaken() {
  const auto drive = opened([](std::uint8_t, std::vector<std::uint8_t>&) {});
  QVERIFY2(drive.ok(), drive.ok() ? "" : drive.error().message().c_str());
}

QTEST_GUILESS_MAIN(TestDescription)
#include "tst_description.moc"
