// As much of SQLite's C interface as the index needs: a database that closes itself, statements that end themselves.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace breakaway {

class Database {
 public:
  /// Opens or creates the file, or one in memory for ":memory:". Other processes are waited for up to ten seconds.
  static Result<Database> open(const std::string& path);

  /// Runs statements without parameters and results.
  Result<void> run(const std::string& statements) const;
  /// The number that the query's first row begins with; nothing found: 0.
  Result<std::int64_t> number(const std::string& query) const;
  Error error() const;
  sqlite3* handle() const { return handle_.get(); }

 private:
  struct End {
    void operator()(sqlite3* handle) const;
  };
  std::unique_ptr<sqlite3, End> handle_;
  std::string path_;
};

/// One prepared statement. Parameters count from 1, columns from 0.
class Query {
 public:
  Query(const Database& database, const std::string& text);

  Query& bind(int parameter, std::string_view text);
  Query& bind(int parameter, std::int64_t number);
  Query& bind(int parameter, double number);
  /// True: a row is there. After the last one, or at a fault, false.
  bool step();
  /// To run it again with other parameters.
  void again();
  std::string text(int column) const;
  std::int64_t number(int column) const;
  double real(int column) const;
  /// What went wrong so far, if anything.
  Result<void> done() const;

 private:
  struct End {
    void operator()(sqlite3_stmt* statement) const;
  };
  const Database& database_;
  std::unique_ptr<sqlite3_stmt, End> statement_;
  Result<void> done_;
};

}  // namespace breakaway
