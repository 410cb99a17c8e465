// What the firmware costs on a Cortex-M3 without an FPU: instructions per control tick, counted in the emulator, and
// memory.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

constexpr double instructionsPerClock = 40.0;  // the emulator's timer at 25 MHz, an instruction each nanosecond
constexpr double cyclesPerInstruction = 1.5;   // an assumption: the emulator isn't cycle-true
constexpr double clock_Hz = 96e6, target = 0.6;

/// The lines that a command prints; empty when it can't be run.
std::string outputOf(const std::string& command) {
  std::string text;
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  char chunk[512];
  while (std::fgets(chunk, sizeof chunk, pipe) != nullptr) text += chunk;
  ::pclose(pipe);
  return text;
}

double shareOf(double clocks, double rate_Hz) {
  return clocks * instructionsPerClock * cyclesPerInstruction * rate_Hz / clock_Hz;
}

void printTick(const char* name, double mean_clocks, double most_clocks) {
  std::printf("%-10s %8.0f %8.0f %10.1f %% %10.1f %% %10.1f %%\n", name, mean_clocks * instructionsPerClock,
              most_clocks * instructionsPerClock, 100.0 * shareOf(mean_clocks, 5000.0),
              100.0 * shareOf(most_clocks, 5000.0), 100.0 * shareOf(mean_clocks, 10000.0));
}

void printMemory(const std::string& image) {
  const std::string sizes = outputOf("arm-none-eabi-size " + image);
  unsigned long text = 0, initialised = 0, zeroed = 0;
  const size_t second = sizes.find('\n');
  if (second == std::string::npos ||
      std::sscanf(sizes.c_str() + second, "%lu %lu %lu", &text, &initialised, &zeroed) != 3) {
    std::printf("the size of %s can't be read\n", image.c_str());
    return;
  }
  std::printf("LPC1768 image: flash %.1f kB, RAM %.1f kB without the stack\n",
              1e-3 * static_cast<double>(text + initialised), 1e-3 * static_cast<double>(initialised + zeroed));
}

}  // namespace

int main() {
  const std::string folder = "build/firmware/";
  if (!std::filesystem::exists(folder + "tick_cost.elf")) {
    std::printf("no firmware is built here; ./dev bench firmware builds it\n");
    return 0;
  }
  const std::string told = outputOf(
      "timeout 120 qemu-system-arm -M mps2-an385 -nographic -monitor none -serial stdio -icount shift=0 -semihosting "
      "-kernel " +
      folder + "tick_cost.elf </dev/null");
  std::printf(
      "one tick, everything on (friction map of 180 bins with static friction, a bridge's curve, all gains, all 12\n"
      "channels and a capture in every tick)\n");
  std::printf("%-10s %8s %8s %12s %12s %12s\n", "mode", "mean", "most", "at 5 kHz", "longest", "at 10 kHz");
  double dearest = 0.0, longest = 0.0, table = 0.0;
  unsigned long refused = 1;
  bool ticks = true;  // what follows the heartbeat is none
  for (size_t at = 0; at < told.size();) {
    const size_t end = std::min(told.find('\n', at), told.size());
    const std::string line = told.substr(at, end - at);
    at = end + 1;
    char name[32];
    unsigned long mean = 0, most = 0;
    if (std::sscanf(line.c_str(), "%31s mean %lu most %lu", name, &mean, &most) != 3) continue;
    const std::string what = name;
    if (what == "refused") refused = mean;
    if (what == "table") table = static_cast<double>(mean) * instructionsPerClock;
    ticks = ticks && what != "heartbeat";
    if (!ticks || what == "timer" || what == "sending") continue;
    printTick(name, static_cast<double>(mean), static_cast<double>(most));
    dearest = std::max(dearest, static_cast<double>(mean));
    longest = std::max(longest, static_cast<double>(most));
  }
  if (dearest == 0.0) {
    std::printf("the emulator counted nothing\n");
    return 1;
  }
  if (refused > 0) {
    std::printf("the board refused what it was to be measured with\n");
    return 1;
  }
  const double share = shareOf(dearest, 5000.0);
  std::printf("mean and most in instructions; shares of %.0f MHz with %.1f cycles each\n", 1e-6 * clock_Hz,
              cyclesPerInstruction);
  std::printf("the dearest mode at 5 kHz: %.1f %%, its longest tick %.1f %%, target %.0f %%: %s\n", 100.0 * share,
              100.0 * shareOf(longest, 5000.0), 100.0 * target, share <= target ? "reached" : "not reached");
  std::printf("taking a friction table of 180 bins: %.0f instructions, %.1f ms\n", table,
              1e3 * table * cyclesPerInstruction / clock_Hz);
  printMemory(folder + "lpc1768_board.elf");
  return 0;
}
