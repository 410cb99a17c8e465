// How soon a STOP in the window is on the wire while a board streams 10 kHz over TCP: the window with its live plots,
// the I/O thread, the drive and the transport are the real ones, the board is our firmware around a simulated motor.
#include <QApplication>
#include <QPushButton>
#include <QTemporaryDir>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "firmware_link/board_drive.h"
#include "firmware_link/board_server.h"
#include "firmware_link/presets.h"
#include "firmware_link/transport/open_byte_stream.h"
#include "firmware_link/wire/frame.h"
#include "firmware_link/wire/messages.h"
#include "main_window.h"
#include "plant/rig.h"
#include "session/session.h"
#include "widgets/file_chooser.h"

using namespace breakaway;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

namespace {

constexpr double rate_Hz = 10000.0;
constexpr int presses = 300;

/// When the last stop was handed to the system, and how much came.
struct Witness {
  std::atomic<Clock::rep> stopped{0};
  std::atomic<size_t> received{0};
};

class Tap final : public ByteStream {
 public:
  Tap(std::unique_ptr<ByteStream> stream, Witness& witness) : stream_(std::move(stream)), witness_(witness) {}
  Result<void> write(std::span<const std::uint8_t> bytes) override {
    auto written = stream_->write(bytes);
    for (const std::uint8_t byte : bytes) {
      if (decoder_.take(byte) && decoder_.frame().type == static_cast<std::uint8_t>(wire::Type::stop))
        witness_.stopped = Clock::now().time_since_epoch().count();
    }
    return written;
  }
  Result<void> read(std::vector<std::uint8_t>& bytes, double wait_s) override {
    const size_t before = bytes.size();
    auto read = stream_->read(bytes, wait_s);
    witness_.received += bytes.size() - before;
    return read;
  }

 private:
  std::unique_ptr<ByteStream> stream_;
  wire::FrameDecoder decoder_;
  Witness& witness_;
};

bool waitFor(const std::function<bool()>& reached, std::chrono::milliseconds most) {
  const auto end = Clock::now() + most;
  while (!reached()) {
    if (Clock::now() > end) return false;
    QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 2);
  }
  return true;
}

double part(std::vector<double>& sorted, double share) {
  return sorted[std::min(sorted.size() - 1, static_cast<size_t>(share * static_cast<double>(sorted.size())))];
}

int fail(const std::string& line) {
  std::fprintf(stderr, "bench_stop: %s\n", line.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QTemporaryDir runtime;
  qputenv("XDG_RUNTIME_DIR", runtime.path().toUtf8());
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  QApplication application(argc, argv);
  auto rig = readRig(resourcesFolder() + "/presets/servo.rig.json");
  if (!rig) return fail(rig.error().message());
  rig->loopRate_Hz = rate_Hz;
  auto end = FarEnd::loopback(0);
  if (!end) return fail(end.error().message());
  SimulatedFirmware firmware(*rig, 1, board::Pace::real, 1);
  BoardServer server(firmware, *end, board::Pace::real);
  const std::jthread board([&server](const std::stop_token& ending) {
    while (!ending.stop_requested()) server.turn();
  });
  auto stream = openByteStream(end->uri());
  if (!stream) return fail(stream.error().message());
  Witness witness;
  auto drive = openBoardDrive(std::make_unique<Tap>(std::move(*stream), witness),
                              {.place = end->uri(), .channels = wire::allChannels});
  if (!drive) return fail(drive.error().message());
  Session session;
  FileDialogs files;
  MainWindow window(session, files);
  window.show();
  session.connection.adopt(std::move(*drive), QString::fromStdString(end->uri()));
  waitFor([] { return false; }, 500ms);
  auto* stop = window.findChild<QPushButton*>("stopButton");
  const auto begin = Clock::now();
  const size_t before = witness.received;
  std::vector<double> latency_s;
  int unanswered = 0;
  for (int k = 0; k < presses; ++k) {
    session.bench.turnSlowly();
    if (!waitFor([&] { return session.connection.powered(); }, 2000ms)) ++unanswered;
    waitFor([] { return false; }, std::chrono::milliseconds(10 + (k * 37) % 50));
    // From another thread, so that what the window is busy with counts as for a person.
    std::atomic<Clock::rep> pressed{0};
    std::thread([&] {
      pressed = Clock::now().time_since_epoch().count();
      QMetaObject::invokeMethod(
          stop, [stop] { emit stop->pressed(); }, Qt::QueuedConnection);
    }).join();
    const bool out = waitFor([&] { return witness.stopped > pressed; }, 2000ms);
    if (out) latency_s.push_back(std::chrono::duration<double>(Clock::duration(witness.stopped - pressed)).count());
    if (!out) ++unanswered;
  }
  const double took_s = std::chrono::duration<double>(Clock::now() - begin).count();
  const double rate = static_cast<double>(witness.received - before) / took_s;
  if (latency_s.empty()) return fail("no STOP reached the wire");
  std::sort(latency_s.begin(), latency_s.end());
  double load[1] = {0.0};
  if (::getloadavg(load, 1) != 1) load[0] = -1.0;
  std::printf(
      "a board at %.0f kHz over TCP with %d channels, %.2f MB/s into the window, %zu samples lost, board late by %.1f "
      "s\n",
      1e-3 * rate_Hz, static_cast<int>(wire::channelCount), 1e-6 * rate, session.connection.link().lost,
      server.late_s());
  std::printf(
      "%zu presses of STOP until the wire: median %.1f ms, 99 %% %.1f ms (50), worst %.1f ms; %d not out in 2 s; load "
      "of this machine %.1f\n",
      latency_s.size(), 1e3 * part(latency_s, 0.5), 1e3 * part(latency_s, 0.99), 1e3 * latency_s.back(), unanswered,
      load[0]);
  session.connection.close();
  return 0;
}
