#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "recording/import/axes_in_turn.h"
#include "recording/import/choose_columns.h"
#include "recording/import/import.h"
#include "recording/import/known_tools.h"
#include "recording/import/number_text.h"
#include "recording/import/plausible.h"
#include "recording/import/settling.h"

namespace breakaway {

namespace {

/// A name that a header line can hold.
std::string plainName(std::string name, size_t column) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c == ',' || c == '"' || c == '#' || c < 0x20; }, '_');
  const size_t start = name.find_first_not_of(' ');
  if (start == std::string::npos) return "column_" + std::to_string(column + 1);
  return name.substr(start, name.find_last_not_of(' ') - start + 1);
}

}  // namespace

void convert(std::vector<double>& values, double scale, double offset) {
  if (scale == 1.0 && offset == 0.0) return;
  for (double& value : values) value = scale * value + offset;
}

bool isAngle(const std::string& to) {
  return to == "angle_rad" || to == "angle_reference_rad";
}

bool isSpeed(const std::string& to) {
  return to == "velocity_rad_per_s" || to == "velocity_reference_rad_per_s";
}

std::vector<double> rowsOf(const std::vector<double>& values, const std::vector<size_t>& rows) {
  std::vector<double> kept;
  kept.reserve(rows.size());
  for (const size_t row : rows) kept.push_back(values[row]);
  return kept;
}

Settling::Settling(RawTable table, const ImportMap& map, std::string path, std::vector<size_t> newFile)
    : table_(std::move(table)), map_(map), path_(std::move(path)), newFile_(std::move(newFile)) {
}

Result<Imported> Settling::run() {
  const ToolColumns tool = recogniseTool(table_, map_.counts_per_rev.value_or(0.0));
  remarks_ = table_.remarks;
  auto choices = chooseColumns(table_, map_, tool, path_);
  if (!choices) return choices.error();
  choices_ = std::move(*choices);
  for (size_t c = 0; c < choices_.size(); ++c) fates_.push_back(fateOf(c));
  if (const auto one = needOneAxis(); !one) return one.error();
  if (const auto done = takeTime(); !done) return done.error();
  if (const auto done = sparseRows(); !done) return done.error();
  sayPauses(time_, remarks_);
  signByDirection({"velocity_rad_per_s", "velocity_m_per_s"});
  if (const auto done = takeIntegral(); !done) return done.error();
  if (const auto done = takeAngle(); !done) return done.error();
  takeSpeedByValues();
  if (const auto done = takeSpeed(); !done) return done.error();
  settleTimeByMotion();
  setGearedAside();
  takeDrivesByValues();
  takeReferencesByValues();
  if (const auto done = takeDuty(); !done) return done.error();
  signByDirection({"duty"});
  setSteadyDutyAside();
  settleVoltage();
  signByDirection({"voltage_V"});
  for (size_t c = 0; c < choices_.size(); ++c) {
    if (isOpen(c)) {
      if (const auto done = takeOther(c); !done) return done.error();
    }
  }
  if (const auto done = turnSigns(); !done) return done.error();
  differentiate();
  if (const auto done = needMotion(); !done) return done.error();
  checkMotion();
  return seal();
}

ColumnFate Settling::fateOf(size_t c) const {
  const Choice& choice = choices_[c];
  ColumnFate fate;
  fate.from = table_.columns[c].channel.name;
  fate.kind = choice.dropped             ? ColumnFate::Kind::leftOut
              : choice.name.understood() ? ColumnFate::Kind::used
                                         : ColumnFate::Kind::kept;
  fate.to = choice.name.understood() ? choice.name.to : plainName(fate.from, c);
  fate.scale = choice.name.scale;
  fate.offset = choice.name.offset;
  fate.unit = choice.name.unit;
  fate.why = choice.name.understood() ? (choice.byMap                 ? message("the map says so")
                                         : choice.byTool              ? message("as that tool has it")
                                         : choice.name.byUnit         ? message("by its unit alone")
                                         : !choice.name.guess.empty() ? choice.name.guess
                                                                      : message("by its name"))
                                      : choice.name.aside;
  if (choice.name.understood()) fate.doubt = choice.name.guess;
  fate.guessed =
      choice.name.understood() && (choice.name.unit.empty() || choice.name.byUnit || !choice.name.guess.empty());
  return fate;
}

bool Settling::is(size_t c, const std::string& to) const {
  return fates_[c].kind == ColumnFate::Kind::used && fates_[c].to == to;
}

std::optional<size_t> Settling::columnOf(const std::string& to) const {
  for (size_t c = 0; c < fates_.size(); ++c) {
    if (is(c, to)) return c;
  }
  return std::nullopt;
}

void Settling::keep(size_t c, Message why) {
  fates_[c].kind = ColumnFate::Kind::kept;
  fates_[c].to = plainName(fates_[c].from, c);
  fates_[c].why = std::move(why);
  fates_[c].guessed = false;
}

std::string Settling::names() const {
  std::string text;
  for (const ColumnFate& fate : fates_) {
    if (fate.kind == ColumnFate::Kind::leftOut) continue;
    text += (text.empty() ? "" : ", ") + fate.to;
    if (text.size() > 300) return text + ", …";
  }
  return text;
}

Result<void> Settling::needOneAxis() {
  if (!map_.split.empty()) return {};
  std::optional<size_t> motion;
  for (const char* name : {"angle_rad", "position_m", "velocity_rad_per_s", "velocity_m_per_s"}) {
    if (!motion) motion = columnOf(name);
  }
  if (!motion) return {};
  std::vector<bool> free;
  free.reserve(choices_.size());
  for (const Choice& choice : choices_) free.push_back(!choice.name.understood() && !choice.byMap && !choice.byTool);
  const auto turn = axesInTurn(table_, free, *motion, columnOf("time_s"));
  if (!turn) return {};
  std::string list;
  for (size_t k = 0; k < turn->names.size() && k < 4; ++k) list += (k == 0 ? "" : ", ") + turn->names[k];
  const std::string& column = table_.columns[turn->column].channel.name;
  if (turn->messages)
    return Error{path_ + ", column " + column,
                 message("rows that were sent and rows that came back stand in one table ({}); part them with --map {}",
                         list, "{\"split\": \"" + column + "\"}")};
  return Error{path_ + ", column " + column,
               message("rows of {} axes stand in one table ({}); part them with --map {}", turn->names.size(),
                       list + (turn->names.size() > 4 ? ", …" : ""), "{\"split\": \"" + column + "\"}")};
}

Result<bool> Settling::fillNeed(size_t c, bool needed) {
  ColumnFate& fate = fates_[c];
  const UnitNeeds needs = choices_[c].name.needs;
  if (needs == UnitNeeds::nothing) return true;
  const bool counts = needs == UnitNeeds::countsPerRev;
  const auto& given = !counts ? map_.pole_pairs : map_.counts_per_rev ? map_.counts_per_rev : counts_per_rev_;
  if (given) {
    fate.scale /= *given;
    return true;
  }
  const Message ask =
      counts ? message("counts, and no file says how many are one turn; say it with --map {}",
                       "{\"counts_per_rev\": 4096}")
             : message("speaks of electrical turns, and no file says the motor's pole pairs; say them with --map {}",
                       "{\"pole_pairs\": 7}");
  if (needed) return Error{path_ + ", column " + fate.from, ask};
  keep(c, ask);
  return false;
}

double Settling::gear(const std::string& to) const {
  return isAngle(to) || isSpeed(to) ? map_.gear_ratio.value_or(1.0)
         : to == "torque_Nm"        ? 1.0 / map_.gear_ratio.value_or(1.0)
                                    : 1.0;
}

void Settling::apply(size_t c) {
  const double gear_ratio = gear(fates_[c].to);
  convert(values(c), fates_[c].scale * gear_ratio, fates_[c].offset * gear_ratio);
  fates_[c].scale *= gear_ratio;
  fates_[c].offset *= gear_ratio;
  settled_.insert(c);
}

Result<Imported> Settling::seal() {
  std::vector<Channel> channels{{"time_s", std::move(time_.time_s)}};
  std::set<std::string> taken{"time_s"};
  for (size_t c = 0; c < fates_.size(); ++c) {
    if (fates_[c].kind == ColumnFate::Kind::leftOut || is(c, "time_s")) continue;
    ColumnFate& fate = fates_[c];
    if (!taken.insert(fate.to).second) {
      fate.kind = ColumnFate::Kind::leftOut;
      fate.why = message("stands there twice");
      continue;
    }
    channels.push_back({fate.to, std::move(values(c))});
  }
  for (Channel& channel : made_) {
    if (taken.insert(channel.name).second) channels.push_back(std::move(channel));
  }
  table_.notes.emplace_back("imported from", std::filesystem::path(path_).filename().string());
  auto recording = Recording::seal(path_, std::move(channels), std::move(table_.notes));
  if (!recording) return recording.error();
  for (Message& one : contradictionsIn(*recording)) remarks_.push_back(std::move(one));
  return Imported{std::move(*recording), std::move(fates_), std::move(remarks_)};
}

Message ColumnFate::inWords() const {
  if (kind == Kind::leftOut) return message("{}: left out, {}", from, why);
  if (kind == Kind::kept) return message("{}: kept unused, {}", from, why);
  Message text(from == to ? from : from + " → " + to);
  if (from != to || scale != 1.0 || guessed) {
    text =
        text + (unit.empty() ? message(", taken as SI, a guess: the name tells no unit") : message(", from {}", unit));
    if (scale != 1.0) text = text + (" (× " + shortText(scale) + ")");
    if (offset != 0.0) text = text + ((offset > 0.0 ? ", + " : ", − ") + shortText(std::abs(offset)));
    if (guessed && !unit.empty()) text = text + message(", a guess: {}", why);
    if (!doubt.empty() && (unit.empty() || doubt != why)) text = text + std::string("; ") + doubt;
  }
  return text;
}

Result<Imported> settleTable(RawTable table, const ImportMap& map, const std::string& path,
                             const std::vector<size_t>& newFile) {
  return Settling(std::move(table), map, path, newFile).run();
}

}  // namespace breakaway
