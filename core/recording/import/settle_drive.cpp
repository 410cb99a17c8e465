// What drives a log: duty, voltage, and all else that has a unit; signs.
#include <algorithm>
#include <array>
#include <cmath>

#include "recording/import/drive_evidence.h"
#include "recording/import/name_parts.h"
#include "recording/import/number_text.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settling.h"

namespace breakaway {

Result<void> Settling::takeDuty() {
  const auto c = columnOf("duty");
  if (!c || settled_.contains(*c)) return {};
  ColumnFate& fate = fates_[*c];
  auto& duty = values(*c);
  if (fate.unit.empty() && arePulseWidths(duty)) {
    pulseWidths_ = *c;
    keep(*c, message("holds the pulse widths of a servo or a speed controller in µs, whose stop no file says"));
    return {};
  }
  if (fate.unit.empty() || fate.unit == "1") {
    const auto words = wordsOf(fate.from, true);
    const bool pwm = std::find(words.begin(), words.end(), "pwm") != words.end();
    const auto full = fullDutyOf(duty, pwm);
    const bool driven = columnOf("current_A") || columnOf("torque_Nm") || columnOf("voltage_V");
    if (!full && driven && !choices_[*c].byMap) {
      keep(*c, message("goes up to {}, and nothing tells what is the whole of it: say it with --map",
                       shortText(largest(duty))));
      return {};
    }
    if (!full)
      return dutyBeyond(*c, message("can be the whole of it; say it with --map, e.g. {}",
                                    "{\"columns\": {\"" + fate.from + "\": {\"to\": \"duty\", \"scale\": 0.001}}}"));
    if (*full != 1.0) {
      fate.scale = 1.0 / *full;
      fate.unit = *full == 100.0 ? "%" : "1/" + shortText(*full);
      fate.why =
          message("its values go up to {}, so {} was taken for full", shortText(largest(duty)), shortText(*full));
      fate.guessed = true;
    }
  }
  apply(*c);
  if (largest(duty) > 1.0 + 1e-6 && largest(duty) < 1.02) {
    for (double& value : duty) value = std::clamp(value, -1.0, 1.0);
    remarks_.push_back(message("the duty exceeds 1 by less than 2 % and was limited"));
  }
  if (largest(duty) > 1.0 + 1e-6) return dutyBeyond(*c, message("is a duty, which ends at 1"));
  return {};
}

void Settling::setSteadyDutyAside() {
  const auto c = columnOf("duty");
  if (!c || choices_[*c].byMap || choices_[*c].byTool) return;
  constexpr size_t often = 4;
  const auto speed = columnOf("velocity_rad_per_s");
  const bool moves = turnsBothWays() || (speed && turnsBack(values(*speed)) >= often);
  if (rangeOf(values(*c)) == 0.0 && largest(values(*c)) > 0.0 && moves)
    return keep(*c, message("never changes although the speed does"));
  const bool beside = goesBelowZero("voltage_V") || goesBelowZero("current_A") || goesBelowZero("torque_Nm");
  if (turnsBothWays() && beside && !goesBelowZero("duty") && largest(values(*c)) > 0.0)
    keep(*c, message("tells no direction although the axis turns both ways"));
}

Result<void> Settling::dutyBeyond(size_t c, const Message& what) {
  const auto& duty = values(c);
  const auto at = std::max_element(duty.begin(), duty.end(), [](double a, double b) {
    return (std::isfinite(a) ? std::abs(a) : -1.0) < (std::isfinite(b) ? std::abs(b) : -1.0);
  });
  return Error{path_ + ", row " + std::to_string(time_.rows[static_cast<size_t>(at - duty.begin())] + 1) + ", column " +
                   fates_[c].from,
               message("{}, the largest value: nothing tells which one {}", shortText(*at), what)};
}

Result<void> Settling::takeOther(size_t c) {
  const auto filled = fillNeed(c, false);
  if (!filled) return filled.error();
  if (!*filled) return {};
  std::string& to = fates_[c].to;
  if (const auto told = needLinearUnit(c); !told) return told.error();
  if (setCountsAside(c)) return {};
  if (to == "force_N" && columnOf("torque_Nm") && !columnOf("position_m") && !choices_[c].byMap) {
    keep(c, message("is a force, beside the torque of a motor that turns"));
    return {};
  }
  const bool unitless = to == "force_N" && fates_[c].unit.empty() && columnOf("angle_rad") && !columnOf("torque_Nm");
  const bool motors = !choices_[c].name.qualified || firstIn(wordsOf(fates_[c].from, true), jointWords) != nullptr;
  if (unitless && !motors) {
    keep(c, message("is a force beside an angle, and nothing tells of which arm"));
    return {};
  }
  const bool turns = (columnOf("angle_rad") || columnOf("velocity_rad_per_s")) && !columnOf("position_m") &&
                     !columnOf("velocity_m_per_s");
  if (to == "force_N" && !unitless && turns && !choices_[c].byMap) {
    keep(c, message("is a force beside what turns, and nothing tells of which arm"));
    return {};
  }
  if (unitless) {
    to = "torque_Nm";
    fates_[c].unit = "Nm";
    fates_[c].why = message("what turns is driven by a torque");
  }
  takeReferenceUnit(c);
  if (fates_[c].kind == ColumnFate::Kind::used) apply(c);
  return {};
}

bool Settling::setCountsAside(size_t c) {
  const std::string& to = fates_[c].to;
  const bool drive = to == "current_A" || to == "torque_Nm" || to == "force_N" || to == "current_reference_A";
  const double most = drive                                   ? 60.0
                      : to == "voltage_V" || to == "supply_V" ? 120.0
                      : to == "temperature_degC"              ? 250.0
                                                              : 0.0;
  // "batt_volt" says what it is rather than in which unit.
  const bool word = quantityNamed(fates_[c].unit) != nullptr && fates_[c].from.find_first_of("([") == std::string::npos;
  const bool guessed = ((fates_[c].guessed && fates_[c].unit.empty()) || word) && !choices_[c].byMap;
  if (most == 0.0 || !guessed) return false;
  // Times as much is beyond any motor, or beyond what a letter alone is believed.
  const Words named = wordsOf(fates_[c].from, true);
  const bool letter = named.size() == 1 && named[0].size() == 1;
  const double withDecimals = letter ? 2.5 : 20.0;
  const bool whole = areWhole(values(c)), mechanical = to == "torque_Nm" || to == "force_N";
  if ((!whole && mechanical) || largest(values(c)) <= (whole ? most : withDecimals * most)) return false;
  if (!whole) {
    const std::string far = shortText(largest(values(c)));
    remarks_.push_back(
        message("implausible: {} goes up to {} and has no unit; it may be thousandths", fates_[c].from, far));
    keep(c, message("goes up to {} and has no unit; it may be thousandths: say which with --map", far));
    return true;
  }
  const std::string up = shortText(largest(values(c)));
  remarks_.push_back(message(
      "implausible: {} holds whole numbers up to {} and no unit; they may be thousandths or a converter's counts",
      fates_[c].from, up));
  keep(c,
       message("holds whole numbers up to {} and no unit; they may be thousandths or a converter's counts: say which "
               "with --map",
               up));
  return true;
}

void Settling::settleSupply() {
  const auto c = columnOf("supply_V");
  if (!c || choices_[*c].byMap || choices_[*c].byTool || !goesBelowZero("supply_V")) return;
  constexpr double much = 0.1;  // of the way up: less is noise about 0
  const auto [low, high] = std::minmax_element(values(*c).begin(), values(*c).end(), [](double a, double b) {
    return (std::isfinite(a) ? a : 0.0) < (std::isfinite(b) ? b : 0.0);
  });
  if (-*low < much * std::max(0.0, *high)) return;
  static constexpr auto unsure = std::to_array<std::string_view>({"input", "dc", "esc", "hv", "traction"});
  const Words words = wordsOf(fates_[*c].from, true);
  const bool sure = std::any_of(words.begin(), words.end(),
                                [](const std::string& word) { return isIn(supplyWords, word) && !isIn(unsure, word); });
  if (!sure && columnOf("voltage_V")) return keep(*c, message("goes below zero, as no supply does"));
  if (!sure) fates_[*c].to = "voltage_V";
  fates_[*c].why = message("goes below zero, as no supply does");
  fates_[*c].guessed = true;
}

void Settling::doubtAmount() {
  const auto c = columnOf("current_A");
  if (!c || choices_[*c].byMap || choices_[*c].byTool || goesBelowZero("current_A")) return;
  static constexpr auto frequencies = std::to_array<std::string_view>({"frequency", "freq", "frequenz"});
  const bool inverter = std::any_of(table_.columns.begin(), table_.columns.end(), [](const RawColumn& column) {
    return firstIn(wordsOf(column.channel.name, true), frequencies) != nullptr;
  });
  if (!inverter || !isIn(wordsOf(fates_[*c].from, true), "output")) return;
  fates_[*c].why = message("it may be the amount of an alternating current");
  fates_[*c].doubt = fates_[*c].why;
  fates_[*c].guessed = true;
}

void Settling::settleVoltage() {
  settleSupply();
  doubtAmount();
  const auto c = columnOf("voltage_V");
  const auto told = columnOf("current_A");
  if (!c && told && !fates_[*told].guessed && columnOf("supply_V") && !columnOf("torque_Nm") &&
      !goesBelowZero("current_A"))
    doubtCurrent();
  if (!c || choices_[*c].byMap || choices_[*c].byTool) return;
  for (const std::string& word : wordsOf(fates_[*c].from, true)) {
    if (word == "motor" || word == "mot" || word == "q" || word == "uq" || word == "vq" || word == "vm") return;
  }
  const auto named = wordsOf(fates_[*c].from, true);
  const bool amount = isIn(named, "output") && columnOf("supply_V") && largest(values(*c)) > 0.0 &&
                      std::none_of(values(*c).begin(), values(*c).end(), [](double v) { return v < 0.0; });
  if (amount && !fates_[*c].guessed) {  // of an inverter
    fates_[*c].guessed = true;
    fates_[*c].why = message("it may be the amount of an alternating voltage");
    fates_[*c].doubt = fates_[*c].why;
  }
  if (!hardlyChanges(values(*c)) || setCountsAside(*c)) return;
  const auto speed = columnOf("velocity_rad_per_s");
  if (columnOf("supply_V") && speed && rangeOf(values(*speed)) > 0.5 * largest(values(*speed)))
    return keep(*c,
                message("it hardly changes while the speed does, beside the supply's, so it is no motor's voltage"));
  const auto duty = columnOf("duty");
  const auto varies = [this](size_t column) { return rangeOf(values(column)) > 0.2 * largest(values(column)); };
  bool battery = false;  // a state of charge, or a throttle that varies, is told beside it
  for (size_t k = 0; k < fates_.size(); ++k) {
    if (fates_[k].kind == ColumnFate::Kind::leftOut) continue;
    const auto words = wordsOf(fates_[k].from, true);
    const auto has = [&words](const char* word) { return std::find(words.begin(), words.end(), word) != words.end(); };
    battery = battery || has("soc") || (has("throttle") && varies(k));
  }
  const bool driven = battery || (duty && varies(*duty)) || pulseWidths_.has_value();
  constexpr size_t often = 4;  // once up and down is a motor that is switched on and loaded
  const bool both = turnsBothWays(), again = speed && turnsBack(values(*speed)) >= often;
  const auto rising = both || again || driven ? std::nullopt : risesWithSpeed();
  if (!driven && !both && !again && !rising) return;
  const Message why = battery  ? message("it hardly changes, and a battery's charge or a throttle stands beside it")
                      : driven ? message("it hardly changes while the duty does")
                      : rising ? message("it hardly changes while {} rises with the speed", fates_[*rising].from)
                      : both   ? message("it hardly changes while the axis turns both ways")
                               : message("it hardly changes while the speed rises and falls again and again");
  if (columnOf("supply_V")) return keep(*c, why + message(", so it is no motor's voltage"));
  if (battery || pulseWidths_ || !goesBelowZero("current_A")) doubtCurrent();
  fates_[*c].to = "supply_V";
  fates_[*c].why = why;
  fates_[*c].guessed = true;
  if (fates_[*c].unit.empty()) fates_[*c].unit = "V";
}

std::optional<size_t> Settling::risesWithSpeed() const {
  constexpr double together = 0.7, much = 0.5;
  const auto speed = columnOf("velocity_rad_per_s");
  if (!speed || rangeOf(table_.columns[*speed].channel.values) < much * largest(table_.columns[*speed].channel.values))
    return std::nullopt;
  for (const char* name : {"torque_Nm", "current_A"}) {
    const auto c = columnOf(name);
    const bool goes =
        c &&
        followingOf(table_.columns[*c].channel.values, table_.columns[*speed].channel.values).correlation > together;
    if (goes) return c;
  }
  return std::nullopt;
}

void Settling::doubtCurrent() {
  const auto c = columnOf("current_A");
  if (!c || choices_[*c].byMap || choices_[*c].byTool) return;
  static constexpr auto motors = std::to_array<std::string_view>({"motor", "mot", "q", "iq", "phase", "winding"});
  if (firstIn(wordsOf(fates_[*c].from, true), motors) != nullptr) return;
  fates_[*c].why = message("it may be the supply's, as the voltage is");
  fates_[*c].doubt = fates_[*c].why;
  fates_[*c].guessed = true;
}

bool Settling::goesBelowZero(const std::string& name) {
  const auto c = columnOf(name);
  return c && std::any_of(values(*c).begin(), values(*c).end(), [](double v) { return v < 0.0; });
}

bool Settling::turnsBothWays() {
  const auto speed = columnOf("velocity_rad_per_s"), angle = columnOf("angle_rad");
  return speed ? goesBothWays(values(*speed)) : angle && goesBothWays(changesOf(values(*angle)));
}

Result<void> Settling::turnSigns() {
  for (const auto& [name, sign] : map_.sign) {
    bool found = false;
    for (size_t c = 0; c < fates_.size(); ++c) {
      if ((fates_[c].from != name && fates_[c].to != name) || fates_[c].kind == ColumnFate::Kind::leftOut) continue;
      found = true;
      if (is(c, "time_s") || sign > 0.0) continue;
      convert(values(c), -1.0, 0.0);
      fates_[c].scale = -fates_[c].scale;
      fates_[c].offset = -fates_[c].offset;
    }
    for (Channel& channel : made_) {
      if (channel.name != name) continue;
      found = true;
      if (sign < 0.0) convert(channel.values, -1.0, 0.0);
    }
    if (!found)
      return Error{path_, message("has no column \"{}\", whose sign the map turns; there are: {}", name, names())};
  }
  return {};
}

}  // namespace breakaway
