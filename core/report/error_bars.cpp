#include "report/error_bars.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/html_report.h"
#include "draw/svg_canvas.h"

namespace breakaway {

namespace {

constexpr int floorColour = 2, rivalColour = 5;

int barColour(ErrorBar::Of of) {
  return of == ErrorBar::Of::base    ? beforeColour
         : of == ErrorBar::Of::found ? afterColour
         : of == ErrorBar::Of::floor ? floorColour
                                     : rivalColour;
}

/// One beneath the other, each with its interval as a line; the floor as a line through all of them.
std::string barsSvg(const Message& title, const std::vector<ErrorBar>& bars, double floor, const Shown& shown,
                    const Catalogue& language) {
  constexpr int width = 860;
  constexpr double left = 250.0, right = 720.0, row = 30.0, top = 52.0, whisker = 5.0;
  double most = 1e-300;
  for (const ErrorBar& bar : bars) most = std::max({most, bar.error, bar.interval ? bar.interval->high : 0.0});
  const auto at = [&](double error) { return left + (right - left) * std::min(error / most, 1.0); };
  const auto height = static_cast<int>(top + row * static_cast<double>(bars.size()) + 12.0);
  SvgCanvas canvas(width, height, title.in(language));
  canvas.text(0.5 * width, 24.0, title.in(language), SvgCanvas::Anchor::middle, Ink::text, 15.0, true);
  for (size_t k = 0; k < bars.size(); ++k) {
    const ErrorBar& bar = bars[k];
    const double y = top + row * static_cast<double>(k);
    double end = at(bar.error);
    const double cap = std::min(8.0, 0.5 * (end - left));  // ends are round
    canvas.text(left - 10.0, y + 4.0, bar.name.in(language), SvgCanvas::Anchor::end, Ink::text, 13.0);
    canvas.curve("M" + px(left + cap) + " " + px(y) + "H" + px(std::max(end - cap, left + cap + 0.01)),
                 Curve{.label = {}, .x = {}, .y = {}, .width_px = 2.0 * cap}, barColour(bar.of));
    if (bar.interval) {
      const double from = at(bar.interval->low), to = at(bar.interval->high);
      canvas.line(from, y, to, y, Ink::text, 1.4);
      for (const double x : {from, to}) canvas.line(x, y - whisker, x, y + whisker, Ink::text, 1.4);
      end = std::max(end, to);
    }
    canvas.text(end + 14.0, y + 4.0, numberText(shown.scale * bar.error, 3) + " " + shown.unit,
                SvgCanvas::Anchor::start, Ink::text, 13.0);
  }
  canvas.line(at(floor), top - 14.0, at(floor), top + row * static_cast<double>(bars.size()) - 14.0, Ink::faintText);
  return canvas.finish();
}

double floorHere(const FitScore& fit) {
  return fit.floorWithWander > 0.0 ? fit.floorWithWander : fit.floor;
}

}  // namespace

Shown shownIn(Axis axis) {
  return axis == Axis::rotary ? Shown{180.0 / std::numbers::pi, "°"} : Shown{1e3, "mm"};
}

Shown leftIn(Axis axis) {
  return axis == Axis::rotary ? Shown{1e3, "mNm"} : Shown{1.0, "N"};
}

Shown scoredIn(const Diagnosis& d) {
  return d.fit.inTorque() ? leftIn(d.model.axis) : shownIn(d.model.axis);
}

std::vector<ErrorBar> rivalBars(const Diagnosis& d, const Finding& finding) {
  using Of = ErrorBar::Of;
  std::vector<ErrorBar> bars{{Of::found, nameOfEffect(finding.effect), d.fit.heldoutAfter, d.fit.after95}};
  for (const RivalScore& one : finding.rivals)
    bars.push_back({Of::rival, nameOfEffect(one.effect), one.error, Interval{one.low95, one.high95}, &one});
  bars.push_back({Of::base, message(beforeLabel), d.fit.heldoutBefore, d.fit.before95});
  bars.push_back({Of::floor, message("a perfect model"), floorHere(d.fit)});
  return bars;
}

Message rivalSentence(const Finding& finding) {
  if (finding.rivals.empty()) {
    if (finding.ambiguousWith.empty()) return message("No other effect came near enough to be fitted in its place.");
    return realRival(finding) != nullptr ? message("What it can't be told from wasn't fitted in its place.")
                                         : message("What it can't be told from errs as it does, and wasn't fitted.");
  }
  std::vector<Message> alike;
  const RivalScore* nearest = nullptr;
  for (const RivalScore& one : finding.rivals) {
    if (errsAlike(one)) alike.push_back(nameOfEffect(one.effect));
    if (!errsAlike(one) && (nearest == nullptr || one.ratio < nearest->ratio)) nearest = &one;
  }
  if (!alike.empty())
    return message("Held-out data can't tell it from {}: the difference of their errors may be none.",
                   listed(alike, message(" or ")));
  return message("The nearest other name, {}, errs {} times as much on held-out data (95 % interval {} to {}).",
                 nameOfEffect(nearest->effect), numberText(nearest->ratio, 3), numberText(nearest->ratioLow95, 3),
                 numberText(nearest->ratioHigh95, 3));
}

std::string rivalsSvg(const Diagnosis& d, const Finding& finding, const Catalogue& language) {
  return barsSvg(message("Error on held-out data, with others in its place"), rivalBars(d, finding), floorHere(d.fit),
                 scoredIn(d), language);
}

std::string gainSvg(const Diagnosis& d, const Catalogue& language) {
  using Of = ErrorBar::Of;
  std::vector<ErrorBar> bars{
      {Of::base, message("held out, {}", message(beforeLabel)), d.fit.heldoutBefore, d.fit.before95}};
  if (!d.findings.empty())
    bars.push_back({Of::found, message("held out, {}", message(afterLabel)), d.fit.heldoutAfter, d.fit.after95});
  bars.push_back({Of::base, message("training, {}", message(beforeLabel)), d.fit.trainBefore});
  if (!d.findings.empty()) bars.push_back({Of::found, message("training, {}", message(afterLabel)), d.fit.trainAfter});
  bars.push_back({Of::floor, message("a perfect model"), d.fit.floor});
  return barsSvg(message("Error over {} s windows, rms", numberText(d.fit.window_s, 2)), bars, d.fit.floor, scoredIn(d),
                 language);
}

}  // namespace breakaway
