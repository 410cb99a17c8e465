// A soak of the line: 10 kHz × 12 channels from a board in a process of its own, through a pty, and what is lost of it;
// resident memory of both ends at the beginning and at the end. ./dev bench soak [SECONDS]
#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>

#include "firmware_link/board_dictionary.h"
#include "firmware_link/board_link.h"
#include "firmware_link/presets.h"
#include "firmware_link/sample_decoder.h"
#include "firmware_link/transport/open_byte_stream.h"
#include "support/resident_memory.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

using Clock = std::chrono::steady_clock;
constexpr double rate_Hz = 10000.0, beatEvery_s = 0.05, settles_s = 3.0;

double since_s(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

/// The servo's rig with a tick of 0.1 ms.
bool writeRig(const QString& path) {
  QFile from(QString::fromStdString(resourcesFolder() + "/presets/servo.rig.json")), to(path);
  if (!from.open(QIODevice::ReadOnly) || !to.open(QIODevice::WriteOnly)) return false;
  QJsonObject rig = QJsonDocument::fromJson(from.readAll()).object();
  rig["loop_rate_Hz"] = rate_Hz;
  return to.write(QJsonDocument(rig).toJson()) > 0;
}

int fail(const std::string& line) {
  std::fprintf(stderr, "soak: %s\n", line.c_str());
  return 1;
}

struct Sums {
  std::size_t frames = 0, samples = 0, gaps = 0;
  std::uint32_t dropped = 0;  ///< by the board, by its own count
  int restarts = 0;           ///< of the motor, after a fault
};

class Soak {
 public:
  Soak(BoardLink& link, const BoardDictionary& board) : link_(link), decoder_(board.telemetry()) {
    latch_ = board.hello().latch;
    link_.listen([this](const wire::Frame& frame) { heard(frame); });
  }

  Result<void> begin(const BoardDictionary& board) {
    const auto told =
        board.write(link_, {{"telemetry_channels", static_cast<double>(wire::allChannels)}, {"telemetry_every", 1.0}});
    if (!told) return told.error();
    turn();
    return link_.flush();
  }

  Result<void> run(double duration_s) {
    const auto begun = Clock::now();
    while (since_s(begun) < duration_s) {
      if (since_s(beaten_) >= beatEvery_s) {
        link_.prepare(wire::Type::heartbeat, bodyOf(wire::Heartbeat{}));
        beaten_ = Clock::now();
      }
      if (auto sent = link_.flush(); !sent) return sent;
      if (auto taken = link_.take(0.01); !taken) return taken.error();
    }
    return {};
  }

  const Sums& sums() const { return sums_; }

 private:
  /// A motor that turns, so that the channels carry something.
  void turn() {
    wire::MotorCommand command;
    command.mode = wire::MotorCommand::Mode::velocity;
    command.flags = wire::MotorCommand::fresh;
    command.latch = latch_;
    command.target = 30.0f;
    link_.prepare(wire::Type::command, bodyOf(command));
  }

  void heard(const wire::Frame& frame) {
    constexpr auto alive = static_cast<std::uint8_t>(wire::Type::heartbeat) | wire::answerBit;
    if (frame.type == static_cast<std::uint8_t>(wire::Type::telemetry)) {
      wire::BatchHeader header;
      if (!wire::readMessage(frame.body, header)) return;
      samples_.clear();
      sums_.gaps += decoder_.take(frame.body, samples_);
      sums_.samples += samples_.size();
      sums_.dropped = header.dropped;
      ++sums_.frames;
    } else if (frame.type == alive && frame.body.size() > 1) {
      wire::Alive told;
      if (!wire::readMessage(frame.body.subspan(1), told) || told.latch == latch_) return;
      latch_ = told.latch;
      ++sums_.restarts;
      turn();
    }
  }

  BoardLink& link_;
  SampleDecoder decoder_;
  std::vector<Sample> samples_;
  Sums sums_;
  std::uint16_t latch_ = 0;
  Clock::time_point beaten_;
};

int soak(double duration_s) {
  const QTemporaryDir folder;
  const QString rig = folder.filePath("fast.rig.json");
  if (!writeRig(rig)) return fail("the servo's rig file can't be copied");
  QProcess process;
  process.start(QCoreApplication::applicationDirPath() + "/breakaway-board", {"--rig", rig});
  if (!process.waitForReadyRead(10000)) return fail("breakaway-board doesn't start");
  const std::string uri = QString::fromUtf8(process.readLine()).trimmed().toStdString();
  auto stream = openByteStream(uri);
  if (!stream) return fail(stream.error().message());
  BoardLink link(std::move(*stream), uri);
  const auto board = BoardDictionary::read(link);
  if (!board) return fail(board.error().message());
  Soak soaked(link, *board);
  if (auto begun = soaked.begin(*board); !begun) return fail(begun.error().message());
  if (auto settled = soaked.run(settles_s); !settled) return fail(settled.error().message());
  const std::size_t lostBefore = soaked.sums().gaps;
  const Sums first = soaked.sums();
  const double host_MB = resident_MB(QCoreApplication::applicationPid()), board_MB = resident_MB(process.processId());
  const auto begun = Clock::now();
  if (auto ran = soaked.run(duration_s); !ran) return fail(ran.error().message());
  const double took_s = since_s(begun);
  const Sums& last = soaked.sums();
  const double hostAfter_MB = resident_MB(QCoreApplication::applicationPid()),
               boardAfter_MB = resident_MB(process.processId());
  process.terminate();
  process.waitForFinished(5000);
  const std::size_t samples = last.samples - first.samples;
  std::printf("%.0f s of 10 kHz x %zu channels through a pty: %zu frames, %zu samples (%.0f a second)\n", took_s,
              wire::channelCount, last.frames - first.frames, samples, static_cast<double>(samples) / took_s);
  std::printf("lost: %zu samples (%u that the board had no room for), %u damaged frames\n", last.gaps, last.dropped,
              link.counts().errors());
  if (lostBefore > 0) std::printf("of these %zu in the first %.0f s\n", lostBefore, settles_s);
  std::printf("resident memory: host %.1f MB, then %.1f MB; board %.1f MB, then %.1f MB\n", host_MB, hostAfter_MB,
              board_MB, boardAfter_MB);
  if (last.restarts > 0) std::printf("the board stopped the motor %d times, its lease over\n", last.restarts);
  const QByteArray late = process.readAllStandardError().trimmed();
  if (!late.isEmpty()) std::printf("%s\n", late.constData());
  const bool flat = hostAfter_MB < host_MB + 2.0 && boardAfter_MB < board_MB + 2.0;
  if (!flat) std::printf("memory grew\n");
  return last.gaps == 0 && last.dropped == 0 && link.counts().errors() == 0 && flat && samples > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  double duration_s = 600.0;
  if (argc > 1) {
    const char* end = argv[1] + std::strlen(argv[1]);
    const auto [rest, code] = std::from_chars(argv[1], end, duration_s);
    if (argc > 2 || code != std::errc() || rest != end || !(duration_s > 0.0 && duration_s < 1e6)) {
      std::fprintf(stderr, "soak: \"%s\" is no duration, expected seconds above 0\n", argv[1]);
      return 2;
    }
  }
  return soak(duration_s);
}
