// Programs and boards whose logs mean more than their columns' names tell.
#pragma once

#include <map>
#include <string>

#include "recording/import/column_name.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// What is known of the columns of a tool's log, by their names; the others go by their names and units.
using ToolColumns = std::map<std::string, ColumnName>;

/// Recognises a tool by its signature, says so in a remark, and tells what its columns are. May name columns, and add a
/// time that the file's head tells (a sample interval, a start and an increment). Known are VESC Tool, ODrive, moteus,
/// SimpleFOC's monitor, Betaflight's decoder, Dynamixel registers, LabVIEW, Rigol and Tektronix oscilloscopes, and
/// stamps in seconds and nanoseconds (ROS). `countsPerRev` goes before a tool's own.
ToolColumns recogniseTool(RawTable& table, double countsPerRev = 0.0);

}  // namespace breakaway
