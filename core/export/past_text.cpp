#include "export/past_text.h"

#include <fmt/core.h>

#include <vector>

namespace breakaway {

namespace {

/// One of the values that a ring keeps: the member that holds it, and what is noted in it.
struct Kept {
  std::string member, value;
};

/// What is remembered for a while: `s.NAME_time_s` and the members, `s.NAME_count` of them, the oldest first.
struct Ring {
  std::string name;  ///< of the state's members
  std::string what;  ///< of the functions
  std::vector<Kept> kept;
};

/// `text` once for each value kept, its `{value}` being what is noted, `{member}` the member.
std::string forEach(const Ring& ring, const std::string& text) {
  std::string all;
  for (const Kept& one : ring.kept)
    all += fmt::format(fmt::runtime(text), fmt::arg("member", "s." + ring.name + "_" + one.member),
                       fmt::arg("value", one.value));
  return all;
}

/// Text with the ring's names: `{R}` its members' beginning, `{W}` what it is of.
std::string ofRing(const Ring& ring, const std::string& text) {
  return fmt::format(fmt::runtime(text), fmt::arg("R", "s." + ring.name), fmt::arg("W", ring.what));
}

/// note_WHAT(): what counts from now on; the oldest is given up where there are too many.
std::string noteText(const Ring& ring, const std::string& arguments, size_t size) {
  return ofRing(ring, "function note_{W}(&s" + arguments + ") {{\n  if ({R}_count >= " + std::to_string(size) +
                          ") {{\n    k = 1;\n    while (k < {R}_count) {{\n"
                          "      {R}_time_s[k - 1] = {R}_time_s[k];\n") +
         forEach(ring, "      {member}[k - 1] = {member}[k];\n") +
         ofRing(ring,
                "      k = k + 1;\n    }}\n    {R}_count = {R}_count - 1;\n  }}\n"
                "  {R}_time_s[{R}_count] = s.time_s;\n") +
         forEach(ring, "  {member}[s." + ring.name + "_count] = {value};\n") +
         ofRing(ring, "  {R}_count = {R}_count + 1;\n}}\n");
}

/// WHAT_index(): which of what was noted counted at a time; WHAT_mean(): the means of what counted over a time.
std::string meanText(const Ring& ring) {
  std::string results;
  for (const Kept& one : ring.kept) results += (results.empty() ? "" : ", ") + one.value;
  return ofRing(ring, R"(/// Which of what was noted counted at a time.
function {W}_index(s, time_s) -> k {{
  k = 0;
  later = 1;
  while (later < {R}_count) {{
    if ({R}_time_s[later] <= time_s) {{ k = later; }}
    later = later + 1;
  }}
}}
/// The mean of what counted over a time.
function {W}_mean(s, from_s, to_s) -> )" +
                          results + R"( {{
  k = {W}_index(s, from_s);
  at_s = from_s;
  searching = 1;
  while (searching > 0) {{
    searching = 0;
    if (k + 1 < {R}_count) {{
      if ({R}_time_s[k + 1] < to_s) {{
)") + forEach(ring, "        {value} = {value} + {member}[k] * (s." + ring.name + "_time_s[k + 1] - at_s);\n") +
         ofRing(ring, R"(        at_s = {R}_time_s[k + 1];
        k = k + 1;
        searching = 1;
      }}
    }}
  }}
)") + forEach(ring, "  {value} = ({value} + {member}[k] * (to_s - at_s)) / (to_s - from_s);\n") +
         "}\n";
}

}  // namespace

std::string delayText(size_t size) {
  const Ring commands{"past", "input", {{"input", "value"}}};
  return "\n/// Notes a command that counts from now on.\n" + noteText(commands, ", value", size) + meanText(commands) +
         R"(/// dt_s in pieces, as a late input changes within it.
function advance_late(&s, delay_s, supply_V, dt_s) {
  last_s = s.time_s + dt_s;
  while (s.time_s < last_s) {
    k = input_index(s, s.time_s - delay_s + 1e-12);
    next_s = last_s;
    if (k + 1 < s.past_count) { next_s = min(last_s, s.past_time_s[k + 1] + delay_s); }
    if (next_s > s.time_s) { advance(&s, s.past_input[k], supply_V, next_s - s.time_s); }
    s.time_s = next_s;
  }
}
)";
}

std::string servoText(size_t size) {
  const Ring asked{"asked", "reference", {{"place", "place"}, {"speed", "speed"}}};
  const Ring been{"been", "motion", {{"place", "s.position"}, {"speed", "s.velocity"}}};
  return "\n/// Notes what is asked for from now on.\n" + noteText(asked, ", place, speed", size) + meanText(asked) +
         "/// Notes where it is now.\n" + noteText(been, "", size) +
         R"(/// Where it was and how fast, between what was noted and now.
function motion_at(s, time_s) -> place, speed {
  after_s = s.time_s;
  place = s.position;
  speed = s.velocity;
  k = s.been_count - 1;
  while (k >= 0) {
    if (s.been_time_s[k] <= time_s) {
      part = (time_s - s.been_time_s[k]) / (after_s - s.been_time_s[k]);
      place = s.been_place[k] + part * (place - s.been_place[k]);
      speed = s.been_speed[k] + part * (speed - s.been_speed[k]);
      k = -1;
    } else {
      after_s = s.been_time_s[k];
      place = s.been_place[k];
      speed = s.been_speed[k];
      k = k - 1;
    }
  }
}
)";
}

}  // namespace breakaway
