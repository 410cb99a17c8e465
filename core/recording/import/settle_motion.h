// What the values themselves tell of angle, speed and duty: turns that start anew, units that no name told, and what
// can't be.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace breakaway {

/// A period after which an angle starts anew, in the column's own unit: it stays within one and leaps by most of one.
/// Nothing when it doesn't. `pauses`: rows after a pause, over which nothing is known.
std::optional<double> periodOf(const std::vector<double>& angle, const std::vector<size_t>& pauses,
                               std::optional<double> expected = {});

struct Unwound {
  size_t places = 0;
  double largestStep = 0.0;  ///< afterwards, in periods: near 0.5 its direction can't be told
};
/// Lets the angle go on counting within each stretch between pauses.
Unwound unwind(std::vector<double>& angle, double period, const std::vector<size_t>& pauses);

/// The factor between the angle's changes and what the speed makes of them, Δangle = factor · ∫ speed dt, and how well
/// they agree (correlation, −1 to 1); pauses are left out. Nothing when one of them rests.
struct MotionFactor {
  double factor = 1.0;
  double correlation = 0.0;
};
std::optional<MotionFactor> compareMotion(const std::vector<double>& time_s, const std::vector<double>& angle,
                                          const std::vector<double>& speed, const std::vector<size_t>& pauses);

/// What two columns have in common about zero (−1 to 1), and how many times as large the first is; rows in which one is
/// missing don't count. Zeros where one rests.
struct Likeness {
  double correlation = 0.0, times = 0.0;
};
Likeness likenessOf(const std::vector<double>& one, const std::vector<double>& other);

/// How much the angle's changes and the speed, with rows evenly apart, vary alike about their means (−1 to 1): what
/// only goes up, as a meter or a row's number does, has nothing in common with a speed that doesn't change its sign.
double variesAlike(const std::vector<double>& angle, const std::vector<double>& speed);

/// Units of an angle and a speed that neither tells, by the factor between them: 6 is that of degrees and rpm. Nothing
/// when it is that of several pairs, as 1 is, or of none.
struct UnitPair {
  const char *angle, *speed;
  double angle_rad, speed_rad_per_s;
};
std::optional<UnitPair> unitsByFactor(double factor);

/// Counts per turn: the usual number within 1.5 % of the measured one, or that one as a whole number.
double usualCounts(double measured);

/// Above 0, and within a quarter of the largest, as a supply's voltage under load.
bool hardlyChanges(const std::vector<double>& values);
/// At least a fifth of the way has each sign.
bool goesBothWays(const std::vector<double>& speeds);
/// How often the values turn back after they went by at least a third of their range: 1 for a rise and a fall.
size_t turnsBack(const std::vector<double>& values);
/// From row to row; as many as values, the first is missing.
std::vector<double> changesOf(const std::vector<double>& values);
/// Whole numbers from 1000 to 2000 or little beyond, as radio control's pulses in µs.
bool arePulseWidths(const std::vector<double>& values);

/// Whole numbers throughout, but for missing values.
bool areWhole(const std::vector<double>& values);
/// Largest magnitude; 0 when all are missing.
double largest(const std::vector<double>& values);
double rangeOf(const std::vector<double>& values);

/// What a duty of these values is counted in: 1 for a duty, 100, 255, 1000, 1023, 4095 or 65535; nothing when it can't
/// be told.
std::optional<double> fullDutyOf(const std::vector<double>& values, bool namedPwm);

/// The first row at which the angle leaps by more than ten times its usual largest steps, in one of a thousand rows or
/// fewer.
struct Leaps {
  size_t count = 0, first = 0;
  double size = 0.0;
};
Leaps leapsIn(const std::vector<double>& time_s, const std::vector<double>& angle, const std::vector<size_t>& pauses);

}  // namespace breakaway
