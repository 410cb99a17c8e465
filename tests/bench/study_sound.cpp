// What diagnose says of plain motors that lack nothing, on logs of a plant that it shares nothing with.
// ./dev bench sound [RIGS]
#include <charconv>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>

#include "diagnose/diagnosis.h"
#include "support/plain_motor.h"

using namespace breakaway;

namespace {

void study(const char* words, test::LogKind kind, std::uint64_t rigs) {
  std::map<std::string, int> verdicts;
  for (std::uint64_t seed = 1; seed <= rigs; ++seed) {
    const test::PlainMotorLog log = test::plainMotorLog(seed, kind);
    const auto diagnosis = diagnose(log.bench, {log.recording}, {}, {});
    const std::string verdict = diagnosis ? nameOf(diagnosis->verdict) : "refused";
    ++verdicts[verdict];
    if (verdict == "nothing_missing") continue;
    std::printf("  %-17s seed %llu: %s", verdict.c_str(), static_cast<unsigned long long>(seed), log.words.c_str());
    if (!diagnosis) {
      std::printf("; %s\n", diagnosis.error().message().c_str());
      continue;
    }
    const double coulomb = diagnosis->base.baseValue("coulomb_Nm").value_or(0.0);
    std::printf("; wander found %.1f %%\n", coulomb > 0.0 ? 100.0 * diagnosis->wander.rms / coulomb : 0.0);
    for (const Finding& finding : diagnosis->findings)
      std::printf("    %s: %s\n", finding.effect.c_str(), finding.sentence.c_str());
    std::fflush(stdout);
  }
  std::printf("%s:", words);
  for (const auto& [verdict, count] : verdicts) std::printf(" %d %s", count, verdict.c_str());
  std::printf(" of %llu\n", static_cast<unsigned long long>(rigs));
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t rigs = 40;
  if (argc > 1) {
    const char* end = argv[1] + std::strlen(argv[1]);
    if (const auto read = std::from_chars(argv[1], end, rigs); read.ec != std::errc() || read.ptr != end || rigs == 0) {
      std::fprintf(stderr, "sound: expected how many rigs, found \"%s\"\n", argv[1]);
      return 2;
    }
  }
  study("sound rigs, sound logs", test::LogKind::sound, rigs);
  study("sound rigs, imperfect logs", test::LogKind::imperfect, rigs);
  study("sound rigs, current measured", test::LogKind::measured, rigs);
  return 0;
}
