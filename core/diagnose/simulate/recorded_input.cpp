#include "diagnose/simulate/recorded_input.h"

namespace breakaway {

std::string recordedInput(const Recording& recording, const Bench& bench) {
  std::string own = bench.inputChannel();
  if (recording.has(own)) return own;
  for (const auto& [input, other] :
       {std::pair{DriveInput::voltage, "duty"}, std::pair{DriveInput::duty, "voltage_V"}}) {
    if (bench.input == input && recording.has(other)) return other;
  }
  return own;
}

}  // namespace breakaway
