// Recordings of dSPACE's ControlDesk: its CSV files, and what its MATLAB structures have in common with them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// A CSV file with sections, one per raster, each of lines that begin with what they hold: `trace_names`, `path`,
/// `unit`, …, and the rows behind `trace_values`, stamps first. Rows are at the stamps of the angle, signals of other
/// rasters hold their last value. Nothing: the text is none.
std::optional<Result<RawTable>> readControlDeskText(std::string_view text, char lineEnd, const std::string& name);

/// What a signal is called: by its name alone if that names a quantity, else ("Out1") with the block it comes from, the
/// last part of its path in the model; the block's first port has the block's name.
std::string nameInModel(std::string_view name, std::string_view path);

}  // namespace breakaway
