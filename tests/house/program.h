// Runs the real program and says what it did.
#pragma once

#include <QProcess>
#include <QString>

namespace breakaway::test {

struct Outcome {
  int status = -1;  ///< exit status; -1: it crashed, never started or hung
  QString out, err;
};

/// Runs `program` in `folder` with the given words.
inline Outcome run(const QString& program, const QStringList& words, const QString& folder = {}) {
  QProcess process;
  if (!folder.isEmpty()) process.setWorkingDirectory(folder);
  process.start(program, words);
  if (!process.waitForStarted() || !process.waitForFinished(300000)) {
    process.kill();
    process.waitForFinished();
    return {};
  }
  Outcome outcome;
  if (process.exitStatus() == QProcess::NormalExit) outcome.status = process.exitCode();
  outcome.out = QString::fromUtf8(process.readAllStandardOutput());
  outcome.err = QString::fromUtf8(process.readAllStandardError());
  return outcome;
}

/// build/…/bin/NAME
inline QString builtProgram(const QString& name) {
  return qEnvironmentVariable("BREAKAWAY_BIN_DIR") + "/" + name;
}

/// The names of the program's commands, from its help.
inline QStringList commands() {
  const Outcome help = run(builtProgram("breakaway"), {"--help"});
  QStringList names;
  for (const QString& line : help.out.section("Subcommands:", 1).section("\n\n", 0, 0).split('\n', Qt::SkipEmptyParts))
    names << line.trimmed().section(' ', 0, 0);
  return names;
}

}  // namespace breakaway::test
