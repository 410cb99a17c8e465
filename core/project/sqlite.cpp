#include "project/sqlite.h"

#include <sqlite3.h>

namespace breakaway {

namespace {
constexpr int patience_ms = 10000;
}

void Database::End::operator()(sqlite3* handle) const {
  sqlite3_close_v2(handle);  // a statement may still be there; the last one to end closes it
}

void Query::End::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Result<Database> Database::open(const std::string& path) {
  Database database;
  database.path_ = path;
  sqlite3* handle = nullptr;
  const int failed = sqlite3_open_v2(path.c_str(), &handle, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  database.handle_.reset(handle);
  if (failed != SQLITE_OK) return database.error();
  sqlite3_busy_timeout(handle, patience_ms);
  return database;
}

Result<void> Database::run(const std::string& statements) const {
  if (sqlite3_exec(handle_.get(), statements.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) return error();
  return {};
}

Result<std::int64_t> Database::number(const std::string& query) const {
  Query one(*this, query);
  const std::int64_t found = one.step() ? one.number(0) : 0;
  if (auto done = one.done(); !done) return done.error();
  return found;
}

Error Database::error() const {
  return {path_, "the index cannot be used: " + std::string(sqlite3_errmsg(handle_.get()))};
}

Query::Query(const Database& database, const std::string& text) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database.handle(), text.c_str(), -1, &statement, nullptr) != SQLITE_OK)
    done_ = database.error();
  statement_.reset(statement);
}

Query& Query::bind(int parameter, std::string_view text) {
  sqlite3_bind_text(statement_.get(), parameter, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
  return *this;
}

Query& Query::bind(int parameter, std::int64_t number) {
  sqlite3_bind_int64(statement_.get(), parameter, number);
  return *this;
}

Query& Query::bind(int parameter, double number) {
  sqlite3_bind_double(statement_.get(), parameter, number);
  return *this;
}

bool Query::step() {
  if (!done_) return false;
  const int state = sqlite3_step(statement_.get());
  if (state != SQLITE_ROW && state != SQLITE_DONE) done_ = database_.error();
  return state == SQLITE_ROW;
}

void Query::again() {
  sqlite3_reset(statement_.get());
}

std::string Query::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return text == nullptr ? std::string()
                         : std::string(text, static_cast<size_t>(sqlite3_column_bytes(statement_.get(), column)));
}

std::int64_t Query::number(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Query::real(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

Result<void> Query::done() const {
  return done_;
}

}  // namespace breakaway
