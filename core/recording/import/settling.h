// A log on its way to a recording: the steps that importing takes, in the order of run().
#pragma once

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/import.h"
#include "recording/import/raw_table.h"
#include "recording/import/settle_motion.h"
#include "recording/import/settle_time.h"

namespace breakaway {

bool isAngle(const std::string& to);
bool isSpeed(const std::string& to);
void convert(std::vector<double>& values, double scale, double offset);
/// The rows asked for, in that order.
std::vector<double> rowsOf(const std::vector<double>& values, const std::vector<size_t>& rows);

/// Settles one table; used once.
class Settling {
 public:
  Settling(RawTable table, const ImportMap& map, std::string path, std::vector<size_t> newFile);
  Result<Imported> run();

 private:
  ColumnFate fateOf(size_t c) const;
  bool is(size_t c, const std::string& to) const;
  std::optional<size_t> columnOf(const std::string& to) const;
  std::vector<double>& values(size_t c) { return table_.columns[c].channel.values; }
  bool isOpen(size_t c) const { return fates_[c].kind == ColumnFate::Kind::used && !settled_.contains(c); }
  void keep(size_t c, Message why);
  std::string names() const;
  /// Rows of several motors in turn are no motion of one.
  Result<void> needOneAxis();
  Result<void> takeTime();
  /// Where trials stand one below the other, a clock that falls between them begins anew.
  void followTrials(RawTime& raw);
  static std::string unitNameOf(double unit_s);
  /// Where no column is the time, one that tells how long each row came after the one before makes it.
  std::optional<size_t> sumSteps();
  /// Keeps the rows that have a time, in all columns but `time`.
  void takeRows(size_t time);
  /// Logs that put each topic in rows of its own: the rows with an angle stay, the others' values are held.
  Result<void> sparseRows();
  /// What the factor still lacks: from the map, or an error that asks for it when `needed`.
  Result<bool> fillNeed(size_t c, bool needed);
  double gear(const std::string& to) const;
  void apply(size_t c);
  bool hasMeasuredSpeed() const { return columnOf("velocity_rad_per_s").has_value(); }
  Result<void> takeAngle();
  /// How far it went from row to row is no angle: it goes as the speed itself does.
  bool isWayPerRow(size_t c, size_t speed);
  /// A speed a whole number of times as fast as the angle is in electrical turns, or before a gear: it stays unused.
  void setElectricalSpeedAside(size_t angle, size_t speed, double times);
  /// An angle that starts anew with each turn and turns a whole number of times as fast as the speed, in electrical
  /// turns, say, or too fast for its rows, stays unused.
  bool isElectrical(size_t c, double period, size_t speed);
  /// Within one turn and with leaps nobody can tell which way it went.
  void sayIfAmbiguous(const std::vector<double>& angle, double turn);
  void unwindBy(std::vector<double>& angle, double period, bool whole);
  /// A unit for an angle whose name tells none.
  Result<void> nameUnit(size_t c, const std::optional<double>& period);
  /// A unit that neither its name nor the motion tells, as a guess: as what stands beside it, as what it follows, as a
  /// joint can turn at all. False where nothing does.
  bool unitBeside(size_t c);
  /// The radian, where messages of ROS tell a motion.
  bool unitAsRos(size_t c);
  /// "deg" where all angles and rates beside an angle, all rates beside a speed, that tell a unit are in degrees; empty
  /// where they don't.
  std::string familyBeside(size_t c) const;
  /// An angle without a unit that turns further than twice in radians, and nothing beside it speaks for them.
  bool mayBeDegrees(size_t c) const;
  /// One of five joints or more that are told apart by numbers.
  bool isOfArm(size_t c) const;
  /// Whether what it shall follow stays at round numbers: multiples of `step`, and beyond `least`.
  bool followsRoundNumbers(size_t c, const std::string& reference, double step, double least);
  /// By the speed, if that tells its unit: an angle in rad, deg or turns.
  std::optional<double> scaleBySpeed(size_t c);
  std::optional<MotionFactor> motionOf(size_t angle, size_t speed);
  /// Beside a speed whose unit is told, counts tell how many of them are one turn.
  bool countsBySpeed(size_t c);
  /// Beside an angle whose unit is told, a speed in counts per second does.
  bool countsByAngle(size_t c, size_t angle);
  void sayCounts(size_t c, size_t beside, double measured);
  /// Beside a speed in counts per second an angle that goes on as fast is in counts.
  bool isCountedAsSpeed(size_t c);
  /// Where neither angle nor speed tells a unit, the factor between them may: 6 is that of degrees and rpm.
  bool unitsByEachOther(size_t c);
  Result<void> takeSpeed();
  /// A unit for a speed that nothing else tells.
  Result<void> nameSpeedUnit(size_t c, bool alone);
  void speedByAngle(size_t c, size_t angle);
  /// Where only one of angle and speed is called the motor's and the other one turns more slowly, it is behind a gear.
  void setGearedAside();
  /// "rps" are either, which only an angle tells.
  void turnsOrRadians(size_t c);
  /// Angle and speed tell the unit of the time where nothing else does.
  void settleTimeByMotion();
  Result<void> takeDuty();
  /// One that never changes drives nothing both ways, or up and down again and again.
  void setSteadyDutyAside();
  Result<void> dutyBeyond(size_t c, const Message& what);
  Result<void> takeOther(size_t c);
  /// A position or a way per second that is nothing's in metres, and no unit is told.
  Result<void> needLinearUnit(size_t c) const;
  /// References without a unit are counted as what was measured is, or so that they go about as far; one that does so
  /// in no unit stays unused.
  void takeReferenceUnit(size_t c);
  /// One that never changes, and not to where or as fast as what was measured goes.
  bool staysElsewhere(size_t reference, size_t measured);
  /// Whether the one has anything in common with the other, at once or some rows later.
  bool isFollowed(size_t reference, size_t measured);
  /// Where no speed is known, the angle's changes tell the unit of what the speed shall be.
  void speedReferenceByAngle(size_t c);
  /// Electrical values without a unit that look like a converter's counts or like mA.
  bool setCountsAside(size_t c);
  /// A supply's voltage is never negative; one that is drives the motor.
  void settleSupply();
  /// A voltage that hardly changes while the axis turns both ways, or while a duty drives it, is the supply's.
  void settleVoltage();
  /// A torque or a current that is larger the faster it turns, as no winding's at a steady voltage is.
  std::optional<size_t> risesWithSpeed() const;
  /// Beside a supply's voltage and a throttle a current that isn't called the motor's may be the supply's, too.
  void doubtCurrent();
  /// An inverter's output current that is never negative, beside its frequency, may be an effective value.
  void doubtAmount();
  /// Kept unused, holding numbers, and neither the map nor the tool says so.
  bool isFree(size_t c) const;
  /// The same, and because its name says nothing that is known.
  bool isUnknown(size_t c) const;
  /// Where no speed is known: a column that the angle moves by, in a usual unit.
  void takeSpeedByValues();
  /// What has a current's, torque's or voltage's unit and a name that isn't known is the motor's where no other is and
  /// acceleration and friction explain it.
  void takeDrivesByValues();
  /// "Setpoint" is what the angle or the speed follows.
  void takeReferencesByValues();
  /// Gives those of `names` that are never negative the sign that a column of directions tells.
  void signByDirection(std::initializer_list<const char*> names);
  bool tellsDirection(size_t c) const;
  /// Per row 1 or −1; empty when the column tells none.
  std::vector<double> directionsAt(size_t c);
  /// Turns `signs` where the motion is the other way round; false where the column needs none.
  bool directionFits(size_t c, std::vector<double>& signs);
  bool goesBelowZero(const std::string& name);
  bool turnsBothWays();
  Result<void> takeIntegral();
  void differentiate();
  Result<void> turnSigns();
  Result<void> needMotion();
  /// Says what can't be: an angle that leaps, a speed that contradicts it.
  void checkMotion();
  Result<Imported> seal();

  RawTable table_;
  const ImportMap& map_;
  std::string path_;
  std::vector<size_t> newFile_;
  std::vector<Choice> choices_;
  std::vector<ColumnFate> fates_;
  std::vector<Message> remarks_;
  std::set<size_t> settled_;
  std::vector<Channel> made_;
  SettledTime time_;
  std::optional<double> counts_per_rev_;  ///< where the map tells none, as angle and speed have it
  std::optional<size_t> pulseWidths_;     ///< what a speed controller or a servo was told
};

}  // namespace breakaway
