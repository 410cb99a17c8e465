// Programs as text of a language.
#pragma once

#include <string>

#include "export/portable/program.h"

namespace breakaway {

/// One header of C99 that needs the standard library's mathematics only; names begin with the program's.
std::string cText(const Program& program);
/// One module of Python 3 that needs `math` only.
std::string pythonText(const Program& program);
/// One class file, the program's name with .m: constants and static methods on a struct.
std::string matlabText(const Program& program);
/// One package: constants, the record State, functions, and the block Sampled, which makes a step every `dt_s`.
std::string modelicaText(const Program& program);

}  // namespace breakaway
