#include "project/run_index.h"

#include <fmt/core.h>

#include <filesystem>
#include <map>

#include "base/atomic_file.h"
#include "base/file_status.h"
#include "base/made.h"
#include "base/uuid.h"
#include "project/sqlite.h"

namespace breakaway {

namespace fs = std::filesystem;

namespace {

/// The index's form: one of another number is made anew.
constexpr std::int64_t version = 1;

constexpr const char* tables = R"sql(
  PRAGMA synchronous = OFF;
  CREATE TABLE runs (folder TEXT PRIMARY KEY, stamp TEXT, id TEXT, kind TEXT, state TEXT, name TEXT, remark TEXT,
                     motor TEXT, device TEXT, serial TEXT, at TEXT, command TEXT, verdict TEXT, text TEXT);
  CREATE INDEX runs_id ON runs (id);
  CREATE INDEX runs_motor ON runs (motor, at);
  CREATE INDEX runs_at ON runs (at);
  CREATE TABLE vals (folder TEXT, name TEXT, value REAL, low REAL, high REAL);
  CREATE INDEX vals_folder ON vals (folder);
  CREATE TABLE files (folder TEXT, sha256 TEXT);
  CREATE INDEX files_folder ON files (folder);
  CREATE INDEX files_sha256 ON files (sha256);
)sql";

/// The stamps of all runs on disk, by folder ("runs/…").
Result<std::map<std::string, std::string>> runsOnDisk(const std::string& project) {
  std::map<std::string, std::string> found;
  std::error_code code;
  for (const auto& one : fs::directory_iterator(project + "/runs", code)) {
    const std::string name = "runs/" + one.path().filename().string();
    const std::string stamp = stampOfFile(project + "/" + name + "/run.json");
    if (!stamp.empty()) found.emplace(name, stamp);
  }
  if (code) return Error{project + "/runs", "cannot be read: " + code.message()};
  return found;
}

std::string conditions(const RunFilter& filter) {
  std::string text = " WHERE 1";
  if (!filter.motor.empty()) text += " AND motor = ?1";
  if (!filter.kind.empty()) text += " AND kind = ?2";
  if (!filter.device.empty()) text += " AND (device = ?3 OR serial = ?3)";
  if (!filter.since.empty()) text += " AND at >= ?4";
  if (!filter.until.empty()) text += " AND substr(at, 1, length(?5)) <= ?5";
  if (!filter.text.empty())
    text +=
        " AND instr(lower(runs.name || ' ' || remark || ' ' || runs.folder || ' ' || verdict || ' ' || command), "
        "lower(?6))";
  return text;
}

void bindTo(Query& query, const RunFilter& filter) {
  const std::string* const texts[] = {&filter.motor, &filter.kind,  &filter.device,
                                      &filter.since, &filter.until, &filter.text};
  for (int k = 0; k < 6; ++k) {
    if (!texts[k]->empty()) query.bind(k + 1, *texts[k]);
  }
}

}  // namespace

struct RunIndex::State {
  std::string project;
  Database database;
  bool fresh = false;  ///< made by this call
  size_t indexed = 0;  ///< runs that it was made from

  std::string file() const { return project + "/index.sqlite"; }
  Result<void> fill(const std::string& path, std::vector<Message>& said);
  Result<void> make(std::vector<Message>& said, const Message& why);
  Result<void> openThere(std::vector<Message>& said);
  Result<void> follow(std::map<std::string, std::string> there, std::vector<Message>& said) const;
  Result<void> take(const std::map<std::string, std::string>& changed, const std::vector<std::string>& gone,
                    std::vector<Message>& said) const;
  Result<void> put(const std::string& folder, const std::string& stamp, std::vector<Message>& said) const;
};

RunIndex::RunIndex(std::unique_ptr<State> state) : state_(std::move(state)) {
}
RunIndex::RunIndex(RunIndex&&) noexcept = default;
RunIndex& RunIndex::operator=(RunIndex&&) noexcept = default;
RunIndex::~RunIndex() = default;

/// A new index with all runs on disk, in the file or in memory.
Result<void> RunIndex::State::fill(const std::string& path, std::vector<Message>& said) {
  const auto there = runsOnDisk(project);
  if (!there) return there.error();
  auto opened = Database::open(path);
  if (!opened) return opened.error();
  database = std::move(*opened);
  if (auto made = database.run(fmt::format("{}; PRAGMA user_version = {}", tables, version)); !made) return made;
  indexed = there->size();
  return take(*there, {}, said);
}

/// Beside the place of the old one, and then in it; in memory where nothing can be written.
Result<void> RunIndex::State::make(std::vector<Message>& said, const Message& why) {
  fresh = true;
  const std::string part = project + "/.index-" + freshUuid();
  std::vector<Message> told;
  bool onDisk = mayBeWritten(project) && fill(part, told).ok();
  database = Database();
  std::error_code code;
  for (const char* rest : {"-journal", "-wal", "-shm"}) {
    if (onDisk) fs::remove(file() + rest, code);
  }
  if (onDisk) {
    fs::rename(part, file(), code);
    onDisk = !code;
  }
  fs::remove(part, code);
  fs::remove(part + "-journal", code);
  if (onDisk) {
    auto opened = Database::open(file());
    if (!opened) return opened.error();
    database = std::move(*opened);
    if (auto set = database.run("PRAGMA synchronous = OFF"); !set) return set;
  } else {
    told.clear();
    if (auto filled = fill(":memory:", told); !filled) return filled;
  }
  if (!why.empty() && indexed > 0) said.push_back(message("{} {}: made anew from {} runs", file(), why, indexed));
  said.insert(said.end(), told.begin(), told.end());
  return {};
}

Result<void> RunIndex::State::openThere(std::vector<Message>& said) {
  std::error_code code;
  if (!fs::exists(file(), code)) return make(said, message("was missing"));
  if (!mayBeWritten(file())) return make(said, {});
  auto opened = Database::open(file());
  if (!opened) return make(said, message("was damaged"));
  database = std::move(*opened);
  const auto found = database.number("PRAGMA user_version");
  Query sound(database, "PRAGMA quick_check(1)");
  if (!found || !sound.step() || sound.text(0) != "ok") return make(said, message("was damaged"));
  if (*found != version) return make(said, message("was of another version ({}, expected {})", *found, version));
  return database.run("PRAGMA synchronous = OFF");
}

Result<RunIndex> RunIndex::open(const std::string& folder, std::vector<Message>& said) {
  auto state = std::make_unique<State>();
  state->project = folder;
  if (auto there = state->openThere(said); !there) return there.error();
  RunIndex index(std::move(state));
  if (index.state_->fresh) return index;
  if (auto followed = index.follow(said); !followed) return followed.error();
  return index;
}

Result<void> RunIndex::rebuild(std::vector<Message>& said) {
  return state_->make(said, {});
}

Result<void> RunIndex::State::put(const std::string& folder, const std::string& stamp,
                                  std::vector<Message>& said) const {
  const OwnInputs ours;  // no input of the run
  const std::string path = project + "/" + folder + "/run.json";
  const auto text = readFile(path);
  const auto run = text ? readRunText(*text, path) : Result<ProjectRun>(text.error());
  if (!run) {
    said.push_back(message("{}; the run is left out", run.error().said()));
    return {};
  }
  Query insert(database,
               "INSERT OR REPLACE INTO runs VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14)");
  insert.bind(1, folder).bind(2, stamp).bind(3, run->id).bind(4, run->kind).bind(5, wordOf(run->state));
  insert.bind(6, run->name).bind(7, run->remark).bind(8, run->motor).bind(9, run->device);
  insert.bind(10, run->deviceSerial).bind(11, run->at).bind(12, run->command).bind(13, run->verdict).bind(14, *text);
  insert.step();
  if (auto done = insert.done(); !done) return done;
  Query value(database, "INSERT INTO vals VALUES (?1, ?2, ?3, ?4, ?5)");
  for (const RunValue& one : run->values) {
    value.bind(1, folder).bind(2, one.name).bind(3, one.value).bind(4, one.low).bind(5, one.high).step();
    value.again();
  }
  Query file(database, "INSERT INTO files VALUES (?1, ?2)");
  for (const RunFile& one : run->files) {
    if (one.sha256.empty()) continue;
    file.bind(1, folder).bind(2, one.sha256).step();
    file.again();
  }
  return value.done() ? file.done() : value.done();
}

Result<void> RunIndex::State::take(const std::map<std::string, std::string>& changed,
                                   const std::vector<std::string>& gone, std::vector<Message>& said) const {
  if (changed.empty() && gone.empty()) return {};
  if (auto begun = database.run("BEGIN IMMEDIATE"); !begun) return begun;
  Result<void> done;
  const auto forget = [&](const std::string& folder) {
    for (const char* table : {"runs", "vals", "files"}) {
      Query remove(database, std::string("DELETE FROM ") + table + " WHERE folder = ?1");
      remove.bind(1, folder).step();
      if (done) done = remove.done();
    }
  };
  for (const std::string& folder : gone) forget(folder);
  for (const auto& [folder, stamp] : changed) {
    forget(folder);
    if (done) done = put(folder, stamp, said);
  }
  if (!done) {
    static_cast<void>(database.run("ROLLBACK"));
    return done;
  }
  return database.run("COMMIT");
}

Result<void> RunIndex::follow(std::vector<Message>& said) {
  auto there = runsOnDisk(state_->project);
  if (!there) return there.error();
  if (state_->follow(*there, said)) return {};
  // Tables that are not what they should be, or were damaged while they were open.
  return state_->make(said, message("was damaged"));
}

Result<void> RunIndex::State::follow(std::map<std::string, std::string> there, std::vector<Message>& said) const {
  std::vector<std::string> gone;
  Query known(database, "SELECT folder, stamp FROM runs");
  while (known.step()) {
    const auto it = there.find(known.text(0));
    if (it == there.end()) {
      gone.push_back(known.text(0));
    } else if (it->second == known.text(1)) {
      there.erase(it);
    }
  }
  if (auto done = known.done(); !done) return done;
  return take(there, gone, said);
}

Result<std::vector<ProjectRun>> RunIndex::list(const RunFilter& filter) const {
  const std::string limit = filter.most > 0 ? " LIMIT " + std::to_string(filter.most) : std::string();
  Query query(state_->database,
              "SELECT folder, id, kind, state, name, remark, motor, device, serial, at, command, verdict FROM runs" +
                  conditions(filter) + " ORDER BY at DESC, folder DESC" + limit);
  bindTo(query, filter);
  std::vector<ProjectRun> runs;
  while (query.step()) {
    ProjectRun run;
    run.folder = query.text(0);
    run.id = query.text(1);
    run.kind = query.text(2);
    const std::string state = query.text(3);
    run.state = state == "cut" ? RunState::cut : state == "recording" ? RunState::recording : RunState::whole;
    run.name = query.text(4);
    run.remark = query.text(5);
    run.motor = query.text(6);
    run.device = query.text(7);
    run.deviceSerial = query.text(8);
    run.at = query.text(9);
    run.command = query.text(10);
    run.verdict = query.text(11);
    runs.push_back(std::move(run));
  }
  if (auto done = query.done(); !done) return done.error();
  return runs;
}

Result<ProjectRun> RunIndex::find(const std::string& key) const {
  const bool last = key == "last";
  Query query(state_->database, last ? "SELECT folder, text FROM runs ORDER BY at DESC, folder DESC LIMIT 1"
                                     : "SELECT folder, text FROM runs WHERE folder = ?1 OR folder = 'runs/' || ?1 OR "
                                       "name = ?1 OR substr(id, 1, length(?1)) = ?1 OR (?1 GLOB "
                                       "'[0-9][0-9][0-9][0-9]-[0-9][0-9]-[0-9][0-9]*' AND substr(at, 1, length(?1)) = "
                                       "?1) ORDER BY at DESC");
  if (!last) query.bind(1, key);
  std::vector<std::pair<std::string, std::string>> found;
  while (!key.empty() && query.step()) found.emplace_back(query.text(0), query.text(1));
  if (auto done = query.done(); !done) return done.error();
  if (found.empty())
    return Error{state_->project,
                 "has no run \"" + key + "\", expected an identifier, a name, a date or last; see list"};
  if (found.size() > 1)
    return Error{state_->project,
                 fmt::format("has {} runs \"{}\", expected the identifier of one; see list", found.size(), key)};
  auto run = readRunText(found[0].second, state_->project + "/" + found[0].first + "/run.json");
  if (run) run->folder = found[0].first;
  return run;
}

Result<bool> RunIndex::holds(const std::string& sha256) const {
  Query query(state_->database, "SELECT 1 FROM files WHERE sha256 = ?1 LIMIT 1");
  const bool there = query.bind(1, sha256).step();
  if (auto done = query.done(); !done) return done.error();
  return there;
}

Result<std::vector<ValueOfRun>> RunIndex::history(const RunFilter& filter) const {
  Query query(state_->database,
              "SELECT runs.id, runs.at, vals.name, value, low, high FROM runs JOIN vals ON vals.folder = runs.folder" +
                  conditions(filter) + " ORDER BY vals.name, runs.at, runs.folder");
  bindTo(query, filter);
  std::vector<ValueOfRun> values;
  while (query.step())
    values.push_back({query.text(0), query.text(1), {query.text(2), query.real(3), query.real(4), query.real(5)}});
  if (auto done = query.done(); !done) return done.error();
  return values;
}

Result<std::vector<std::pair<std::string, size_t>>> RunIndex::motors() const {
  Query query(state_->database, "SELECT motor, count(*) FROM runs WHERE motor <> '' GROUP BY motor ORDER BY motor");
  std::vector<std::pair<std::string, size_t>> motors;
  while (query.step()) motors.emplace_back(query.text(0), static_cast<size_t>(query.number(1)));
  if (auto done = query.done(); !done) return done.error();
  return motors;
}

}  // namespace breakaway
