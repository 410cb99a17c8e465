#include "base/output_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>
#include <utility>

#include "base/atomic_file.h"
#include "base/made.h"

namespace breakaway {

namespace fs = std::filesystem;

namespace {

constexpr const char* listPrefix = ".breakaway-files-";

using Names = std::set<std::string>;

Error systemError(const fs::path& path, const std::string& what, int number) {
  return {path.string(), what + ": " + std::error_code(number, std::generic_category()).message()};
}

/// All files and links below `folder`, by their names from there.
Names filesIn(const fs::path& folder) {
  Names names;
  std::error_code code;
  for (const auto& one : fs::recursive_directory_iterator(folder, code)) {
    std::error_code unknown;
    if (!one.is_directory(unknown) || one.is_symlink(unknown)) names.insert(one.path().lexically_relative(folder));
  }
  return names;
}

bool isBelow(const std::string& file, const std::string& name) {
  return file == name || file.starts_with(name + "/");
}

/// A name in a list of files leads nowhere else.
bool staysBelow(const std::string& name) {
  const fs::path path(name);
  return !path.empty() && path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

Names listedIn(const fs::path& list) {
  Names names;
  std::ifstream in(list);  // no input of the run
  for (std::string line; std::getline(in, line);) {
    if (staysBelow(line)) names.insert(line);
  }
  return names;
}

std::string textOf(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += name + "\n";
  return text;
}

/// The lists of other commands in `folder` that hold one of the names or something below.
std::string otherOwner(const fs::path& folder, const OutputPlan& plan) {
  std::error_code code;
  for (const auto& one : fs::directory_iterator(folder, code)) {
    const std::string list = one.path().filename();
    if (!list.starts_with(listPrefix) || list == listPrefix + plan.command) continue;
    for (const std::string& file : listedIn(one.path())) {
      for (const std::string& name : plan.names) {
        if (isBelow(file, name)) return file + " of " + list.substr(std::string(listPrefix).size());
      }
    }
  }
  return {};
}

/// Where the files are written until they are whole: the same for everyone who fills that folder.
fs::path stageFor(const fs::path& folder) {
  const fs::path parent = folder.parent_path();
  struct stat here {
  }, above{};
  const bool exists = ::stat(folder.c_str(), &here) == 0;
  const bool beside = ::access(parent.c_str(), W_OK | X_OK) == 0 &&
                      (!exists || (::stat(parent.c_str(), &above) == 0 && above.st_dev == here.st_dev)) &&
                      folder != parent;
  return beside ? parent / ("." + folder.filename().string() + ".breakaway-part") : folder / ".breakaway-part";
}

/// The folder itself, links followed, as an absolute path; its parents are made.
Result<fs::path> placeOf(const std::string& name) {
  std::error_code code;
  fs::path place = fs::weakly_canonical(fs::absolute(name), code);
  if (code) return Error{name, "cannot be created as a folder: " + code.message()};
  if (place.filename().empty()) place = place.parent_path();
  if (fs::exists(place, code) && !fs::is_directory(place, code)) return Error{name, "is a file, expected a folder"};
  return place;
}

/// An open folder that is locked as long as this lives.
class FolderLock {
 public:
  FolderLock() = default;
  FolderLock(FolderLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock() {
    if (file_ >= 0) ::close(file_);
  }

  /// 0, or the system's reason; EWOULDBLOCK: another has it.
  int take(const fs::path& folder) {
    file_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (file_ < 0 || ::flock(file_, LOCK_EX | LOCK_NB) != 0) return errno;
    struct stat mine {
    }, there{};
    if (::fstat(file_, &mine) != 0 || ::stat(folder.c_str(), &there) != 0) return errno;
    return mine.st_ino == there.st_ino && mine.st_dev == there.st_dev ? 0 : EWOULDBLOCK;
  }

 private:
  int file_ = -1;
};

/// Removes these files of `folder`, and folders that are empty then.
void removeFiles(const fs::path& folder, const Names& names) {
  std::error_code code;
  for (const std::string& name : names) {
    fs::remove(folder / name, code);
    for (fs::path parent = fs::path(name).parent_path(); !parent.empty(); parent = parent.parent_path()) {
      if (::rmdir((folder / parent).c_str()) != 0) break;
    }
  }
}

}  // namespace

struct OutputFolder::State {
  OutputPlan plan;
  fs::path place, stage;
  FolderLock lock;
  Names earlier;                  ///< files of this command's earlier run
  Names put;                      ///< in place, of this run
  std::vector<fs::path> parents;  ///< that were made, the deepest first
  bool replaces = false;          ///< an earlier run's files
  bool filled = true;             ///< nothing is left to be cleared away

  fs::path list() const { return place / (listPrefix + plan.command); }
  Result<void> check();
  Result<void> makeParents();
  Result<void> clearStage();
  Result<void> inOneStep(const Names& files, const std::vector<std::string>& left);
  Result<void> fileByFile(const Names& files, const std::vector<std::string>& left);
  Result<void> putInPlace(const std::vector<std::string>& left);
  bool isOurs(const std::string& file, const std::vector<std::string>& left) const;
  Error asIfInPlace(const Error& error) const;
};

Result<void> OutputFolder::State::check() {
  std::error_code code;
  if (!fs::exists(place, code)) return {};
  if (::access(place.c_str(), W_OK | X_OK) != 0) return systemError(plan.folder, "cannot be written", errno);
  if (const std::string other = otherOwner(place, plan); !other.empty())
    return Error{plan.folder, "holds " + other + ", expected another folder"};
  for (const std::string& name : plan.names) {
    const fs::path file = place / name;
    if (isAmong(file.string(), plan.inputs))
      return Error{plan.folder, name + " in it is an input and would be replaced, expected another folder"};
    if (fs::is_regular_file(file, code)) {
      if (auto good = checkOutput(file.string()); !good) return good;
    }
  }
  earlier = listedIn(list());
  replaces = !earlier.empty() || fs::exists(place / plan.names.back(), code);
  for (const std::string& name : earlier) {
    if (isAmong((place / name).string(), plan.inputs))
      return Error{plan.folder, name + " in it is an input and would be replaced, expected another folder"};
  }
  return {};
}

Result<void> OutputFolder::State::makeParents() {
  std::error_code code;
  for (fs::path one = place.parent_path(); !fs::exists(one, code) && one.has_relative_path(); one = one.parent_path())
    parents.push_back(one);
  const auto made = makeFolder(place.parent_path().string());
  return made ? made : Error{plan.folder, made.error().fact};
}

/// Takes the lock, and removes what a killed run left.
Result<void> OutputFolder::State::clearStage() {
  stage = stageFor(place);
  std::error_code code;
  fs::create_directories(stage, code);
  if (code) return Error{plan.folder, "cannot be written: " + code.message()};
  const int failed = lock.take(stage);
  if (failed == EWOULDBLOCK) return Error{plan.folder, "another process writes into it"};
  if (failed != 0) return systemError(plan.folder, "cannot be written", failed);
  filled = false;
  for (const auto& one : fs::directory_iterator(stage, code)) {
    std::error_code kept;
    fs::remove_all(one.path(), kept);
    if (kept) return Error{one.path().string(), "cannot be removed: " + kept.message()};
  }
  return {};
}

bool OutputFolder::State::isOurs(const std::string& file, const std::vector<std::string>& left) const {
  return earlier.contains(file) || file == list().filename() ||
         std::any_of(left.begin(), left.end(), [&](const std::string& name) { return isBelow(file, name); });
}

/// Precondition: nothing but ours is in the place.
Result<void> OutputFolder::State::inOneStep(const Names& files, const std::vector<std::string>& left) {
  struct stat there {};
  if (::stat(place.c_str(), &there) != 0) {
    if (::rename(stage.c_str(), place.c_str()) != 0) return systemError(plan.folder, "cannot be put in place", errno);
    syncTree(place.parent_path() / ".");
    return {};
  }
  FolderLock old;  // which has the stage's name afterwards, for those who come then
  if (const int failed = old.take(place); failed != 0) return systemError(plan.folder, "cannot be locked", failed);
  ::chmod(stage.c_str(), there.st_mode & 07777);
  if (::chown(stage.c_str(), there.st_uid, there.st_gid) != 0) {
    // a shared folder of another's: the new one is ours
  }
  if (::renameat2(AT_FDCWD, stage.c_str(), AT_FDCWD, place.c_str(), RENAME_EXCHANGE) != 0)
    return fileByFile(files, left);
  for (const std::string& name : left) {
    std::error_code code;
    fs::remove_all(stage / name, code);
  }
  Names gone = earlier;
  gone.insert(list().filename());
  removeFiles(stage, gone);
  std::error_code code;
  for (const auto& one : fs::directory_iterator(stage, code)) {  // came in between: another's
    const fs::path back = place / one.path().filename();
    if (!fs::exists(fs::symlink_status(back, code))) fs::rename(one.path(), back, code);
  }
  ::rmdir(stage.c_str());
  return {};
}

Result<void> OutputFolder::State::fileByFile(const Names& files, const std::vector<std::string>& left) {
  Names both = earlier;
  both.insert(files.begin(), files.end());
  if (auto told = writeFile(list().string(), textOf(both)); !told) return told;
  const std::string& last = plan.names.back();
  std::error_code code;
  fs::remove(place / last, code);
  Names stale = earlier;
  for (const std::string& name : files) stale.erase(name);
  removeFiles(place, stale);
  std::vector<std::string> order;
  for (const std::string& name : files) {
    if (name != last) order.push_back(name);
  }
  if (files.contains(last)) order.push_back(last);
  for (const std::string& name : order) {
    const fs::path to = place / name;
    if (auto made = makeFolder(to.parent_path().string()); !made) return made;
    if (fs::is_symlink(to, code)) {
      const OwnInputs ours;  // it is no input
      const auto content = readFile((stage / name).string());
      if (!content) return content.error();
      if (auto written = writeFile(to.string(), *content); !written) return written;
    } else if (::rename((stage / name).c_str(), to.c_str()) != 0) {
      return systemError(to, "cannot be put in place", errno);
    }
  }
  for (const std::string& name : left) fs::remove_all(place / name, code);
  fs::remove_all(stage, code);
  return writeFile(list().string(), textOf(files));
}

Result<void> OutputFolder::State::putInPlace(const std::vector<std::string>& left) {
  const Names files = filesIn(stage);
  std::error_code code;
  for (const std::string& name : files) {  // a file that is there keeps its mode
    struct stat there {};
    if (::lstat((place / name).c_str(), &there) == 0 && S_ISREG(there.st_mode))
      ::chmod((stage / name).c_str(), there.st_mode & 07777);
  }
  if (auto listed = writeFile((stage / list().filename()).string(), textOf(files)); !listed) return listed;
  syncTree(stage.string());
  const Names there = filesIn(place);
  const bool alone = std::all_of(there.begin(), there.end(), [&](const std::string& one) { return isOurs(one, left); });
  const bool beside = stage.parent_path() == place.parent_path();
  const bool stoodIn = fs::equivalent(fs::current_path(code), place, code);
  Result<void> done = alone && beside && !stoodIn ? inOneStep(files, left) : fileByFile(files, left);
  syncTree(place.string());
  if (done) put = files;
  return done;
}

Error OutputFolder::State::asIfInPlace(const Error& error) const {
  const std::string from = stage.string();
  if (!error.place.starts_with(from)) return error;
  return {plan.folder + error.place.substr(from.size()), error.fact};
}

OutputFolder::OutputFolder(std::unique_ptr<State> state) : state_(std::move(state)) {
}
OutputFolder::OutputFolder(OutputFolder&&) noexcept = default;
OutputFolder& OutputFolder::operator=(OutputFolder&&) noexcept = default;

OutputFolder::~OutputFolder() {
  if (!state_ || state_->filled || state_->stage.empty()) return;
  std::error_code code;
  fs::remove_all(state_->stage, code);
  for (const fs::path& one : state_->parents) ::rmdir(one.c_str());
}

Result<OutputFolder> OutputFolder::open(OutputPlan plan) {
  if (plan.folder.empty()) return Error{"output", "has an empty name, expected a folder"};
  if (plan.folder == "-") return Error{"-", "is standard output, expected a folder"};
  auto state = std::make_unique<State>();
  state->plan = std::move(plan);
  auto place = placeOf(state->plan.folder);
  if (!place) return place.error();
  state->place = std::move(*place);
  if (auto good = state->check(); !good) return good.error();
  if (auto made = state->makeParents(); !made) return made.error();
  if (auto cleared = state->clearStage(); !cleared) return cleared.error();
  nameFolder(state->stage.string(), state->plan.folder);
  return OutputFolder(std::move(state));
}

std::string OutputFolder::inWords() const {
  return state_->replaces ? state_->plan.folder + ": what an earlier run left there is replaced\n" : std::string();
}

std::vector<std::string> OutputFolder::files() const {
  return {state_->put.begin(), state_->put.end()};
}

Result<void> OutputFolder::fill(const std::function<Result<void>(const std::string& folder)>& write,
                                const std::vector<std::string>& left) {
  if (auto written = write(state_->stage.string()); !written) return state_->asIfInPlace(written.error());
  auto done = state_->putInPlace(left);
  if (done) state_->filled = true;
  return done ? done : state_->asIfInPlace(done.error());
}

}  // namespace breakaway
