#include "support/disturbed_output.h"

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <algorithm>

namespace breakaway::test {

namespace {

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

const QRegularExpression& runIdentifier() {
  static const QRegularExpression pattern("[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}");
  return pattern;
}

/// Without what two runs of one command may differ in: times, the run, where it ran, and hashes of files that hold
/// such.
QByteArray withoutTimes(const QByteArray& content, const QString& place) {
  static const QRegularExpression times(
      R"(\d{4}-\d\d-\d\d[T ]\d\d:\d\d(:\d\d)?Z?|"(named|elapsed|cpu)_s": ?[0-9.e+-]+)");
  static const QRegularExpression hashes("[0-9a-f]{64}");
  QString text = QString::fromUtf8(content);
  return text.replace(place, QString()).remove(runIdentifier()).remove(times).remove(hashes).toUtf8();
}

/// Where a recording's head of comments ends; 0 in other files.
qsizetype headOf(const QString& name, const QByteArray& content) {
  qsizetype end = 0;
  while (name.endsWith(".csv") && end >= 0 && end < content.size() && content[end] == '#')
    end = content.indexOf('\n', end) + 1;
  return end;
}

QByteArray lasting(const QString& name, const QByteArray& content, const QString& place) {
  if (!name.endsWith(".csv")) return withoutTimes(content, place);
  const qsizetype head = headOf(name, content);
  return withoutTimes(content.first(head), place) + content.sliced(head);
}

/// Without a part of a line, and each line one of those that an undisturbed run leaves.
bool areWholeLines(const QByteArray& lines, const QByteArray& undisturbed) {
  const QList<QByteArray> known = undisturbed.split('\n');
  const QList<QByteArray> all = lines.split('\n');
  return lines.endsWith('\n') &&
         std::all_of(all.begin(), all.end(), [&known](const QByteArray& one) { return known.contains(one); });
}

/// A folder's files come from one run.
bool fromOneRun(const Contents& contents) {
  QSet<QString> runs;
  for (auto file = contents.begin(); file != contents.end(); ++file) {
    const bool table = file.key().endsWith(".csv");
    const QByteArray text = table ? file.value().first(headOf(file.key(), file.value())) : file.value();
    for (auto it = runIdentifier().globalMatch(QString::fromUtf8(text)); it.hasNext();)
      runs.insert(it.next().captured());
  }
  return runs.size() <= 1;
}

void start(QProcess& process, const QString& program, const QStringList& words, const QString& place) {
  process.setWorkingDirectory(place);
  process.setStandardOutputFile(QProcess::nullDevice());
  process.start(program, words);
  process.waitForStarted();
}

Ended endOf(QProcess& process) {
  if (!process.waitForFinished(600000)) process.kill();
  process.waitForFinished();
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAllStandardError()};
}

}  // namespace

/// The files of the output by name, those of a job under way (progress/) aside.
Contents DisturbedOutput::contents(const QString& place) const {
  const QString out = place + "/out";
  Contents found;
  if (job_.kind != OutputJob::Kind::folder) {
    if (QFile::exists(out)) found["out"] = contentOf(out);
    return found;
  }
  QDirIterator one(out, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
  while (one.hasNext()) {
    const QString name = QDir(out).relativeFilePath(one.next());
    if (!name.startsWith("progress/")) found[name] = contentOf(out + "/" + name);
  }
  return found;
}

QString DisturbedOutput::measure() {
  const QTemporaryDir first, second;
  QElapsedTimer clock;
  clock.start();
  if (const Ended ended = run(first.path()); ended.status != 0) return job_.name + ": " + QString::fromUtf8(ended.said);
  took_ms_ = clock.elapsed();
  undisturbed_ = contents(first.path());
  for (auto it = undisturbed_.begin(); it != undisturbed_.end(); ++it) {
    bytes_ += (it.value().size() + 4095) / 4096 * 4096;
    lasting_[it.key()] = lasting(it.key(), it.value(), first.path());
  }
  run(second.path());
  const QString differs = difference(second.path());
  return differs.isEmpty() ? QString() : job_.name + ": two undisturbed runs differ in " + differs;
}

void DisturbedOutput::lay(const QString& place) const {
  for (auto it = undisturbed_.begin(); it != undisturbed_.end(); ++it) {
    const QString path = job_.kind == OutputJob::Kind::folder ? place + "/out/" + it.key() : place + "/out";
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) file.write(it.value());
  }
}

void DisturbedOutput::kill(const QString& place, int after_ms) const {
  QProcess process;
  start(process, program_, job_.words, place);
  process.waitForFinished(after_ms);
  process.kill();
  process.waitForFinished();
}

Ended DisturbedOutput::run(const QString& place, bool anew) const {
  QProcess process;
  start(process, program_, anew ? job_.words + job_.anew : job_.words, place);
  return endOf(process);
}

bool DisturbedOutput::runTwo(const QString& place) const {
  QProcess first, second;
  start(first, program_, job_.words, place);
  start(second, program_, job_.words, place);
  const Ended one = endOf(first), other = endOf(second);
  if (job_.kind == OutputJob::Kind::file) return one.status == 0 && other.status == 0;
  const QByteArray said = one.said + other.said;
  return one.status + other.status == 2 && said.count("another process") == 1 && said.count('\n') == 1;
}

/// Files hold the command that made them.
QByteArray DisturbedOutput::withoutAnew(QByteArray content) const {
  for (const QString& word : job_.anew) content.replace((" " + word).toUtf8(), "");
  return content;
}

QString DisturbedOutput::difference(const QString& place) const {
  const Contents there = contents(place);
  QStringList names;
  for (auto it = there.begin(); it != there.end(); ++it) {
    if (!undisturbed_.contains(it.key())) names << it.key() + " (new)";
  }
  for (auto it = undisturbed_.begin(); it != undisturbed_.end(); ++it) {
    if (there.value(it.key()) == it.value()) continue;
    if (withoutAnew(lasting(it.key(), there.value(it.key()), place)) != lasting_[it.key()]) names << it.key();
  }
  if (!fromOneRun(there) && job_.kind == OutputJob::Kind::folder) names << "the run's identifier";
  return names.join(", ");
}

Left DisturbedOutput::left(const QString& place, bool overEarlier) const {
  const Contents there = contents(place);
  if (there == (overEarlier ? undisturbed_ : Contents())) return Left::before;
  if (difference(place).isEmpty()) return Left::whole;
  if (job_.kind != OutputJob::Kind::lines || there.isEmpty()) return Left::half;
  const QByteArray lines = lasting("out", there.first(), place);
  return lines.isEmpty() ? Left::before : areWholeLines(lines, lasting_.first()) ? Left::whole : Left::half;
}

bool DisturbedOutput::onlyWhole(const QString& place) const {
  return difference(place).isEmpty() &&
         QDir(place).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot) == QStringList("out");
}

}  // namespace breakaway::test
