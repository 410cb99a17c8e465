// What diagnose says of other people's rigs: a plant that it shares nothing with, one piece of physics concealed.
// ./dev bench rigs [RIGS [FAMILY…]]
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "diagnose/diagnosis.h"
#include "support/foreign_rig.h"

using namespace breakaway;

namespace {

enum Answer { right, besides, rival, hidden, nothing, outside, wrong, undecided, answers };
constexpr std::array<const char*, answers> words{
    "right",   "right, more beside", "a rival",  "nothing, at the floor", "nothing missing",
    "outside", "wrong name",         "undecided"};
constexpr double nearFloor = 2.0;

/// Whether the base model errs on held-out data about as a perfect one would, wandering as this rig does: then what is
/// concealed hardly moves anything.
bool nothingToSee(const FitScore& fit) {
  return fit.heldoutBefore < nearFloor * fit.floorWithWander;
}

Answer answerTo(const test::ForeignFamily& family, const Diagnosis& diagnosis) {
  const auto& found = diagnosis.findings;
  if (found.empty()) {
    if (diagnosis.verdict == Verdict::nothingMissing)
      return family.conceals == test::Conceals::nothing ? right : nothingToSee(diagnosis.fit) ? hidden : nothing;
    if (diagnosis.verdict == Verdict::outsideCatalogue)
      return family.conceals == test::Conceals::physicsOutside ? right : outside;
    return undecided;
  }
  if (found.front().effect == family.name)
    return found.size() == 1 && diagnosis.verdict != Verdict::outsideCatalogue ? right : besides;
  const auto& rivals = found.front().ambiguousWith;
  return std::find(rivals.begin(), rivals.end(), family.name) != rivals.end() ? rival : wrong;
}

std::string toldBy(const Diagnosis& diagnosis) {
  std::string text = nameOf(diagnosis.verdict);
  for (const Finding& finding : diagnosis.findings) text += " " + finding.effect;
  return text;
}

void study(const test::ForeignFamily& family, std::uint64_t rigs, std::array<int, answers>& sum) {
  std::array<int, answers> count{};
  for (std::uint64_t seed = 1; seed <= rigs; ++seed) {
    const test::ForeignRig rig = test::foreignRig(family.name, seed);
    const auto diagnosis = diagnose(rig.bench, rig.recordings, {}, {});
    const Answer answer = diagnosis ? answerTo(family, *diagnosis) : undecided;
    ++count[answer];
    ++sum[answer];
    if (answer == right) continue;
    fmt::print(stderr, "  {} {}: {}; {}\n", family.name, seed,
               diagnosis ? toldBy(*diagnosis) : diagnosis.error().message(), rig.words);
  }
  fmt::print("| {} |", family.name);
  for (const int one : count) fmt::print(" {} |", one);
  fmt::print("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t rigs = 5;
  if (argc > 1) {
    const std::string_view text = argv[1];
    if (const auto read = std::from_chars(text.begin(), text.end(), rigs); read.ptr != text.end() || rigs == 0) {
      fmt::print(stderr, "rigs: expected how many rigs of a family, found \"{}\"\n", text);
      return 2;
    }
  }
  const std::vector<std::string_view> asked(argv + std::min(argc, 2), argv + argc);
  const auto& all = test::foreignFamilies();
  for (const std::string_view name : asked) {
    if (std::none_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; })) {
      fmt::print(stderr, "rigs: knows no family \"{}\"\n", name);
      return 2;
    }
  }
  fmt::print("| family |");
  for (const char* one : words) fmt::print(" {} |", one);
  fmt::print("\n|---|---|---|---|---|---|---|---|---|\n");
  for (const test::Conceals kind :
       {test::Conceals::nothing, test::Conceals::anEffect, test::Conceals::physicsOutside}) {
    std::array<int, answers> sum{};
    for (const test::ForeignFamily& family : all) {
      const bool wanted = asked.empty() || std::find(asked.begin(), asked.end(), family.name) != asked.end();
      if (family.conceals == kind && wanted) study(family, rigs, sum);
    }
    if (kind == test::Conceals::nothing || !asked.empty()) continue;
    fmt::print("| **{}** |", kind == test::Conceals::anEffect ? "effects" : "physics outside");
    for (const int one : sum) fmt::print(" {} |", one);
    fmt::print("\n");
  }
  return 0;
}
