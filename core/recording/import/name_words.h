// Words that are written as one, or that several make.
#pragma once

#include <string>

#include "recording/import/name_parts.h"

namespace breakaway {

/// "Drehzahlistwert" and "Istdrehzahl" are two words; "Lastmoment" is a load's.
void partCompounds(Words& words);

/// "目标转速" is two words, of which the last names the quantity.
void partGapless(Words& words);

/// Both, and English ("motorspeed", "targetposition", "timems"), a supply's ("vsupply"), without how a value was come
/// by
/// ("torque_from_current").
void partWords(Words& words);

/// "theta dot" and "dot theta" are a speed, "i q" the current of the q axis, "v in" the supply.
void joinWords(Words& words);

/// "rpm" of "rpm_from_counts": how a value was come by stands behind its unit.
std::string_view withoutSource(std::string_view text);

/// "mot_rpm" of "motrpm".
std::string withUnitsApart(const std::string& text);

}  // namespace breakaway
