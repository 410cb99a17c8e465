// Files of blocks as recordings and as CSV.
#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <utility>

#include "base/exact_text.h"
#include "base/file_in_pieces.h"
#include "base/made_input.h"
#include "base/sha256.h"
#include "recording/block_file.h"
#include "recording/csv.h"
#include "recording/csv_rows.h"

namespace breakaway {

namespace {

constexpr size_t mostGapsNoted = 100;

/// The head's notes, and what the blocks tell beside the rows.
std::vector<std::pair<std::string, std::string>> notesOf(const BlockSurvey& survey) {
  auto notes = survey.head.notes;
  for (size_t k = 0; k < std::min(survey.gaps.size(), mostGapsNoted); ++k)
    notes.emplace_back(
        "gap", fmt::format("{} samples lost after {} s", survey.gaps[k].lost, exactText(survey.gaps[k].after_s)));
  for (size_t k = 0; k < std::min(survey.holes.size(), mostGapsNoted); ++k)
    notes.emplace_back("damaged", fmt::format("{} bytes of the file after {} s", survey.holes[k].bytes,
                                              exactText(survey.holes[k].after_s)));
  if (survey.lost() > 0) notes.emplace_back("lost_samples", std::to_string(survey.lost()));
  if (survey.repeated > 0)
    notes.emplace_back("left_out", fmt::format("{} rows whose time didn't grow", survey.repeated));
  if (!survey.why.empty()) notes.emplace_back("ended_by", survey.why);
  if (!survey.ended) notes.emplace_back("ended_by", "a kill or a loss of power: the last second may be missing");
  return notes;
}

}  // namespace

Result<Recording> readBlocks(const std::string& path) {
  const auto survey = surveyBlocks(path);
  if (!survey) return survey.error();
  if (survey->rows == 0) return Error{path, "holds no sample"};
  std::vector<Channel> channels;
  for (const std::string& name : survey->head.columns) {
    channels.push_back({name, {}});
    channels.back().values.reserve(survey->rows);
  }
  auto reader = BlockReader::open(path);
  if (!reader) return reader.error();
  for (std::vector<double> rows; reader->next(rows);) {
    for (size_t k = 0; k < rows.size(); ++k) channels[k % channels.size()].values.push_back(rows[k]);
  }
  return Recording::seal(path, std::move(channels), notesOf(reader->survey()));
}

Result<Recording> readRecording(const std::string& path) {
  if (!isBlockFile(path)) return readCsv(path);
  const auto hash = sha256OfFile(path);
  if (!hash) return hash.error();
  noteInputFile({path, *hash});
  return readBlocks(path);
}

Result<void> writeBlocksAsCsv(const std::string& path, const std::string& csv) {
  const auto survey = surveyBlocks(path);
  if (!survey) return survey.error();
  if (survey->rows == 0) return Error{path, "holds no sample"};
  auto reader = BlockReader::open(path);
  if (!reader) return reader.error();
  const size_t width = survey->head.columns.size();
  std::string head = csvHead(notesOf(*survey), survey->head.columns);
  std::vector<double> rows;
  return writeFileInPieces(csv, [&]() -> Result<std::string> {
    if (!head.empty()) return std::exchange(head, {});
    std::string text;
    if (reader->next(rows)) {
      for (size_t k = 0; k < rows.size(); k += width) appendCsvRow(text, std::span(rows).subspan(k, width));
    }
    return text;
  });
}

}  // namespace breakaway
