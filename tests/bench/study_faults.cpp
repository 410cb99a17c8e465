// What is left of outputs when a command is killed at random moments, when its files may not grow, and when two work on
// one folder. ./dev bench faults [KILLS [SIZES]]
#include <sys/resource.h>

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <csignal>
#include <cstdio>
#include <random>

#include "firmware_link/presets.h"

using namespace breakaway;

namespace {

/// A command, with OUT in its words for what it writes.
struct Job {
  QString name;
  QStringList words;
  bool folder = true;
  bool appends = false;
  qint64 took_ms = 0;
  QStringList whole = {};  ///< the files of a run that nothing disturbed
  QByteArray content = {};
};

QString program() {
  return QCoreApplication::applicationDirPath() + "/breakaway";
}

QStringList wordsFor(const Job& job, const QString& out) {
  QStringList words = job.words;
  words.replaceInStrings("OUT", out);
  return words;
}

/// The files below a folder, those of a job under way (progress/) aside.
QStringList filesIn(const QString& folder) {
  QStringList names;
  QDirIterator one(folder, QDir::Files, QDirIterator::Subdirectories);
  while (one.hasNext()) {
    const QString name = QDir(folder).relativeFilePath(one.next());
    if (!name.startsWith("progress/")) names << name;
  }
  names.sort();
  return names;
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

enum class Left { whole, absent, half };

Left leftOf(const Job& job, const QString& out) {
  if (job.folder) {
    const QStringList files = filesIn(out);
    return files.isEmpty() ? Left::absent : files == job.whole ? Left::whole : Left::half;
  }
  if (!QFile::exists(out)) return Left::absent;
  const QByteArray content = contentOf(out);
  if (job.appends) return content.isEmpty() ? Left::absent : content.endsWith('\n') ? Left::whole : Left::half;
  return content == job.content ? Left::whole : Left::half;
}

struct Counts {
  int whole = 0, absent = 0, half = 0;
  void add(Left left) { ++(left == Left::whole ? whole : left == Left::absent ? absent : half); }
};

void start(QProcess& process, const Job& job, const QString& out) {
  process.setStandardOutputFile(QProcess::nullDevice());
  process.start(program(), wordsFor(job, out));
  process.waitForStarted();
}

/// The run that the others are held against, and how long it takes.
bool measure(Job& job, const QTemporaryDir& place) {
  const QString out = place.filePath("reference-" + job.name);
  QElapsedTimer clock;
  clock.start();
  QProcess process;
  start(process, job, out);
  if (!process.waitForFinished(600000) || process.exitCode() != 0) {
    std::fprintf(stderr, "faults: %s: %s\n", qPrintable(job.name), process.readAllStandardError().constData());
    return false;
  }
  job.took_ms = clock.elapsed();
  job.whole = filesIn(out);
  job.content = contentOf(out);
  return true;
}

Counts killed(const Job& job, int kills, std::mt19937& random) {
  Counts counts;
  std::uniform_real_distribution<double> moment(0.0, 1.05 * static_cast<double>(job.took_ms));
  for (int k = 0; k < kills; ++k) {
    const QTemporaryDir place;
    const QString out = place.filePath("out");
    QProcess process;
    start(process, job, out);
    process.waitForFinished(static_cast<int>(moment(random)));
    process.kill();
    process.waitForFinished();
    counts.add(leftOf(job, out));
  }
  return counts;
}

/// Files that may not grow beyond a size, as on a disk that is full: errors, not signals.
Counts limited(const Job& job, int sizes, int& silent) {
  Counts counts;
  for (int k = 0; k < sizes; ++k) {
    const QTemporaryDir place;
    const QString out = place.filePath("out");
    QProcess process;
    const rlim_t most = static_cast<rlim_t>(64) << static_cast<unsigned>(k % 20);
    process.setChildProcessModifier([most] {
      const rlimit limit{most, most};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    });
    start(process, job, out);
    process.waitForFinished(600000);
    const Left left = leftOf(job, out);
    counts.add(left);
    const QByteArray said = process.readAllStandardError();
    const bool told = process.exitStatus() == QProcess::NormalExit && process.exitCode() != 0 && said.count('\n') == 1;
    if (left != Left::whole && !told) ++silent;
  }
  return counts;
}

/// Two at once: one does it, the other is refused in one line.
bool oneOfTwo(const Job& job) {
  const QTemporaryDir place;
  const QString out = place.filePath("out");
  QProcess first, second;
  start(first, job, out);
  start(second, job, out);
  first.waitForFinished(600000);
  second.waitForFinished(600000);
  const bool refused = first.exitCode() + second.exitCode() == 2 &&
                       (first.readAllStandardError() + second.readAllStandardError()).count("another process") == 1;
  return refused && leftOf(job, out) == Left::whole;
}

std::vector<Job> jobsIn(const QTemporaryDir& place) {
  const QString resources = QString::fromStdString(resourcesFolder()), example = resources + "/examples/example";
  QFile manifest(place.filePath("m.jsonl"));
  if (!manifest.open(QIODevice::WriteOnly)) return {};
  for (const char* id : {"a", "b"}) {
    manifest.write(QString(R"({"id": "%1", "bench": "%2.bench.json", "recordings": ["%2.csv"]})"
                           "\n")
                       .arg(id, example)
                       .toUtf8());
  }
  manifest.close();
  return {
      {"diagnose", {"diagnose", "--bench", example + ".bench.json", "--recording", example + ".csv", "--out", "OUT"}},
      {"commission", {"commission", "--bins", "36", "--turns", "1", "--run-s", "2", "--out", "OUT"}},
      {"batch", {"batch", manifest.fileName(), "--out", "OUT"}, false, true},
      {"trial", {"trial", "--seed", "3", "--out", "OUT"}},
      {"import", {"import", example + ".csv", "--out", "OUT"}, false},
  };
}

}  // namespace

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  const int kills = argc > 1 ? QByteArray(argv[1]).toInt() : 200, sizes = argc > 2 ? QByteArray(argv[2]).toInt() : 20;
  if (kills < 1 || sizes < 1 || argc > 3) {
    std::fprintf(stderr, "faults: expected [KILLS [SIZES]], whole numbers above 0\n");
    return 2;
  }
  const QTemporaryDir place;
  std::mt19937 random(1);
  int half = 0, silent = 0;
  bool alone = true;
  std::printf("%d kills (-9) at random moments; files limited to %d sizes from 64 B on (RLIMIT_FSIZE)\n", kills, sizes);
  std::printf("| command | killed: whole | absent | half | limited: whole | absent | half | two at once |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  for (Job& job : jobsIn(place)) {
    if (!measure(job, place)) return 1;
    const Counts after = killed(job, kills, random), small = limited(job, sizes, silent);
    const bool one = !job.folder || oneOfTwo(job);
    std::printf("| `%s` | %d | %d | %d | %d | %d | %d | %s |\n", qPrintable(job.name), after.whole, after.absent,
                after.half, small.whole, small.absent, small.half,
                !job.folder ? "–"
                : one       ? "one refused"
                            : "MIXED");
    std::fflush(stdout);
    half += after.half + small.half;
    alone = alone && one;
  }
  if (silent > 0) std::printf("%d limited runs ended without one line and a status\n", silent);
  return half == 0 && silent == 0 && alone ? 0 : 1;
}
