#include "export/motion_text.h"

namespace breakaway {

namespace {

const char* const common = R"(
/// -1, 0 or 1.
function way_of(x) -> value { value = x > 0 ? 1 : (x < 0 ? -1 : 0); }
function clamp(x, low, high) -> value { value = min(max(x, low), high); }
/// The velocity in the middle of a step that goes in one direction.
function middle_velocity(s, direction, dt_s) -> middle {
  middle = s.velocity + 0.5 * dt_s * s.acceleration;
  if (middle * direction < 0) { middle = 0; }
}
/// log(1 + x), for small x too.
function log_one_plus(x) -> value {
  value = abs(x) < 0.001 ? x * (1 - x * (0.5 - x * (1 / 3.0 - x * (0.25 - x / 5)))) : log(1 + x);
}
/// Exact motion under a constant push over dt_s: what is left of the velocity, and what a unit of acceleration adds to
/// velocity and place.
function decay(dt_s, damping) -> keeps, adds_velocity, adds_place {
  z = damping * dt_s / inertia;
  keeps = exp(-z);
  first = 1 - z / 2 + z * z / 6 - z * z * z / 24 + z * z * z * z / 120;
  second = 0.5 - z / 6 + z * z / 24 - z * z * z / 120 + z * z * z * z / 720;
  if (abs(z) > 0.01) {
    first = (1 - keeps) / z;
    second = (1 - first) / z;
  }
  adds_velocity = dt_s * first;
  adds_place = dt_s * dt_s * second;
}
)";

const char* const elasticFriction = R"(
/// Friction that builds up over a way, as a part of the full one (Dahl 1976).
function slip_after(slip, way, full) -> after {
  after = slip;
  if (way != 0 && full > 0) {
    side = way_of(way);
    after = side - (side - slip) * exp(-abs(way) * slip_stiffness / full);
  }
}
/// Load and friction over a step, friction as far as it has built up, with its damping (Canudas de Wit 1995).
function elastic_load(s, drive, damping, dt_s, time_s) -> load {
  middle = middle_velocity(s, s.way, dt_s);
  place = s.position + 0.25 * dt_s * (s.velocity + middle);
  drive_there = drive - (damping - viscous) * middle;
  full = friction_limit(s, place, middle, s.way, drive_there, time_s + 0.5 * dt_s, middle * dt_s);
  load = load_torque(s, place, middle, s.way, drive_there, time_s + 0.5 * dt_s, middle * dt_s);
  slip = slip_after(s.slip, 0.5 * dt_s * s.velocity, full);
  load = load + full * slip + slip_damping * (middle - abs(middle) * slip);
}
)";

const char* const elasticMechanical = R"(
/// One step under a constant drive.
function move(&s, drive, damping, dt_s, time_s) {
  (keeps, adds_velocity, adds_place) = decay(dt_s, damping);
  acceleration = (drive - elastic_load(s, drive, damping, dt_s, time_s)) / inertia;
  velocity = s.velocity * keeps + acceleration * adds_velocity;
  s.position = s.position + s.velocity * adds_velocity + acceleration * adds_place;
  s.acceleration = (velocity - s.velocity) / dt_s;
  s.velocity = velocity;
}
)";

const char* const rigidMechanical = R"(
/// One step under a constant drive. It stops exactly, stands while friction holds, and starts when it no longer does.
function move(&s, drive, damping, dt_s, time_s) {
  left_s = dt_s;
  event = 0;
  while (event < 8 && left_s > 0) {
    event = event + 1;
    now_s = time_s + dt_s - left_s;
    direction = way_of(s.velocity);
    if (direction == 0) {
      push = drive - load_torque(s, s.position, 0, 0, drive, now_s, 0);
      direction = way_of(push);
      if (direction == 0) { return; }
      if (abs(push) <= friction_limit(s, s.position, 0, direction, drive, now_s, 0)) { return; }
    }
    middle = middle_velocity(s, direction, left_s);
    place = s.position + 0.25 * left_s * (s.velocity + middle);
    drive_there = drive - (damping - viscous) * middle;
    load = load_torque(s, place, middle, direction, drive_there, now_s + 0.5 * left_s, middle * left_s);
    full = friction_limit(s, place, middle, direction, drive_there, now_s + 0.5 * left_s, middle * left_s);
    acceleration = (drive - load - direction * full) / inertia;
    (keeps, adds_velocity, adds_place) = decay(left_s, damping);
    velocity = s.velocity * keeps + acceleration * adds_velocity;
    if (velocity * direction >= 0) {
      if (velocity == 0 && s.velocity == 0) { return; }
      s.position = s.position + s.velocity * adds_velocity + acceleration * adds_place;
      s.acceleration = (velocity - s.velocity) / left_s;
      s.velocity = velocity;
      return;
    }
    if (s.velocity == 0) { return; }
    rate = damping / inertia;
    stop_s = -s.velocity / acceleration;
    if (rate > 1e-12) { stop_s = log_one_plus(-s.velocity * rate / acceleration) / rate; }
    stop_s = clamp(stop_s, 0, left_s);
    (keeps, adds_velocity, adds_place) = decay(stop_s, damping);
    s.position = s.position + s.velocity * adds_velocity + acceleration * adds_place;
    s.velocity = 0;
    s.acceleration = 0;
    left_s = left_s - stop_s;
  }
}
)";

const char* const coupled = R"(
/// Exact motion of current and velocity together: what each is after dt_s per what each was, and the way per each.
function coupled(dt_s) -> ii, iv, vi, vv, xi, xv {
  a = -resistance / inductance;
  b = -back_emf / inductance;
  c = torque_constant / inertia;
  d = -viscous / inertia;
  mean = 0.5 * (a + d);
  half = 0.5 * (a - d);
  q = half * half + b * c;
  root = sqrt(abs(q));
  z = root * dt_s;
  even = exp(mean * dt_s);
  odd = even * dt_s;
  if (q > 0 && z > 0.000001) {
    odd = 0.5 * (exp((mean + root) * dt_s) - exp((mean - root) * dt_s)) / root;
    even = 0.5 * (exp((mean + root) * dt_s) + exp((mean - root) * dt_s));
  } else if (q < 0 && z > 0.000001) {
    odd = even * sin(z) / root;
    even = even * cos(z);
  }
  ii = even + odd * half;
  iv = odd * b;
  vi = odd * c;
  vv = even - odd * half;
  xi = (-c * (ii - 1) + a * vi) / (a * d - b * c);
  xv = (-c * iv + a * (vv - 1)) / (a * d - b * c);
}
)";

const char* const elasticInductive = R"(
/// One step under a constant voltage.
function move_wound(&s, volts, dt_s, time_s) {
  load = elastic_load(s, torque_constant * s.current, viscous, dt_s, time_s);
  last_v = (torque_constant * volts / resistance - load) / (viscous + torque_constant * back_emf / resistance);
  last_i = (volts - back_emf * last_v) / resistance;
  (ii, iv, vi, vv, xi, xv) = coupled(dt_s);
  i0 = s.current - last_i;
  v0 = s.velocity - last_v;
  s.acceleration = (last_v + vi * i0 + vv * v0 - s.velocity) / dt_s;
  s.position = s.position + last_v * dt_s + xi * i0 + xv * v0;
  s.current = last_i + ii * i0 + iv * v0;
  s.velocity = last_v + vi * i0 + vv * v0;
}
)";

const char* const rigidInductive = R"(
/// When standstill ends within dt_s, and which way.
function breakaway(s, volts, dt_s, time_s) -> wait_s, direction {
  drive = torque_constant * s.current;
  load = load_torque(s, s.position, 0, 0, drive, time_s, 0);
  wait_s = dt_s;
  direction = way_of(drive - load);
  held = 1;
  if (direction != 0) {
    if (abs(drive - load) > friction_limit(s, s.position, 0, direction, drive, time_s, 0)) { held = 0; }
  }
  if (held == 0) {
    wait_s = 0;
  } else {
    settled = volts / resistance;
    last = settled + (s.current - settled) * exp(-resistance / inductance * dt_s);
    direction = way_of(torque_constant * last - load);
    if (direction != 0) {
      full = friction_limit(s, s.position, 0, direction, torque_constant * last, time_s, 0);
      if (direction * (torque_constant * last - load) > full) {
        ratio = ((load + direction * full) / torque_constant - settled) / (s.current - settled);
        wait_s = clamp(-log(max(ratio, 1e-300)) * inductance / resistance, 0, dt_s);
      }
    }
  }
}
/// When the velocity is zero within dt_s, by false position.
function reversal(i0, v0, last_v, before, after, dt_s) -> stop_s {
  low = 0;
  at_low = before;
  high = dt_s;
  at_high = after;
  kept = 0;
  k = 0;
  while (k < 60 && high - low > 1e-12 * dt_s) {
    k = k + 1;
    here = (low * at_high - high * at_low) / (at_high - at_low);
    (ii, iv, vi, vv, xi, xv) = coupled(here);
    value = last_v + vi * i0 + vv * v0;
    if (value == 0) {
      low = here;
      high = here;
    } else if (value * at_high > 0) {
      high = here;
      at_high = value;
      if (kept == -1) { at_low = 0.5 * at_low; }
      kept = -1;
    } else {
      low = here;
      at_low = value;
      if (kept == 1) { at_high = 0.5 * at_high; }
      kept = 1;
    }
  }
  stop_s = 0.5 * (low + high);
}
/// One step under a constant voltage. It stops exactly, stands while friction holds, and starts when it no longer does.
function move_wound(&s, volts, dt_s, time_s) {
  left_s = dt_s;
  event = 0;
  settled = volts / resistance;
  while (event < 8 && left_s > 0) {
    event = event + 1;
    now_s = time_s + dt_s - left_s;
    direction = way_of(s.velocity);
    if (direction == 0) {
      (wait_s, direction) = breakaway(s, volts, left_s, now_s);
      s.current = settled + (s.current - settled) * exp(-resistance / inductance * wait_s);
      left_s = left_s - wait_s;
      if (left_s <= 1e-12 * dt_s) { return; }
    }
    drive = torque_constant * s.current;
    middle = middle_velocity(s, direction, left_s);
    place = s.position + 0.25 * left_s * (s.velocity + middle);
    load = load_torque(s, place, middle, direction, drive, now_s + 0.5 * left_s, middle * left_s);
    full = friction_limit(s, place, middle, direction, drive, now_s + 0.5 * left_s, middle * left_s);
    last_v = (torque_constant * settled - load - direction * full) /
             (viscous + torque_constant * back_emf / resistance);
    last_i = (volts - back_emf * last_v) / resistance;
    i0 = s.current - last_i;
    v0 = s.velocity - last_v;
    (ii, iv, vi, vv, xi, xv) = coupled(left_s);
    velocity = last_v + vi * i0 + vv * v0;
    if (velocity * direction >= 0) {
      s.acceleration = (velocity - s.velocity) / left_s;
      s.position = s.position + last_v * left_s + xi * i0 + xv * v0;
      s.current = last_i + ii * i0 + iv * v0;
      s.velocity = velocity;
      return;
    }
    if (s.velocity == 0) {
      s.current = settled + (s.current - settled) * exp(-resistance / inductance * left_s);
      return;
    }
    stop_s = reversal(i0, v0, last_v, s.velocity, velocity, left_s);
    (ii, iv, vi, vv, xi, xv) = coupled(stop_s);
    s.position = s.position + last_v * stop_s + xi * i0 + xv * v0;
    s.current = last_i + ii * i0 + iv * v0;
    s.velocity = 0;
    s.acceleration = 0;
    left_s = left_s - stop_s;
  }
}
)";

const char* const lost = R"(
/// What is lost before the windings once the current has settled, V: resistance * current + lost = what is left of the
/// voltage, by false position.
function lost_voltage(s, volts, supply_V, position, velocity, time_s) -> loss {
  available = volts - back_emf * velocity;
  high = available / resistance;
  low = 0.000001 * high;
  at_low = voltage_lost(s, volts, supply_V, position, velocity, low, time_s) - available;
  loss = voltage_lost(s, volts, supply_V, position, velocity, high, time_s);
  at_high = loss;
  if (at_low * at_high > 0) {
    loss = voltage_lost(s, volts, supply_V, position, velocity, high - loss / resistance, time_s);
  } else {
    kept = 0;
    k = 0;
    while (k < 12 && at_high != at_low) {
      k = k + 1;
      current = (low * at_high - high * at_low) / (at_high - at_low);
      loss = voltage_lost(s, volts, supply_V, position, velocity, current, time_s);
      value = resistance * current + loss - available;
      if (abs(value) < 0.0001 * abs(available)) {
        k = 12;
      } else if ((value > 0 && at_high > 0) || (value <= 0 && at_high <= 0)) {
        high = current;
        at_high = value;
        if (kept == -1) { at_low = 0.5 * at_low; }
        kept = -1;
      } else {
        low = current;
        at_low = value;
        if (kept == 1) { at_high = 0.5 * at_high; }
        kept = 1;
      }
    }
  }
}
)";

/// The loop over parts of a step around `inner`, which moves `h` from `now_s` on.
std::string partsText(const MotionKind& kind, const std::string& inner, const std::string& input) {
  if (!kind.changing) return "now_s = s.time_s; h = dt_s;" + inner + "s.time_s = now_s + dt_s; }\n";
  return "parts = max(1, ceil(dt_s / longest_step_s - 1e-9)); h = dt_s / parts; part = 0; begin_s = s.time_s;"
         "while (part < parts) { now_s = begin_s + part * h; was_at = s.position; was_fast = s.velocity;" +
         inner + "keep_history(&s, was_at, was_fast, " + input +
         ", h, now_s + h); part = part + 1; }"
         "s.time_s = begin_s + dt_s; }\n";
}

std::string advanceText(const MotionKind& kind) {
  std::string inner, volts = "drive_input";
  if (kind.losesVoltage) {
    volts = "volts";
    inner +=
        "middle = s.velocity + 0.5 * h * s.acceleration;"
        "if (middle * s.velocity <= 0) { middle = s.velocity; }"
        "volts = drive_input - lost_voltage(s, drive_input, supply_V, s.position + 0.25 * h * (s.velocity + "
        "middle), middle, now_s + 0.5 * h);";
  }
  if (!kind.electrical)
    inner += "move(&s, torque_constant * drive_input, viscous, h, now_s);";
  else if (kind.inductive)
    inner += "move_wound(&s, " + volts + ", h, now_s);";
  else
    inner += "move(&s, torque_constant * " + volts +
             " / resistance, viscous + torque_constant * back_emf / resistance, h, now_s);"
             "s.current = (" +
             volts + " - back_emf * s.velocity) / resistance;";
  std::string text = "/// dt_s under a constant input.\nfunction advance(&s, drive_input, supply_V, dt_s) {" +
                     partsText(kind, inner, "drive_input");
  if (kind.electrical)
    text += "/// dt_s with open windings: no current flows.\nfunction advance_open(&s, dt_s) {" +
            partsText(kind, "s.current = 0; move(&s, 0, viscous, h, now_s);", "0");
  return text;
}

}  // namespace

std::string motionText(const MotionKind& kind) {
  std::string text = common;
  if (kind.elastic) text += elasticFriction;
  text += kind.elastic ? elasticMechanical : rigidMechanical;
  if (kind.inductive) text += std::string(coupled) + (kind.elastic ? elasticInductive : rigidInductive);
  if (kind.losesVoltage) text += lost;
  return text + advanceText(kind);
}

}  // namespace breakaway
