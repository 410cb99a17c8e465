// A folder for a test's files, gone afterwards, and files as text.
#pragma once

#include <QDir>
#include <QTemporaryDir>
#include <string>

#include "base/atomic_file.h"

namespace breakaway::test {

class TemporaryFolder {
 public:
  std::string path(const std::string& name = {}) const {
    return folder_.path().toStdString() + (name.empty() ? "" : "/" + name);
  }
  /// Writes a file and returns its path.
  std::string write(const std::string& name, std::string_view content) const {
    const auto done = writeFile(path(name), content);
    if (!done) qFatal("%s", done.error().message().c_str());
    return path(name);
  }
  /// Names of all files and folders in it, sorted.
  QStringList names() const {
    return QDir(folder_.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace breakaway::test

/// Fails the test with the error's own line when `result` is not ok. Evaluates it once.
#define VERIFY_OK(result)                                                                               \
  do {                                                                                                  \
    const auto& verifiedResult = (result);                                                              \
    QVERIFY2(verifiedResult.ok(), verifiedResult.ok() ? "" : verifiedResult.error().message().c_str()); \
  } while (false)
/// The error's line is exactly `line`.
#define VERIFY_ERROR(result, line)                                 \
  do {                                                             \
    const auto& verifiedResult = (result);                         \
    QVERIFY2(!verifiedResult.ok(), "expected an error");           \
    QCOMPARE(verifiedResult.error().message(), std::string(line)); \
  } while (false)
