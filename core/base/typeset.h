// Numbers as people read them: for texts and pictures, never for files that programs read.
#pragma once

#include <string>
#include <string_view>

namespace breakaway {

/// "⁻⁵" of −5.
std::string superscript(int value);

/// A formatted number with a minus sign for each hyphen, groups of three digits from 10 000 on, and a power of ten for
/// an exponent: "−3.1·10⁻⁵" of "-3.1e-05", "24 841" of "24841" (with a narrow space that doesn't break). What follows
/// the number, as its unit, stays.
std::string typeset(std::string_view number);

}  // namespace breakaway
