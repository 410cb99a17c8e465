// Which of several angles and speeds go together, by their values.
#pragma once

#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Where the angle that would be taken says nothing of whose it is and moves otherwise than another one, which is
/// called a motor's or an encoder's, it is how something leans or heads: it is set aside, and the other one a guess.
/// Whether it was.
bool preferMotorsAngle(const RawTable& table, size_t angle, std::vector<Choice>& choices);

/// Where angle and speed say nothing of whose they are, and another speed, in a unit of its own, is called a motor's or
/// a wheel's and moves otherwise, they are how something leans that it drives: they are set aside. False where nothing
/// is to be done.
bool preferMotorsSpeed(const RawTable& table, size_t angle, size_t speed, std::vector<Choice>& choices);

/// Where the angle that would be taken moves otherwise than the speed that would be, and another angle or speed beside
/// them agrees, sets aside what is no motor's: a robot's tilt and its rate beside its wheel's speed; so is an angle of
/// something with a name of its own ("pedal_pos") beside a motor's speed whose unit is told. `angle` and `speed` are
/// the columns that would be taken. Whether anything was set aside.
bool setStrangersAside(const RawTable& table, size_t angle, size_t speed, std::vector<Choice>& choices);

/// A position in metres beside a speed of rotation whose unit is told, with which it has little in common, is no
/// motor's: how far a rotor is off its centre. Whether it was set aside.
bool setStrangePlaceAside(const RawTable& table, size_t position, size_t speed, std::vector<Choice>& choices);

/// Where the speed that would be taken is called otherwise than the angle, and another one as well told is called as it
/// is ("omega_enc" beside "theta_enc"), sets the former aside. Whether it did.
bool preferNamesake(const RawTable& table, size_t angle, size_t speed, std::vector<Choice>& choices);

/// Where no angle is known: a column that is called as the speed is but for one word ("loc_state" beside "speed_state")
/// and moves as it says; what has that word, too, goes with it.
void takeAnglesByValues(const RawTable& table, std::vector<Choice>& choices);

/// Where no name tells any motion: of columns that nothing is known of, one that changes as another says is the angle,
/// and that other one its speed; of a chain (place, speed, acceleration) the first two. Both are guesses.
void takeMotionByValues(const RawTable& table, std::vector<Choice>& choices);

/// Where no name tells a motion, what is called by a joint alone is its angle, as a guess: "joint_1", "elbow_act".
void takeJointsAlone(const RawTable& table, std::vector<Choice>& choices);

}  // namespace breakaway
