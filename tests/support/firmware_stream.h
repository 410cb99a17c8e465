// The portable board behind a byte stream without a system in between; and a stream that spoils what passes.
#pragma once

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "firmware_link/byte_stream.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_firmware.h"

namespace breakaway::test {

/// A board of granted pace: it runs in write(), as far as it is allowed to.
class FirmwareStream final : public ByteStream {
 public:
  /// What the other end does, shared so that a test can reach it while a drive owns the stream.
  struct Far {
    explicit Far(Rig simulated, unsigned noise = 1, const std::string& serialNumber = {})
        : rig(std::move(simulated)),
          seed(noise),
          board(std::make_unique<SimulatedFirmware>(rig, seed, board::Pace::granted, boot, serialNumber)) {}
    Rig rig;
    unsigned seed;
    std::uint16_t boot = 1000;
    std::unique_ptr<SimulatedFirmware> board;
    std::vector<std::uint8_t> out;
    bool unplugged = false, silent = false;

    void powerUpAnew() {
      boot = static_cast<std::uint16_t>(boot + 1000);
      board = std::make_unique<SimulatedFirmware>(rig, seed, board::Pace::granted, boot);
    }
  };

  explicit FirmwareStream(std::shared_ptr<Far> far) : far_(std::move(far)) {}

  Result<void> write(std::span<const std::uint8_t> bytes) override {
    if (far_->unplugged) return Error{"board", "is gone"};
    if (far_->silent) return {};
    far_->board->receive(bytes);
    far_->board->transmit(far_->out);
    far_->board->run(1u << 20, far_->out);
    return {};
  }
  Result<void> read(std::vector<std::uint8_t>& bytes, double /*wait_s*/) override {
    if (far_->unplugged) return Error{"board", "is gone"};
    bytes.insert(bytes.end(), far_->out.begin(), far_->out.end());
    far_->out.clear();
    return {};
  }

 private:
  std::shared_ptr<Far> far_;
};

inline Rig presetRig(const std::string& name) {
  const auto file = rigFileOf("simulated:" + name);
  const auto rig = file ? readRig(*file) : Result<Rig>(file.error());
  if (!rig) qFatal("%s", rig.error().message().c_str());
  return *rig;
}

/// What a bad line does to bytes.
struct Spoiling {
  double flipped = 0.0, dropped = 0.0, doubled = 0.0, truncated = 0.0, garbage = 0.0,
         reordered = 0.0;  ///< per byte, or per piece
  bool bootText = false;
};

/// Spoils both ways; counts what it did.
class SpoiledStream final : public ByteStream {
 public:
  /// What is spoiled may be changed while it runs.
  SpoiledStream(std::unique_ptr<ByteStream> inner, std::shared_ptr<const Spoiling> spoiling, unsigned seed)
      : inner_(std::move(inner)), spoiling_(std::move(spoiling)), random_(seed) {}

  Result<void> write(std::span<const std::uint8_t> bytes) override {
    const std::vector<std::uint8_t> wrong = spoiled({bytes.begin(), bytes.end()});
    return inner_->write(wrong);
  }
  Result<void> read(std::vector<std::uint8_t>& bytes, double wait_s) override {
    std::vector<std::uint8_t> came;
    if (auto read = inner_->read(came, wait_s); !read) return read;
    const std::vector<std::uint8_t> wrong = spoiled(std::move(came));
    bytes.insert(bytes.end(), wrong.begin(), wrong.end());
    return {};
  }

 private:
  bool happens(double share) { return std::uniform_real_distribution<double>()(random_) < share; }

  std::vector<std::uint8_t> spoiled(std::vector<std::uint8_t> bytes) {
    std::vector<std::vector<std::uint8_t>> pieces(1);
    for (const std::uint8_t byte : bytes) {
      pieces.back().push_back(byte);
      if (byte == 0) pieces.emplace_back();
    }
    for (std::size_t k = 0; k + 2 < pieces.size(); ++k) {
      if (happens(spoiling_->reordered)) std::swap(pieces[k], pieces[k + 1]);
    }
    std::vector<std::uint8_t> out;
    if (pieces.back().empty()) pieces.pop_back();
    for (auto& piece : pieces) {
      if (happens(spoiling_->truncated)) piece.resize(piece.size() / 2);
      const int times = happens(spoiling_->doubled) ? 2 : 1;
      for (int k = 0; k < times; ++k) {
        if (happens(spoiling_->garbage))
          for (int n = 0; n < 40; ++n) out.push_back(static_cast<std::uint8_t>(random_()));
        if (spoiling_->bootText && happens(0.02)) {
          const char* text = "boot v2.1 ok\r\n";
          out.insert(out.end(), text, text + std::strlen(text));
        }
        for (const std::uint8_t byte : piece) {
          if (happens(spoiling_->dropped)) continue;
          out.push_back(happens(spoiling_->flipped) ? static_cast<std::uint8_t>(byte ^ (1u << random_() % 8)) : byte);
        }
      }
    }
    return out;
  }

  std::unique_ptr<ByteStream> inner_;
  std::shared_ptr<const Spoiling> spoiling_;
  std::mt19937 random_;
};

}  // namespace breakaway::test
