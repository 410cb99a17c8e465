#include "commission/progress_writer.h"

#include <chrono>
#include <utility>

#include "commission/commission_progress.h"

namespace breakaway {

ProgressWriter::ProgressWriter(std::string folder) : folder_(std::move(folder)) {
}

ProgressWriter::~ProgressWriter() {
  static_cast<void>(finish());
}

Result<void> ProgressWriter::keep(const Commission& known) {
  wrote_ = true;
  if (writing_.valid()) {
    if (writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      later_ = known;
      return {};
    }
    if (auto before = writing_.get(); !before) return before;
  }
  later_.reset();
  writing_ = std::async(std::launch::async, [known, folder = folder_] { return writeProgress(known, folder); });
  return {};
}

Result<void> ProgressWriter::finish() {
  Result<void> written;
  if (writing_.valid()) written = writing_.get();
  if (written && later_) written = writeProgress(*later_, folder_);
  later_.reset();
  return written;
}

}  // namespace breakaway
