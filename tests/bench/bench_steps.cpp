// Forward simulation: how many 50 µs steps the stepper makes per second, and how long SUNDIALS CVODE with root finding
// takes for the same motion at equal accuracy. Who is right where they part: a closed form in extended precision.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_types.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <vector>

#include "diagnose/simulate/stepper.h"
#include "support/known_servo.h"
#include "support/processor_time.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

constexpr double row_s = 1e-3, step_s = 5e-5;
constexpr size_t rows = 4000;
constexpr double targetMillions = 10.0, targetRatio = 10.0;

/// One position per row.
using Motion = std::vector<double>;

std::vector<CompiledTerm> threeTerms() {
  return {compiled("cogging", {0.002, 0.4, 12.0}), compiled("stribeck", {0.004, 1.5, 2.0}),
          compiled("viscous_asymmetry", {2e-5})};
}

/// Held over each row: two sines of 1.6 and 0.5 times `unit`, the Coulomb friction, so that the axis swings, stops and
/// stands.
std::vector<double> drive(double unit) {
  std::vector<double> u;
  for (size_t k = 0; k < rows; ++k) {
    const double t = static_cast<double>(k) * row_s;
    u.push_back(unit *
                (1.6 * std::sin(2.0 * std::numbers::pi * 2.3 * t) + 0.5 * std::sin(2.0 * std::numbers::pi * 0.37 * t)));
  }
  return u;
}

Motion stepped(const Physics& physics, const std::vector<CompiledTerm>& terms, const std::vector<double>& u,
               double step) {
  Stepper stepper(physics, terms);
  MotionState state;
  Motion motion;
  motion.reserve(rows);
  const int parts = static_cast<int>(std::lround(row_s / step));
  for (size_t k = 0; k < rows; ++k) {
    for (int part = 0; part < parts; ++part) {
      stepper.advance(state, u[k], step, static_cast<double>(k) * row_s + part * step);
    }
    motion.push_back(state.position);
  }
  return motion;
}

struct Exact {
  Motion motion;
  int standing = 0, reversals = 0;
};

/// The base model's closed form, event by event, in extended precision.
Exact closedForm(const Physics& p, const std::vector<double>& u) {
  using Long = long double;
  const Long J = p.inertia, B = p.viscous, F = p.coulomb, tau = J / B;
  Long x = 0, v = 0;
  Exact out;
  for (size_t k = 0; k < rows; ++k) {
    Long left = row_s;
    bool moved = false;
    while (left > 0) {
      const Long s = v > 0 ? 1 : v < 0 ? -1 : u[k] > 0 ? 1 : -1;
      if (v == 0 && std::abs(u[k]) <= p.coulomb) break;
      moved = true;
      const Long end = (u[k] - s * F) / B;  // the speed it tends to
      Long t = left;
      if (v != 0 && end * s < 0) t = std::min(left, tau * std::log1p(-v / end));
      const bool stops = t < left;
      x += end * t - (v - end) * tau * std::expm1(-t / tau);
      v = stops ? 0 : end + (v - end) * std::exp(-t / tau);
      out.reversals += stops;
      left -= t;
    }
    out.standing += !moved;
    out.motion.push_back(static_cast<double>(x));
  }
  return out;
}

void require(int flag, const char* what) {
  if (flag >= 0) return;
  std::fprintf(stderr, "%s failed: %d\n", what, flag);
  std::exit(1);
}

/// What CVODE integrates: y = (position, velocity) while sliding one way.
struct Sliding {
  const Physics& physics;
  const std::vector<CompiledTerm>& terms;
  double u = 0.0;
  double direction = 1.0;

  Term forces(double position, double velocity, double along) const {
    Term sum{0.0, physics.coulomb};
    Situation at;
    at.axis = physics.axis;
    at.position = position;
    at.velocity = velocity;
    at.driveTorque = u;
    at.direction = along;
    for (const CompiledTerm& term : terms) {
      const Term part = term.effect->term(term.parameters, at);
      sum.load_Nm += part.load_Nm;
      sum.friction_Nm += part.friction_Nm;
    }
    return sum;
  }
  static int rate(double, N_Vector y, N_Vector out, void* self) {
    const auto& s = *static_cast<const Sliding*>(self);
    const double x = NV_Ith_S(y, 0), v = NV_Ith_S(y, 1);
    const Term f = s.forces(x, v, s.direction);
    NV_Ith_S(out, 0) = v;
    NV_Ith_S(out, 1) = (s.u - s.physics.viscous * v - f.load_Nm - s.direction * f.friction_Nm) / s.physics.inertia;
    return 0;
  }
  static int stops(double, N_Vector y, double* g, void*) {
    g[0] = NV_Ith_S(y, 1);
    return 0;
  }
};

/// CVODE's Adams method with functional iteration (the motion is not stiff), stopped at every row, restarted where the
/// drive jumps; standing is a mode of its own.
Motion integrated(const Physics& physics, const std::vector<CompiledTerm>& terms, const std::vector<double>& u,
                  double relative) {
  Sliding sliding{physics, terms};
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  N_Vector y = N_VNew_Serial(2, context);
  NV_Ith_S(y, 0) = NV_Ith_S(y, 1) = 0.0;
  void* solver = CVodeCreate(CV_ADAMS, context);
  require(CVodeInit(solver, &Sliding::rate, 0.0, y), "CVodeInit");
  require(CVodeSStolerances(solver, relative, relative), "CVodeSStolerances");
  SUNNonlinearSolver iteration = SUNNonlinSol_FixedPoint(y, 0, context);
  require(CVodeSetNonlinearSolver(solver, iteration), "CVodeSetNonlinearSolver");
  require(CVodeSetUserData(solver, &sliding), "CVodeSetUserData");
  require(CVodeRootInit(solver, 1, &Sliding::stops), "CVodeRootInit");
  require(CVodeSetNoInactiveRootWarn(solver), "CVodeSetNoInactiveRootWarn");
  require(CVodeSetMaxNumSteps(solver, 100000), "CVodeSetMaxNumSteps");
  Motion motion;
  motion.reserve(rows);
  for (size_t k = 0; k < rows; ++k) {
    double now = static_cast<double>(k) * row_s;
    const double end = static_cast<double>(k + 1) * row_s;
    sliding.u = u[k];
    while (end - now > 1e-13) {
      const double x = NV_Ith_S(y, 0), v = NV_Ith_S(y, 1);
      if (v == 0.0) {
        const double push = u[k] - sliding.forces(x, 0.0, 0.0).load_Nm;
        sliding.direction = push > 0.0 ? 1.0 : -1.0;
        if (std::abs(push) <= sliding.forces(x, 0.0, sliding.direction).friction_Nm) break;
      } else {
        sliding.direction = v > 0.0 ? 1.0 : -1.0;
      }
      require(CVodeReInit(solver, now, y), "CVodeReInit");
      require(CVodeSetStopTime(solver, end), "CVodeSetStopTime");
      const int flag = CVode(solver, end, y, &now, CV_NORMAL);
      require(flag, "CVode");
      if (flag == CV_ROOT_RETURN) NV_Ith_S(y, 1) = 0.0;
    }
    motion.push_back(NV_Ith_S(y, 0));
  }
  CVodeFree(&solver);
  SUNNonlinSolFree(iteration);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return motion;
}

/// Root mean square difference, rad.
double difference(const Motion& a, const Motion& b) {
  double squares = 0.0;
  for (size_t k = 0; k < a.size(); ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

/// The shortest of five runs, in s of processor time.
double shortest_s(const std::function<Motion()>& job) {
  double best = INFINITY;
  for (int run = 0; run < 5; ++run) {
    const ProcessorTime time;
    if (!std::isfinite(job().back())) std::abort();
    best = std::min(best, time.elapsed_s());
  }
  return best;
}

bool speed(const char* name, const Physics& physics, const std::vector<CompiledTerm>& terms, double unit, bool must) {
  const auto u = drive(unit);
  const double millions = static_cast<double>(rows) * row_s / step_s /
                          shortest_s([&] { return stepped(physics, terms, u, step_s); }) * 1e-6;
  const bool met = millions >= targetMillions;
  std::printf("  %-28s %6.1f million steps/s", name, millions);
  if (must) std::printf("   target >= %.0f: %s", targetMillions, met ? "met" : "MISSED");
  std::printf("\n");
  return met || !must;
}

/// CVODE at falling tolerances against the stepper. Compared is the tightest tolerance that still errs at least as much
/// as the stepper, so that CVODE is never asked for more.
bool contest(const char* name, const Physics& physics, const std::vector<CompiledTerm>& terms, const Motion& truth,
             bool must) {
  const auto u = drive(physics.coulomb);
  const double own = difference(stepped(physics, terms, u, step_s), truth);
  const double own_s = shortest_s([&] { return stepped(physics, terms, u, step_s); });
  std::printf("%s: %.0f s of motion\n  %-28s error %.2e rad rms  %8.3f ms\n", name, static_cast<double>(rows) * row_s,
              "stepper, 50 us", own, own_s * 1e3);
  double ratio = 0.0;
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
    const double error = difference(integrated(physics, terms, u, tolerance), truth);
    const double time_s = shortest_s([&] { return integrated(physics, terms, u, tolerance); });
    std::printf("  CVODE, tolerance %.0e       error %.2e rad rms  %8.3f ms  %6.1f times the stepper's\n", tolerance,
                error, time_s * 1e3, time_s / own_s);
    if (error >= own) ratio = time_s / own_s;
  }
  const bool met = ratio >= targetRatio;
  std::printf("  the stepper is %.1f times faster where CVODE errs at least as much", ratio);
  if (must) std::printf("   target >= %.0f: %s", targetRatio, met ? "met" : "MISSED");
  std::printf("\n");
  return met || !must;
}

}  // namespace

int main() {
  const Physics base = torqueDriven(), coil = voltageDriven();
  const auto terms = threeTerms();
  std::printf("stepping, 50 us, one core, best of 5\n");
  bool met = speed("base model", base, {}, base.coulomb, true);
  met &= speed("with inductance", coil, {}, base.coulomb / coil.torqueConstant * coil.resistance, false);
  met &= speed("with three effects", base, terms, base.coulomb, false);

  const auto u = drive(base.coulomb);
  const Exact exact = closedForm(base, u);
  std::printf("\nthe drive makes %d stops, and %d of %zu rows stand still\n", exact.reversals, exact.standing, rows);
  met &= contest("base model, against the closed form", base, {}, exact.motion, true);

  const Motion reference = integrated(base, terms, u, 1e-13);
  met &= contest("three effects, against CVODE at 1e-13", base, terms, reference, false);
  const double fine = difference(stepped(base, terms, u, step_s / 4.0), reference),
               finer = difference(stepped(base, terms, u, step_s / 16.0), reference);
  std::printf("  stepper at 12.5 us errs by %.2e, at 3.125 us by %.2e rad rms\n", fine, finer);
  return met ? 0 : 1;
}
