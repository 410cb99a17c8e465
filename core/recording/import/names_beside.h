// What a column's name means by the names beside it, where it says too little alone.
#pragma once

#include <string>
#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/name_parts.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// The name's words without those of quantities and references: what or whose it is.
Words ownerOf(const std::string& name);

/// The name without its last word that reads so, in small letters.
std::string nameWithout(std::string name, const std::string& word);

/// Takes efforts, targets and an armature's columns for what they are; counts beside a position in metres stay unused.
void takeByNeighbours(const RawTable& table, const ImportMap& map, std::vector<Choice>& choices);

/// Where no column is a motion, those are, as a guess, whose quantity and unit are told and whose only doubt is a word
/// that isn't known ("speed_pi_raw_rpm"); else what is in counts ("enc1 (steps)").
void takeDoubtful(const RawTable& table, std::vector<Choice>& choices);

}  // namespace breakaway
