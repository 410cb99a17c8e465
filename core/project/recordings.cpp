// Runs whose recording grows on disk: how they begin, how they end, and what is made of those that a kill ended.
#include <filesystem>
#include <system_error>

#include "base/uuid.h"
#include "project/project.h"
#include "project/project_lock.h"
#include "project/run_contents.h"
#include "project/stage.h"

namespace breakaway {

namespace fs = std::filesystem;

namespace {

/// "12.3 s, 61500 samples, 12 lost, 1616 bytes damaged".
Message lengthOf(const BlockSurvey& survey) {
  Message words = message("{:.1f} s, {} samples", survey.last_s - survey.first_s, survey.rows);
  if (survey.lost() > 0) words = words + message(", {} lost", survey.lost());
  if (survey.unreadable() > 0) words = words + message(", {} bytes damaged", survey.unreadable());
  return words;
}

}  // namespace

Result<ProjectRun> Project::beginRecording(ProjectRun run, const BlockHead& head, std::optional<BlockWriter>& blocks) {
  const ProjectLock lock(folder_, ProjectLock::Way::shared);  // not taken for a recording that a kill has left
  run.kind = "recording";
  run.at = utcNow();
  run.id = freshUuid().substr(0, 8);
  run.state = RunState::recording;
  run.folder = folderFor(run);
  run.files = {{recordingFile, "recording", 0, ""}};
  const std::string folder = folder_ + "/" + run.folder;
  Stage stage(folder_);
  if (auto made = stage.make(); !made) return made.error();
  if (auto written = writeRunFile(run, stage.path()); !written) return written.error();
  if (auto placed = stage.place(folder); !placed) return placed.error();
  auto opened = BlockWriter::create(folder + "/" + recordingFile, head);
  if (!opened) {
    std::error_code code;
    fs::remove_all(folder, code);
    return opened.error();
  }
  blocks.emplace(std::move(*opened));
  static_cast<void>(index_->follow(said_));  // it follows at the next opening, else
  return run;
}

Result<ProjectRun> Project::endRecording(const ProjectRun& begun, const std::string& why) {
  const std::string folder = folder_ + "/" + begun.folder;
  ProjectRun run = begun;
  if (const auto noted = runOnDisk(folder_, begun.folder)) run = *noted;  // a name may have come since
  const auto survey = surveyBlocks(folder + "/" + recordingFile);
  const auto contents = contentsOf(folder);
  if (!contents) return contents.error();
  run.files = contents->files;
  run.state = why.empty() ? RunState::whole : RunState::cut;
  run.verdict = survey ? lengthOf(*survey).english() : "nothing was recorded";
  if (!why.empty()) run.verdict += "; ended by: " + why;
  if (auto written = writeRunFile(run, folder); !written) return written.error();
  if (auto followed = index_->follow(said_); !followed) return followed.error();
  return run;
}

/// Recordings that nobody writes any more, though they haven't ended.
Result<void> Project::mendRecordings() {
  const auto runs = index_->list({.kind = "recording"});
  if (!runs) return runs.error();
  for (const ProjectRun& run : *runs) {
    const std::string file = pathOf(run, recordingFile);
    if (run.state != RunState::recording || isBeingWritten(file)) continue;
    const Message killed = message("a kill or a loss of power: the last second may be missing");
    const auto mended = mendBlocks(file, killed);
    const Message why = !mended ? message("a kill or a loss of power, before anything was recorded")
                        : mended->why == killed.english() ? killed
                                                          : Message(mended->why);
    const auto ended = endRecording(run, why);
    if (!ended) {  // the disk may be full, or another's: the project can be read all the same
      said_.push_back(
          message("{}; the recording of {} was cut short and is not mended yet", ended.error().said(), run.at));
      continue;
    }
    Message left = mended ? lengthOf(*mended) : message("nothing was recorded");
    if (!why.empty()) left = left + "; " + message("ended by: {}", why);
    said_.push_back(message("{}: the recording of {} was cut short and is mended: {}", folder_, run.at, left));
  }
  return {};
}

}  // namespace breakaway
