// What diagnose says of other people's rigs: a plant that it shares nothing with, one piece of physics concealed.
// ./dev bench rigs [RIGS [FAMILY…]], RIGS: how many of each family, or which (41-42)
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

void study(const test::ForeignFamily& family, std::pair<std::uint64_t, std::uint64_t> rigs,
           std::array<int, answers>& sum) {
  std::array<int, answers> count{};
  for (std::uint64_t seed = rigs.first; seed <= rigs.second; ++seed) {
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

/// "5": rigs 1 to 5 of each family; "41-42": these.
std::optional<std::pair<std::uint64_t, std::uint64_t>> rigsFrom(std::string_view text) {
  std::uint64_t first = 1, last = 0;
  auto read = std::from_chars(text.begin(), text.end(), last);
  if (read.ec == std::errc() && read.ptr != text.end() && *read.ptr == '-') {
    first = last;
    read = std::from_chars(read.ptr + 1, text.end(), last);
  }
  if (read.ec != std::errc() || read.ptr != text.end() || first == 0 || last < first) return std::nullopt;
  return std::pair{first, last};
}

}  // namespace

int main(int argc, char** argv) {
  const auto rigs = rigsFrom(argc > 1 ? argv[1] : "5");
  if (!rigs) {
    fmt::print(stderr, "rigs: expected how many rigs of a family, or which, such as 41-42, found \"{}\"\n", argv[1]);
    return 2;
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
      if (family.conceals == kind && wanted) study(family, *rigs, sum);
    }
    if (kind == test::Conceals::nothing || !asked.empty()) continue;
    fmt::print("| **{}** |", kind == test::Conceals::anEffect ? "effects" : "physics outside");
    for (const int one : sum) fmt::print(" {} |", one);
    fmt::print("\n");
  }
  return 0;
}
