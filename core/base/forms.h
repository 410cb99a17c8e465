// The names of forms of files that more than one room reads or writes.
#pragma once

namespace breakaway {

/// Of diagnosis.json, and of `diagnosis` in a batch's results.
inline constexpr const char* diagnosisForm = "breakaway.diagnosis/1";

}  // namespace breakaway
