// What diagnose says of plain motors that lack nothing, on logs of a plant that it shares nothing with.
// ./dev bench sound [RIGS [sound|imperfect|measured]]
#include <array>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>

#include "diagnose/diagnosis.h"
#include "support/plain_motor.h"

using namespace breakaway;

namespace {

struct Kind {
  const char* name;
  test::LogKind kind;
};
constexpr std::array<Kind, 3> kinds{
    {{"sound", test::LogKind::sound}, {"imperfect", test::LogKind::imperfect}, {"measured", test::LogKind::measured}}};

void study(const Kind& asked, std::uint64_t rigs) {
  std::map<std::string, int> verdicts;
  for (std::uint64_t seed = 1; seed <= rigs; ++seed) {
    const test::PlainMotorLog log = test::plainMotorLog(seed, asked.kind);
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
  std::printf("sound rigs, logs %s:", asked.name);
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
  bool any = false;
  for (const Kind& kind : kinds) {
    if (argc > 2 && std::strcmp(argv[2], kind.name) != 0) continue;
    study(kind, rigs);
    any = true;
  }
  if (!any) std::fprintf(stderr, "sound: expected sound, imperfect or measured, found \"%s\"\n", argv[2]);
  return any ? 0 : 2;
}
