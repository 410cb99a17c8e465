#include "report/tuning_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "draw/html_report.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double degrees = 180.0 / std::numbers::pi;
constexpr int grey = 6;

void append(Curve& curve, const Complex& point) {
  curve.x.push_back(point.real());
  curve.y.push_back(point.imag());
}

/// z on the unit circle, and along ζ = 0.707 where s = ωn·(−ζ ± j·√(1 − ζ²)).
Curve unitCircle() {
  Curve circle{"unit circle", {}, {}};
  for (int k = 0; k <= 180; ++k) append(circle, std::polar(1.0, turn_rad * k / 180));
  circle.style = Curve::Style::dashed;
  circle.colour = grey;
  return circle;
}

Curve dampingLine() {
  Curve line{"damping 0.707", {}, {}};
  for (int k = -100; k <= 100; ++k) {
    const double angle = 0.99 * std::numbers::pi * k / 100;
    append(line, std::polar(std::exp(-std::abs(angle)), angle));
  }
  line.style = Curve::Style::dashed;
  line.colour = 3;
  return line;
}

Curve marked(const std::string& label, const std::vector<Complex>& points, int colour) {
  Curve marks{label, {}, {}};
  for (const Complex& one : points) append(marks, one);
  marks.style = Curve::Style::points;
  marks.colour = colour;
  marks.width_px = 4.0;
  return marks;
}

std::vector<Complex> slow(std::vector<Complex> all, double tick_s) {
  std::erase_if(all, [](const Complex& z) { return std::abs(z) < 1e-6; });
  for (Complex& z : all) z = std::log(z) / tick_s;
  return all;
}

/// Arrow heads along a branch, `size` long and so far apart at least, within the window; one curve with gaps.
Curve arrowsAlong(const Curve& branch, double size, const std::pair<double, double>& xRange,
                  const std::pair<double, double>& yRange) {
  constexpr double apart = 7.0, opening = 2.6;  // of their size; rad between shaft and barb
  Curve arrows{{}, {}, {}};
  const auto point = [&arrows](double x, double y) {
    arrows.x.push_back(x);
    arrows.y.push_back(y);
  };
  double gone = 0.5 * apart * size;
  for (size_t k = 1; k < branch.x.size(); ++k) {
    const double x = branch.x[k], y = branch.y[k], dx = x - branch.x[k - 1], dy = y - branch.y[k - 1];
    const double step = std::hypot(dx, dy);
    if (!(step > 0.0) || step > apart * size) continue;  // a gap, or a pole that jumps over the window
    gone += step;
    const bool within = x > xRange.first && x < xRange.second && y > yRange.first && y < yRange.second;
    if (gone < apart * size || !within) continue;
    gone = 0.0;
    const double way = std::atan2(dy, dx);
    point(x + size * std::cos(way + opening), y + size * std::sin(way + opening));
    point(x, y);
    point(x + size * std::cos(way - opening), y + size * std::sin(way - opening));
    point(NAN, NAN);
  }
  arrows.colour = branch.colour;
  arrows.width_px = 2.0;
  return arrows;
}

Curve magnitude(const std::string& label, const LoopResponse& response, const std::vector<Complex>& values) {
  Curve curve{label, response.frequency_rad_per_s, {}};
  for (const Complex& one : values) curve.y.push_back(std::abs(one));
  return curve;
}

Curve phase(const std::string& label, const LoopResponse& response) {
  Curve curve{label, response.frequency_rad_per_s, {}};
  double turns = 0.0, last = 0.0;
  for (size_t k = 0; k < response.loop.size(); ++k) {
    const double angle = std::arg(response.loop[k]);
    if (k > 0) turns += std::round((last - angle) / turn_rad);
    if (k == 0 && angle > 0.0) turns = -1.0;  // integrators begin at −90° or below
    last = angle;
    curve.y.push_back(degrees * (angle + turn_rad * turns));
  }
  return curve;
}

std::string atCutoff(const ServoLoop& loop) {
  return "at g = " + numberText(loop.settings.observer_cutoff_rad_per_s, 3) + " rad/s";
}

}  // namespace

Figure rootLocusFigure(const ServoLoop& loop, const RootLocus& locus) {
  Figure figure{"Root locus over the observer's cutoff, z plane", "real part", "imaginary part"};
  figure.equalScale = true;
  figure.curves = {unitCircle(), dampingLine()};
  for (const auto& branch : locus.branches) {
    Curve curve{{}, {}, {}};
    for (const Complex& one : branch) append(curve, one);
    curve.colour = 0;
    figure.curves.push_back(std::move(curve));
  }
  figure.curves.push_back(marked(atCutoff(loop), poles(closedLoop(loop)), 1));
  return figure;
}

Figure slowPolesFigure(const ServoLoop& loop, const RootLocus& locus) {
  const double T = loop.board.tick_s, reach = 4.0 * std::max(loop.settings.observer_cutoff_rad_per_s, 100.0);
  Figure figure{"Root locus over the observer's cutoff, s = ln(z)/T", "real part / rad/s", "imaginary part / rad/s"};
  figure.equalScale = true;
  figure.xRange = std::pair(-1.5 * reach, 0.5 * reach);
  figure.yRange = std::pair(-reach, reach);
  Curve line{"damping 0.707", {-reach, 0.0, -reach}, {-reach, 0.0, reach}};
  line.style = Curve::Style::dashed;
  line.colour = 3;
  Curve axis{"limit of stability", {0.0, 0.0}, {-reach, reach}};
  axis.style = Curve::Style::dashed;
  axis.colour = grey;
  figure.curves = {axis, line};
  for (const auto& branch : locus.branches) {
    Curve curve{{}, {}, {}};
    for (const Complex& one : branch) {
      const Complex s = std::abs(one) > 1e-6 ? std::log(one) / T : Complex(NAN, NAN);
      append(curve, s.imag() > -3.1 / T ? s : Complex(NAN, NAN));
    }
    curve.colour = 0;
    Curve arrows = arrowsAlong(curve, 0.045 * reach, *figure.xRange, *figure.yRange);
    figure.curves.push_back(std::move(curve));
    if (!arrows.x.empty()) figure.curves.push_back(std::move(arrows));
  }
  figure.curves.push_back(marked(atCutoff(loop), slow(poles(closedLoop(loop)), T), 1));
  return figure;
}

Figure gainFigure(const TuningStudy& study) {
  Figure figure{"Loop gain", "frequency / rad/s", "|L|"};
  figure.logX = figure.logY = true;
  figure.curves = {magnitude("velocity loop", study.velocity, study.velocity.loop),
                   magnitude("position loop", study.position, study.position.loop)};
  return figure;
}

Figure phaseFigure(const TuningStudy& study) {
  Figure figure{"Loop phase", "frequency / rad/s", "phase of L / °"};
  figure.logX = true;
  figure.curves = {phase("velocity loop", study.velocity), phase("position loop", study.position)};
  return figure;
}

Figure sensitivityFigure(const TuningStudy& study) {
  Figure figure{"Sensitivity of the velocity loop", "frequency / rad/s", "magnitude"};
  figure.logX = true;
  figure.curves = {magnitude("|S|", study.velocity, study.velocity.sensitivity),
                   magnitude("|L/(1 + L)|", study.velocity, study.velocity.complementary)};
  const double most = study.tuning.wanted.peakSensitivity;
  Curve bound{"most that |S| may be",
              {study.velocity.frequency_rad_per_s.front(), study.velocity.frequency_rad_per_s.back()},
              {most, most}};
  bound.style = Curve::Style::dashed;
  figure.curves.push_back(std::move(bound));
  return figure;
}

Figure loadFigure(const TuningStudy& study) {
  const bool linear = study.axis == Axis::linear;
  Figure figure{linear ? "How the axis yields to a load" : "How the shaft yields to a load", "frequency / rad/s",
                linear ? "speed per load / m/s per kN" : "speed per load / rad/s per mNm"};
  figure.logX = figure.logY = true;
  const double perUnit = linear ? 1e3 : 1e-3;
  const auto scaled = [&study, perUnit](const std::string& label, const ClosedResponse& closed) {
    Curve curve = magnitude(label, study.velocity, closed.yielding);
    for (double& one : curve.y) one *= perUnit;
    return curve;
  };
  figure.curves = {scaled("velocity loop", study.velocityClosed), scaled("position loop", study.positionClosed)};
  return figure;
}

Figure noiseFigure(const TuningStudy& study) {
  Figure figure{
      "What a cutoff costs", "observer cutoff g / rad/s",
      study.axis == Axis::linear ? "noise of the force estimate, rms / mN" : "noise of the torque estimate, rms / mNm"};
  figure.logX = figure.logY = true;
  Curve both{"encoder and current sensor", study.cutoffs_rad_per_s, {}},
      encoder{"encoder alone", study.cutoffs_rad_per_s, {}};
  for (const LoopNoise& one : study.noise) {
    both.y.push_back(1e3 * one.estimate_Nm);
    encoder.y.push_back(1e3 * one.estimateByEncoder_Nm);
  }
  encoder.style = Curve::Style::dashed;
  Curve chosen{"chosen", {study.loop.settings.observer_cutoff_rad_per_s}, {1e3 * study.tuning.noise.estimate_Nm}};
  chosen.style = Curve::Style::points;
  chosen.width_px = 4.0;
  figure.curves = {both, encoder, chosen};
  return figure;
}

namespace {

/// A vertical line where a bandwidth was chosen, over the heights of a curve.
Curve chosenAt(double bandwidth_rad_per_s, const Curve& over) {
  double low = HUGE_VAL, high = 0.0;
  for (const double y : over.y) {
    if (!std::isfinite(y)) continue;
    low = std::min(low, y);
    high = std::max(high, y);
  }
  Curve line{"in use", {bandwidth_rad_per_s, bandwidth_rad_per_s}, {low, high}};
  line.style = Curve::Style::dashed;
  line.colour = grey;
  return line;
}

}  // namespace

Figure speedObserverFigure(const InnerLoops& inner, bool linear) {
  Figure figure{
      "What a faster speed observer gives and costs", "bandwidth of the speed observer / rad/s",
      linear ? "noise / mA, and speed per load / m/s per kN" : "noise / mA, and speed per load / rad/s per Nm"};
  figure.logX = figure.logY = true;
  Curve noise{"current's noise, rms / mA", {}, {}},
      yielding{linear ? "speed per load / m/s per kN" : "speed per load / rad/s per Nm", {}, {}};
  for (const SpeedObserverRow& row : inner.observerRows) {
    if (!(row.loopBandwidth_rad_per_s > 0.0)) continue;
    noise.x.push_back(row.bandwidth_rad_per_s);
    noise.y.push_back(1e3 * row.noise.currentReference_A);
    yielding.x.push_back(row.bandwidth_rad_per_s);
    yielding.y.push_back((linear ? 1e3 : 1.0) * row.yielding_rad_per_s_per_Nm);
  }
  figure.curves = {noise, yielding, chosenAt(inner.observer.bandwidth_rad_per_s, noise)};
  return figure;
}

Figure currentLoopFigure(const InnerLoops& inner) {
  Figure figure{"What a faster current loop costs", "bandwidth of the current loop / rad/s",
                "noise that the sensor makes, rms / mA and mV"};
  figure.logX = figure.logY = true;
  Curve current{"in the winding / mA", {}, {}}, voltage{"at the bridge / mV", {}, {}};
  for (const CurrentLoopRow& row : inner.currentRows) {
    if (!std::isfinite(row.current_A)) continue;
    current.x.push_back(row.bandwidth_rad_per_s);
    current.y.push_back(1e3 * row.current_A);
    voltage.x.push_back(row.bandwidth_rad_per_s);
    voltage.y.push_back(1e3 * row.voltage_V);
  }
  figure.curves = {current, voltage, chosenAt(inner.current.bandwidth_rad_per_s, current)};
  return figure;
}

}  // namespace breakaway
