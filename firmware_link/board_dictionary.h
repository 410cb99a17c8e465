// Who a board is and what it calls its parameters, asked for once.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "firmware_link/board_link.h"
#include "firmware_link/sample_decoder.h"
#include "firmware_link/wire/messages.h"

namespace breakaway {

struct BoardParameter {
  std::uint16_t id = 0;
  std::string name;
  wire::Format format = wire::Format::float32;
  bool writable = false;
  double least = 0.0, most = 0.0;
};

class BoardDictionary {
 public:
  /// Says hello and reads the dictionary. Errors: no answer, another version, entries that aren't the wire's, numbers
  /// that no board has (checkHello(), checkEntry(), checkValue()).
  static Result<BoardDictionary> read(BoardLink& link);

  const wire::Hello& hello() const { return hello_; }
  bool can(wire::Hello::Ability what) const { return (hello_.abilities & what) != 0; }
  std::string device() const;
  std::string firmware() const;
  /// Empty: the board says none.
  std::string serialNumber() const;
  const std::vector<BoardParameter>& parameters() const { return parameters_; }
  const BoardParameter* find(const std::string& name) const;
  SampleDecoder::Board telemetry() const;

  /// Values by name, in that order. Errors: no such parameter, the link's.
  Result<std::vector<double>> values(BoardLink& link, const std::vector<std::string>& names) const;
  /// Sets all of them at once; returns what was accepted, in that order.
  Result<std::vector<double>> write(BoardLink& link, const std::vector<std::pair<std::string, double>>& wanted) const;

 private:
  Result<void> checkValues(BoardLink& link) const;
  Result<std::vector<double>> exchange(BoardLink& link, wire::Type type,
                                       const std::vector<std::pair<std::string, double>>& values) const;

  wire::Hello hello_;
  wire::SerialNumber serial_;
  std::vector<BoardParameter> parameters_;
  double scale_[wire::channelCount] = {};
};

}  // namespace breakaway
