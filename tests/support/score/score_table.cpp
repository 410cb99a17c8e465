// The figures of a score as Markdown.
#include <fmt/core.h>
#include <functional>

#include "base/distributions.h"
#include "base/statistics.h"
#include "score/scoring.h"

namespace breakaway {

namespace {

std::string percent(const Share& share) {
  if (share.runs == 0) return "–";
  return fmt::format("{:.1f} % ({} of {})", 100.0 * share.value(), share.hits, share.runs);
}

/// "–" for no values.
std::string quantileText(const std::vector<double>& values, double fraction, double unit = 1.0) {
  return values.empty() ? "–" : fmt::format("{:.2f}", quantile(values, fraction) / unit);
}

/// "–" for a ratio of nothing.
std::string ratioText(double above, double below) {
  return below > 0.0 ? fmt::format("{:.2f}", above / below) : "–";
}

std::string falseAlarms(const Score& score) {
  if (score.falseAlarms.runs == 0) return "–";
  return percent(score.falseAlarms) + fmt::format(", 95 % sure below {:.1f} %",
                                                  100.0 * upperBound95(score.falseAlarms.hits, score.falseAlarms.runs));
}

std::string sizeText(const SizeBin& bin) {
  if (bin.from <= 0.0) return fmt::format("below {:g}", bin.to);
  if (bin.to >= 1e300) return fmt::format("{:g} and above", bin.from);
  return fmt::format("{:g} to {:g}", bin.from, bin.to);
}

struct Line {
  std::string words;
  std::function<std::string(const Score&)> value;
};

std::vector<Line> linesFor(const Score& first) {
  std::vector<Line> lines{
      {"first name right, one effect, identifiable", [](const Score& s) { return percent(s.firstName); }},
      {"top two, the same", [](const Score& s) { return percent(s.topTwo); }},
      {"first name right, any number of effects, identifiable", [](const Score& s) { return percent(s.firstNameAll); }},
      {"F1 on identifiable combinations",
       [](const Score& s) {
         const bool any = s.truePositives + s.falsePositives + s.falseNegatives > 0;
         return any ? fmt::format("{:.2f}", s.f1()) : "–";
       }},
      {"wrong extras per run",
       [](const Score& s) { return ratioText(static_cast<double>(s.wrongExtras), static_cast<double>(s.runs)); }},
      {"false alarms on clean plants", falseAlarms},
      {"outside the catalogue: flagged", [](const Score& s) { return percent(s.outsideFlagged); }},
      {"outside the catalogue: wrongly named", [](const Score& s) { return percent(s.outsideNamed); }},
      {"masked: a wrong name", [](const Score& s) { return percent(s.wrongMasked); }},
      {"weak: a wrong name", [](const Score& s) { return percent(s.wrongWeak); }},
      {"noisy: a wrong name", [](const Score& s) { return percent(s.wrongNoisy); }},
      {"low excitation: a wrong name", [](const Score& s) { return percent(s.wrongLow); }},
  };
  for (size_t k = 0; k < first.recall.size(); ++k) {
    lines.push_back({"recall, base error over floor " + sizeText(first.recall[k]),
                     [k](const Score& s) { return percent(s.recall[k].found); }});
  }
  lines.insert(
      lines.end(),
      {{"part of the achievable gain, median", [](const Score& s) { return quantileText(s.achieved, 0.5); }},
       {"part of the achievable gain, 10th percentile", [](const Score& s) { return quantileText(s.achieved, 0.1); }},
       {"error of the amplitude, median, %", [](const Score& s) { return quantileText(s.amplitudeErrors, 0.5, 0.01); }},
       {"truth within its 95 % interval", [](const Score& s) { return percent(s.covered); }},
       {"named, median, s", [](const Score& s) { return quantileText(s.named_s, 0.5); }},
       {"proved, median, s", [](const Score& s) { return quantileText(s.elapsed_s, 0.5); }},
       {"first names are the final ones", [](const Score& s) { return percent(s.agreement); }}});
  return lines;
}

const char* nameOf(Method method) {
  switch (method) {
    case Method::diagnosis:
      return "Breakaway";
    case Method::stepwise:
      return "stepwise, BIC";
    case Method::thresholded:
      return "thresholded (SINDy)";
  }
  return "";
}

}  // namespace

std::string familyTable(const Score& score) {
  std::string out =
      "| family | runs | identifiable | first right | top two | ambiguous | nothing missing | outside | wrong "
      "extras/run "
      "| failed |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const FamilyScore& one : score.families) {
    const std::string extras = ratioText(static_cast<double>(one.wrongExtras), static_cast<double>(one.runs));
    out += "| " + one.family +
           fmt::format(" | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", one.runs, one.identifiable, one.firstRight,
                       one.topTwo, one.ambiguous, one.nothingMissing, one.outside, extras, one.failed);
  }
  return out;
}

std::string totalsTable(const std::vector<Score>& scores) {
  if (scores.empty()) return {};
  std::string out = "| figure |", rule = "|---|";
  for (const Score& score : scores) {
    out += std::string(" ") + nameOf(score.method) + " |";
    rule += "---|";
  }
  out += "\n" + rule + "\n";
  for (const Line& line : linesFor(scores.front())) {
    out += "| " + line.words + " |";
    for (const Score& score : scores) out += " " + line.value(score) + " |";
    out += "\n";
  }
  return out;
}

}  // namespace breakaway
