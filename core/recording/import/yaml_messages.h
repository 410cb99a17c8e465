// Messages as YAML documents, one after the other, as `ros2 topic echo` and `rostopic echo` print them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// One row per document; lines of three dashes part them. A number is called by the keys that lead to it,
/// "header.stamp.sec", one in a list by its place, "gains[0]", or where the message names its items ("name",
/// "joint_names") by theirs: "elbow/position". Texts are left out, and so are documents that are no mapping, and a last
/// one that lacks what the others have; a remark says so. Nothing: the text is none.
std::optional<Result<RawTable>> readYamlMessages(std::string_view text, const std::string& name);

}  // namespace breakaway
