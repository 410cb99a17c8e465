#include "project/stage.h"

#include <filesystem>
#include <system_error>
#include <vector>

#include "base/atomic_file.h"
#include "base/uuid.h"

namespace breakaway {

namespace fs = std::filesystem;

namespace {

constexpr const char* prefix = ".adding-";

}  // namespace

Stage::Stage(const std::string& project) : path_(project + "/" + prefix + freshUuid()) {
}

Stage::~Stage() {
  std::error_code code;
  if (!placed_) fs::remove_all(path_, code);
}

Result<void> Stage::make() {
  return makeFolder(path_);
}

Result<void> Stage::place(const std::string& at) {
  syncTree(path_);
  std::error_code code;
  fs::rename(path_, at, code);
  if (code) return Error{at, "cannot be put in place: " + code.message()};
  placed_ = true;
  syncTree(fs::path(at).parent_path().string() + "/.");
  return {};
}

size_t clearStages(const std::string& project) {
  std::error_code code;
  std::vector<fs::path> left;
  for (const auto& one : fs::directory_iterator(project, code)) {
    if (one.path().filename().string().starts_with(prefix)) left.push_back(one.path());
  }
  for (const fs::path& one : left) fs::remove_all(one, code);
  return left.size();
}

}  // namespace breakaway
