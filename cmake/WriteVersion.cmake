# Writes OUT, the one source that knows the version: VERSION, and the commit of the checkout SOURCE where there is one.
# Run at every build; the file is touched only if it changes.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=10 --exclude=*
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
set(text ${VERSION})
if(NOT failed AND commit)
  string(APPEND text "+${commit}")
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT [[#include "version.h"

namespace breakaway {

std::string_view versionText() {
  return "@text@";
}

}  // namespace breakaway
]] @ONLY)
