#include "recording/import/known_tools.h"

#include <utility>

#include "recording/import/joined_stamps.h"
#include "recording/import/known_controllers.h"
#include "recording/import/known_drives.h"
#include "recording/import/known_scopes.h"
#include "recording/import/known_simplefoc.h"

namespace breakaway {

ToolColumns recogniseTool(RawTable& table, double countsPerRev) {
  joinStamps(table);
  if (auto scope = recogniseScope(table)) return std::move(*scope);
  if (auto controller = recogniseController(table)) return std::move(*controller);
  if (auto drive = recogniseDrive(table, countsPerRev)) return std::move(*drive);
  if (auto monitor = recogniseSimpleFoc(table)) return std::move(*monitor);
  return {};
}

}  // namespace breakaway
