// Oscilloscopes and measuring programs, by the head of their files.
#pragma once

#include <optional>

#include "recording/import/known_tools.h"

namespace breakaway {

/// LabVIEW's .lvm, Rigol's sequence with start and increment, the older Tektronix form whose head stands beside the
/// rows; and any head that tells a sample interval or rate where no column is a time.
std::optional<ToolColumns> recogniseScope(RawTable& table);

}  // namespace breakaway
