// What a commissioning found, as files: bench, recordings, map, report.
#pragma once

#include <optional>
#include <string>

#include "base/catalogue.h"
#include "base/message.h"
#include "base/result.h"
#include "commission/known.h"

namespace breakaway {

/// Writes bench.json, motor.json, recordings/*.csv, map.json, map.csv and report.html into `folder`, and truth.csv when
/// there is a truth; the report in `language`.
Result<void> writeCommission(const Commission& commission, const std::optional<FrictionMap>& truth,
                             const std::string& folder, const Catalogue& language = {});

/// Writes what is known as one HTML file in `language`, whatever of the job was made so far. Errors: the motor isn't
/// identified; the file.
Result<void> writeReport(const Commission& known, bool hasTruth, const std::string& path,
                         const Catalogue& language = {});

/// Writes one step's recording to recordings/STEP.csv in `folder`.
Result<void> writeStep(const std::string& step, const Recording& recording, const std::string& folder);

/// What a commissioning that ends with the motor leaves: bench.json and motor.json.
Result<void> writeIdentification(const Commission& commission, const std::string& folder);

/// The motor in a few lines of plain text, each value with its interval.
Message motorInWords(const Commission& commission);

/// The averages in a few lines of plain text.
Message inWords(const Commission& commission);

}  // namespace breakaway
