#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <QTest>
#include <chrono>
#include <thread>

#include "firmware_link/transport/byte_address.h"
#include "firmware_link/transport/open_byte_stream.h"
#include "firmware_link/transport/read_ahead.h"
#include "firmware_link/transport/serial_ports.h"
#include "support/pty.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;
using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

namespace {

/// Bytes whose place in the stream can be told from their value.
Bytes numbered(size_t count) {
  Bytes bytes(count);
  for (size_t k = 0; k < count; ++k) bytes[k] = static_cast<std::uint8_t>((k * 2654435761u) >> 13);
  return bytes;
}

/// Reads until `count` bytes have come, the stream ends or three seconds have passed.
Result<Bytes> readAll(ByteStream& stream, size_t count) {
  Bytes bytes;
  const auto end = std::chrono::steady_clock::now() + 3s;
  while (bytes.size() < count && std::chrono::steady_clock::now() < end) {
    if (auto read = stream.read(bytes, 0.05); !read) return read.error();
  }
  return bytes;
}

/// Reads until the stream says that it is gone, for three seconds.
std::pair<Bytes, std::string> readToEnd(ByteStream& stream) {
  Bytes bytes;
  const auto end = std::chrono::steady_clock::now() + 3s;
  while (std::chrono::steady_clock::now() < end) {
    if (auto read = stream.read(bytes, 0.05); !read) return {bytes, read.error().message()};
  }
  return {bytes, {}};
}

/// A server on this machine that takes one connection at a time.
class Listener {
 public:
  Listener() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (::bind(socket_, reinterpret_cast<sockaddr*>(&address), size) != 0) qFatal("no port to listen on");
    ::listen(socket_, 1);
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }
  ~Listener() { ::close(socket_); }
  std::string uri() const { return "tcp::" + std::to_string(port_); }
  std::uint16_t port() const { return port_; }
  int accept() const { return ::accept(socket_, nullptr, nullptr); }

 private:
  int socket_;
  std::uint16_t port_ = 0;
};

/// A source that counts what was fetched from it.
class Tap final : public ByteStream {
 public:
  explicit Tap(std::atomic<size_t>& fetched) : fetched_(fetched) {}
  Result<void> write(std::span<const std::uint8_t>) override { return {}; }
  Result<void> read(Bytes& bytes, double) override {
    bytes.insert(bytes.end(), 100, 7);
    fetched_ += 100;
    return {};
  }

 private:
  std::atomic<size_t>& fetched_;
};

}  // namespace

class TestTransport : public QObject {
  Q_OBJECT
 private slots:
  void address_isReadOrRefused_data();
  void address_isReadOrRefused();
  void serialPort_carriesBytesBothWays();
  void serialPort_runsRawAtTheBaudThatWasAskedFor();
  void serialPort_isOpenedOnce();
  void missingPort_saysWhatThereIs();
  void forbiddenPort_saysWhichGroup();
  void whatIsNoSerialPort_isRefused();
  void silentPort_isNoError_andTakesNothingForever();
  void port_thatDisappears_isNamedGone();
  void port_opensAgain_afterTheOtherEndCameBack();
  void slowReader_losesNothing();
  void readAhead_stopsFetching_whenNobodyTakes();
  void tcp_carriesBytesBothWays_onLoopbackByDefault();
  void tcp_handsOverAllThatCame_beforeItIsGone();
  void tcp_refused_saysSo();
  void tcp_halfOpen_isSilent();
  void ports_areReadFromTheKernel();
  void ports_haveOneNameEach();
};

void TestTransport::address_isReadOrRefused_data() {
  QTest::addColumn<QString>("uri");
  QTest::addColumn<QString>("words");
  QTest::addColumn<unsigned>("baud");
  QTest::addColumn<QString>("refused");
  const auto good = [](const char* uri, const char* words, unsigned baud = ByteAddress::usualBaud) {
    QTest::newRow(uri) << uri << words << baud << "";
  };
  const auto bad = [](const char* uri, const char* line) { QTest::newRow(uri) << uri << "" << 0u << line; };
  good("serial:ttyACM0", "serial port /dev/ttyACM0");
  good("serial:/dev/ttyUSB0@921600", "serial port /dev/ttyUSB0", 921600);
  good("serial:/dev/serial/by-id/usb-A_B-if00@57600", "serial port /dev/serial/by-id/usb-A_B-if00", 57600);
  good("tcp:bench3:2000", "bench3:2000");
  good("tcp::2000", "127.0.0.1:2000");
  good("tcp:2000", "127.0.0.1:2000");
  good("tcp:[::1]:2000", "[::1]:2000");
  bad("serial:", "board serial:: names no port, expected serial:PORT or serial:PORT@BAUD");
  bad("serial:@9600", "board serial:@9600: names no port, expected serial:PORT or serial:PORT@BAUD");
  const char* baud = "expected a whole number of bits per second such as 921600";
  for (const char* text : {"fast", "", "9600.5", "-9600", "0", "99999999999", "9600x", " 9600"}) {
    const QString uri = QString("serial:ttyUSB0@%1").arg(text);
    bad(qPrintable(uri), qPrintable(QString("board %1: has the baud rate \"%2\", %3").arg(uri, text, baud)));
  }
  bad("tcp:bench3", "board tcp:bench3: has the port \"bench3\", expected tcp:HOST:PORT with 1 to 65535");
  bad("tcp:bench3:", "board tcp:bench3:: has the port \"\", expected tcp:HOST:PORT with 1 to 65535");
  bad("tcp:bench3:70000", "board tcp:bench3:70000: has the port \"70000\", expected tcp:HOST:PORT with 1 to 65535");
  bad("usb:1", "board usb:1: is no known board, expected simulated, serial:PORT[@BAUD] or tcp:HOST:PORT");
}

void TestTransport::address_isReadOrRefused() {
  QFETCH(QString, uri);
  QFETCH(QString, words);
  QFETCH(unsigned, baud);
  QFETCH(QString, refused);
  const auto address = byteAddressOf(uri.toStdString());
  if (!refused.isEmpty()) {
    VERIFY_ERROR(address, refused.toStdString());
    VERIFY_ERROR(openByteStream(uri.toStdString()), refused.toStdString());
    return;
  }
  VERIFY_OK(address);
  QCOMPARE(address->words(), words.toStdString());
  QCOMPARE(address->baud, baud);
}

void TestTransport::serialPort_carriesBytesBothWays() {
  const Pty pty;
  auto stream = openByteStream("serial:" + pty.path());
  VERIFY_OK(stream);
  Bytes every(256);
  for (size_t k = 0; k < every.size(); ++k) every[k] = static_cast<std::uint8_t>(k);  // control characters too
  QVERIFY(pty.send(every));
  Result<Bytes> got = Error{};
  std::thread([&] { got = readAll(**stream, every.size()); }).join();  // not the thread that opened it
  VERIFY_OK(got);
  QCOMPARE(*got, every);
  VERIFY_OK((*stream)->write(every));
  Bytes back;
  while (back.size() < every.size()) {
    const Bytes some = pty.receive();
    QVERIFY(!some.empty());
    back.insert(back.end(), some.begin(), some.end());
  }
  QCOMPARE(back, every);
}

void TestTransport::serialPort_runsRawAtTheBaudThatWasAskedFor() {
  const Pty pty;
  for (const unsigned baud : {9600u, 921600u, 3000000u, 250000u}) {
    const auto stream = openByteStream("serial:" + pty.path() + "@" + std::to_string(baud));
    VERIFY_OK(stream);
    termios2 line{};
    QCOMPARE(::ioctl(pty.far(), TCGETS2, &line), 0);
    QCOMPARE(line.c_ospeed, baud);
    QCOMPARE(line.c_cflag & CSIZE, tcflag_t(CS8));
    QCOMPARE(line.c_cflag & (PARENB | CSTOPB | CRTSCTS), tcflag_t(0));
    QCOMPARE(line.c_iflag | line.c_oflag | line.c_lflag, tcflag_t(0));
  }
}

void TestTransport::serialPort_isOpenedOnce() {
  const Pty pty;
  auto first = openByteStream("serial:" + pty.path());
  VERIFY_OK(first);
  VERIFY_ERROR(
      openByteStream("serial:" + pty.path()),
      "serial port " + pty.path() + ": is in use by another program; close it, and ModemManager too if it runs");
  first->reset();
  VERIFY_OK(openByteStream("serial:" + pty.path()));
}

void TestTransport::missingPort_saysWhatThereIs() {
  const auto stream = openByteStream("serial:ttyNoSuchPort7");
  QVERIFY(!stream);
  const QString line = QString::fromStdString(stream.error().message());
  QVERIFY2(line.startsWith("serial port /dev/ttyNoSuchPort7: there is no such port; "), qPrintable(line));
  const auto ports = serialPorts();
  QVERIFY(line.contains(ports.empty() ? "none is plugged in" : ports.front().words().c_str()));
}

void TestTransport::forbiddenPort_saysWhichGroup() {
  const Pty pty;
  QCOMPARE(::chmod(pty.path().c_str(), 0), 0);
  const bool root = ::geteuid() == 0;  // to whom nothing is forbidden
  if (root) QCOMPARE(::seteuid(65534), 0);
  const auto stream = openByteStream("serial:" + pty.path());
  if (root) QCOMPARE(::seteuid(0), 0);
  QVERIFY(!stream);
  const QString line = QString::fromStdString(stream.error().message());
  static const QRegularExpression advice(
      R"(may not be opened by (\S+); it belongs to the group (\S+): run "sudo adduser \1 \2", then log out and in again$)");
  QVERIFY2(line.contains(advice), qPrintable(line));
}

void TestTransport::whatIsNoSerialPort_isRefused() {
  VERIFY_ERROR(openByteStream("serial:/dev/null"), "serial port /dev/null: is no serial port");
}

void TestTransport::silentPort_isNoError_andTakesNothingForever() {
  const Pty pty;
  auto stream = openByteStream("serial:" + pty.path());
  VERIFY_OK(stream);
  Bytes bytes;
  const auto before = std::chrono::steady_clock::now();
  VERIFY_OK((*stream)->read(bytes, 0.1));
  const auto waited = std::chrono::steady_clock::now() - before;
  QVERIFY(bytes.empty() && waited > 80ms && waited < 1s);
  VERIFY_OK((*stream)->read(bytes, 0.0));
  VERIFY_ERROR((*stream)->write(numbered(1 << 20)), "serial port " + pty.path() + ": took nothing for a second");
}

void TestTransport::port_thatDisappears_isNamedGone() {
  Pty pty;
  auto stream = openByteStream("serial:" + pty.path());
  VERIFY_OK(stream);
  const Bytes sent = numbered(30000);
  std::thread board([&] {
    pty.send(sent);
    std::this_thread::sleep_for(50ms);
    pty.hangUp();
  });
  const auto [bytes, line] = readToEnd(**stream);
  board.join();
  QCOMPARE(bytes, sent);
  const std::string gone = "serial port " + pty.path() + ": is gone: the other end hung up or the cable was pulled";
  QCOMPARE(line, gone);
  VERIFY_ERROR((*stream)->write(sent), gone);
}

void TestTransport::port_opensAgain_afterTheOtherEndCameBack() {
  const Listener listener;
  for (int round = 0; round < 3; ++round) {
    auto stream = openByteStream(listener.uri());
    VERIFY_OK(stream);
    ::close(listener.accept());
    QVERIFY(!readToEnd(**stream).second.empty());
    Bytes none;
    QVERIFY(!(*stream)->read(none, 0.0));  // gone stays gone
  }
}

void TestTransport::slowReader_losesNothing() {
  const Pty pty;
  auto stream = openByteStream("serial:" + pty.path() + "@3000000");
  VERIFY_OK(stream);
  const Bytes sent = numbered(3'000'000);
  std::thread board([&] { pty.send(sent); });
  Bytes got;
  while (got.size() < sent.size()) {
    std::this_thread::sleep_for(100ms);
    VERIFY_OK((*stream)->read(got, 1.0));
  }
  board.join();
  QVERIFY(got == sent);
}

void TestTransport::readAhead_stopsFetching_whenNobodyTakes() {
  std::atomic<size_t> fetched{0};
  ReadAhead stream(std::make_unique<Tap>(fetched), 1000);
  QTRY_COMPARE(fetched.load(), size_t(1000));
  std::this_thread::sleep_for(50ms);
  QCOMPARE(fetched.load(), size_t(1000));
  Bytes bytes;
  VERIFY_OK(stream.read(bytes, 0.1));
  QCOMPARE(bytes.size(), size_t(1000));
  QTRY_COMPARE(fetched.load(), size_t(2000));
}

void TestTransport::tcp_carriesBytesBothWays_onLoopbackByDefault() {
  const Listener listener;
  auto stream = openByteStream(listener.uri());
  VERIFY_OK(stream);
  const int far = listener.accept();
  const Bytes sent = numbered(100000);
  std::thread echo([far] {
    Bytes buffer(4096);
    for (ssize_t got = 0; (got = ::read(far, buffer.data(), buffer.size())) > 0;) {
      if (::write(far, buffer.data(), static_cast<size_t>(got)) != got) break;
    }
    ::close(far);
  });
  VERIFY_OK((*stream)->write(sent));
  const auto got = readAll(**stream, sent.size());
  stream->reset();
  echo.join();
  VERIFY_OK(got);
  QVERIFY(*got == sent);
}

void TestTransport::tcp_handsOverAllThatCame_beforeItIsGone() {
  const Listener listener;
  auto stream = openByteStream(listener.uri());
  VERIFY_OK(stream);
  const Bytes sent = numbered(50000);
  const int far = listener.accept();
  QCOMPARE(::write(far, sent.data(), sent.size()), ssize_t(sent.size()));
  ::close(far);
  const auto [bytes, line] = readToEnd(**stream);
  QVERIFY(bytes == sent);
  QCOMPARE(line,
           "127.0.0.1:" + std::to_string(listener.port()) + ": is gone: the other end hung up or the cable was pulled");
}

void TestTransport::tcp_refused_saysSo() {
  std::uint16_t port = 0;
  {
    const Listener closed;
    port = closed.port();
  }
  const std::string number = std::to_string(port);
  VERIFY_ERROR(openByteStream("tcp:localhost:" + number),
               "localhost:" + number + ": refuses the connection: nothing listens on that port");
  const auto unknown = openByteStream("tcp:no-such-host.invalid:2000");
  QVERIFY(!unknown);
  QVERIFY(unknown.error().message().starts_with("no-such-host.invalid:2000: is no known host"));
}

void TestTransport::tcp_halfOpen_isSilent() {
  const Listener listener;  // the system answers for it, but nobody ever accepts
  auto stream = openByteStream(listener.uri());
  VERIFY_OK(stream);
  Bytes bytes;
  VERIFY_OK((*stream)->write(numbered(100)));
  VERIFY_OK((*stream)->read(bytes, 0.1));
  QVERIFY(bytes.empty());
}

/// A folder as the kernel's: an adapter on USB, a chip on the mainboard, a socket without one, and a console.
void TestTransport::ports_areReadFromTheKernel() {
  const TemporaryFolder kernel;
  const QDir folder(QString::fromStdString(kernel.path()));
  for (const char* made : {"devices/usb1/1-2/1-2:1.0", "devices/serial8250", "class/tty/ttyS0", "class/tty/ttyS1",
                           "class/tty/ttyACM0", "class/tty/tty0"})
    QVERIFY(folder.mkpath(made));
  const auto link = [&](const char* port, const char* hardware) {
    return QFile::link(folder.filePath(hardware), folder.filePath(QString("class/tty/") + port + "/device"));
  };
  QVERIFY(link("ttyS0", "devices/serial8250") && link("ttyS1", "devices/serial8250"));
  QVERIFY(link("ttyACM0", "devices/usb1/1-2/1-2:1.0"));
  kernel.write("class/tty/ttyS0/type", "4\n");
  kernel.write("class/tty/ttyS1/type", "0\n");
  kernel.write("devices/usb1/1-2/idVendor", "0483\n");
  kernel.write("devices/usb1/1-2/product", "ChibiOS/RT Virtual COM Port\n");
  kernel.write("devices/usb1/1-2/manufacturer", "STMicroelectronics\n");
  kernel.write("devices/usb1/1-2/serial", "304\n");

  const auto ports = serialPorts(kernel.path());
  QCOMPARE(ports.size(), size_t{2});
  QCOMPARE(ports[0].words(), std::string("ChibiOS/RT Virtual COM Port (ttyACM0)"));
  QCOMPARE(ports[0].maker, std::string("STMicroelectronics"));
  QCOMPARE(ports[0].serialNumber, std::string("304"));
  QVERIFY(ports[0].usb);
  QCOMPARE(ports[1].device, std::string("/dev/ttyS0"));
  QVERIFY(!ports[1].usb && ports[1].product.empty());
}

void TestTransport::ports_haveOneNameEach() {
  for (const SerialPort& one : serialPorts()) {
    QVERIFY(one.device.starts_with("/dev/"));
    QVERIFY(!one.lasting.empty() && !one.words().empty());
  }
  QCOMPARE((SerialPort{"/dev/ttyACM0", "", "ChibiOS/RT Virtual COM Port", "", "", true}.words()),
           std::string("ChibiOS/RT Virtual COM Port (ttyACM0)"));
  QCOMPARE((SerialPort{"/dev/ttyS0", "", "", "", "", false}.words()), std::string("ttyS0"));
}

QTEST_APPLESS_MAIN(TestTransport)
#include "tst_transport.moc"
