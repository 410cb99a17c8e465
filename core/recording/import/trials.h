// Tables of several trials, each of which may have a clock of its own.
#pragma once

#include <optional>
#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

struct Trials {
  size_t column = 0;            ///< tells which one a row is of
  std::vector<size_t> borders;  ///< the first row of each but the first one, in order
};

/// The column that numbers or names trials, episodes or runs ("trial", "episode_index"), each of which is one block of
/// rows; of several such columns the one with most blocks. Nothing where there is none, or only one block.
std::optional<Trials> trialsIn(const RawTable& table);

/// Goes up within each trial, seldom down, and doesn't stand still.
bool goesUpInTrials(const std::vector<double>& values, const std::vector<size_t>& borders);

/// Where nothing else is the time, what has a time's word in its name ("time_step") is, if it goes on in even steps
/// within each trial and doesn't count the rows; a guess.
void takeTimesInSteps(const RawTable& table, std::vector<Choice>& choices);

}  // namespace breakaway
