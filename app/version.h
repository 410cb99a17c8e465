// Which Breakaway this is.
#pragma once

#include <string_view>

namespace breakaway {

/// "0.2.0+1a2b3c4d5e": the project's version, and the commit it was built from where that is known. Its one source is
/// generated (cmake/WriteVersion.cmake), and only programs link it.
std::string_view versionText();

}  // namespace breakaway
