// A fleet of short recordings: what one costs, what a second core gives, whether kills show in the results, and what
// the page of 10,000 entries takes. ./dev bench fleet [ENTRIES [KILLS]]
#include <stdlib.h>
#include <sys/resource.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <random>

#include "recording/csv.h"
#include "trial/sealed_trial.h"

using namespace breakaway;

namespace {

constexpr double recording_s = 6.0;
constexpr int timedEntries = 24, rounds = 2, pageEntries = 10000;
constexpr double wantedGain = 1.8;  ///< two cores over one
constexpr double idleLoad = 0.5;    ///< of a machine on which that can be judged: processes that want a core

QString program() {
  return QCoreApplication::applicationDirPath() + "/breakaway";
}

[[noreturn]] void fail(const QString& why) {
  std::fprintf(stderr, "fleet: %s\n", qPrintable(why));
  std::exit(1);
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& content) {
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) fail(path + " can't be written");
}

/// Seconds on the clock.
double run(const QString& folder, const QString& words) {
  QProcess process;
  process.setWorkingDirectory(folder);
  QElapsedTimer clock;
  clock.start();
  process.start(program(), words.split(' '));
  if (!process.waitForFinished(-1) || process.exitCode() != 0)
    fail(words + ": " + QString::fromUtf8(process.readAllStandardError()));
  return 1e-3 * static_cast<double>(clock.elapsed());
}

struct Used {
  double processor_s = 0.0, memory_MB = 0.0;  ///< of all that was run so far; the largest of one
};

Used usedSoFar() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1024.0};
}

/// Processes that want a core, on average over the last minute.
double load() {
  double one = 0.0;
  return ::getloadavg(&one, 1) == 1 ? one : 0.0;
}

struct Timed {
  double clock_s = 0.0, processor_s = 0.0;
};

/// One core against two on the same entries: `--jobs N` keeps to N cores. Every other round begins with the other one,
/// so that whoever else wants the cores takes from both.
struct Cores {
  Timed one, two;
  double gain() const { return one.clock_s / two.clock_s; }
};

QString resultsOf(int jobs, int round) {
  return QString("jobs%1-%2.jsonl").arg(QString::number(jobs), QString::number(round));
}

Cores oneAgainstTwo(const QString& folder) {
  Cores timed;
  for (int k = 0; k < 2 * rounds; ++k) {
    const int round = k / 2, jobs = 1 + (k + round) % 2;
    const Used before = usedSoFar();
    Timed& sum = jobs == 1 ? timed.one : timed.two;
    sum.clock_s += run(folder, QString("batch few.jsonl --out %1 --jobs %2").arg(resultsOf(jobs, round)).arg(jobs));
    sum.processor_s += usedSoFar().processor_s - before.processor_s;
  }
  return timed;
}

/// One recording of each trial, and the list of all.
void makeFleet(const QString& folder, int entries) {
  QByteArray list;
  for (int k = 0; k < entries; ++k) {
    const auto seed = 900'000 + static_cast<std::uint64_t>(k);
    const SealedTrial trial = makeTrial(familyOf(seed), seed, {.duration_s = recording_s});
    const QString name = QString::number(k);
    const auto bench = writeBench(trial.bench, (folder + "/" + name + ".bench.json").toStdString());
    const auto recording = writeCsv(trial.recordings.front(), (folder + "/" + name + ".csv").toStdString());
    if (!bench || !recording) fail("can't be written into " + folder);
    const QString date = QString("2026-%1-%2").arg(1 + k % 12, 2, 10, QChar('0')).arg(1 + k % 28, 2, 10, QChar('0'));
    list += QString(R"({"id": %1, "bench": "%1.bench.json", "recordings": ["%1.csv"], "date": "%2"})")
                .arg(name, date)
                .toUtf8() +
            "\n";
  }
  write(folder + "/list.jsonl", list);
  write(folder + "/few.jsonl", list.split('\n').mid(0, timedEntries).join('\n') + "\n");
}

/// Lines in order, without what two runs differ in.
QList<QByteArray> lasting(const QString& path) {
  static const QRegularExpression differing(R"re("(at|run|command)":"[^"]*"|"(named|elapsed|cpu)_s":[0-9.e+-]+)re");
  QList<QByteArray> lines = QString::fromUtf8(contentOf(path)).remove(differing).toUtf8().split('\n');
  std::sort(lines.begin(), lines.end());
  return lines;
}

bool sameByEach(const QString& folder) {
  const QList<QByteArray> first = lasting(folder + "/" + resultsOf(1, 0));
  for (int round = 0; round < rounds; ++round)
    for (const int jobs : {1, 2})
      if (lasting(folder + "/" + resultsOf(jobs, round)) != first) return false;
  return true;
}

/// Whether two cores are fast enough; not held against a machine whose cores others have.
bool gains(const QString& folder) {
  const double others = load();
  const Cores timed = oneAgainstTwo(folder);
  std::printf(
      "two cores over one, %d entries in %d rounds: %.2f times as fast (%.1f s, %.1f s; of a processor %.1f s, %.1f "
      "s), ",
      timedEntries, rounds, timed.gain(), timed.one.clock_s, timed.two.clock_s, timed.one.processor_s,
      timed.two.processor_s);
  const bool busy = others > idleLoad;
  const bool enough = timed.gain() >= wantedGain;
  std::printf("aim %.1f: %s\n", wantedGain, enough ? "met" : busy ? "not judged, others had the cores" : "MISSED");
  if (busy) std::printf("(by the clock, while %.1f others wanted a core)\n", others);
  std::fflush(stdout);
  return enough || busy;
}

/// Begins the batch and kills it, `kills` times, each after a part of what it takes; how often amidst the work.
int killed(const QString& folder, const QString& words, int kills, double took_s) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.3, 1.5);
  int amidst = 0;
  for (int k = 0; k < kills; ++k) {
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(program(), words.split(' '));
    if (!process.waitForStarted()) fail("doesn't start");
    const bool ended = process.waitForFinished(static_cast<int>(1e3 * took_s * part(random) / (kills + 1)));
    process.kill();
    process.waitForFinished();
    amidst += ended ? 0 : 1;
  }
  return amidst;
}

/// As many results as a page is to have, from those that are there.
void multiply(const QString& from, const QString& to) {
  const QList<QByteArray> lines = contentOf(from).trimmed().split('\n');
  QByteArray all;
  for (int k = 0; k < pageEntries; ++k) {
    const QByteArray& line = lines[k % lines.size()];
    all += "{\"id\":" + QByteArray::number(k) + line.mid(line.indexOf(',')) + "\n";
  }
  write(to, all);
}

/// Until the page is there, in s; below zero without a browser.
double openedIn(const QString& page, const QString& folder) {
  const QString browser = QStandardPaths::findExecutable("chromium");
  if (browser.isEmpty()) return -1.0;
  write(
      folder + "/timed.html",
      contentOf(page) +
          "<script>addEventListener('load', () => { document.title = 'there after ' + performance.now(); });</script>");
  QProcess process;
  process.start(browser, {"--headless", "--no-sandbox", "--disable-gpu", "--user-data-dir=" + folder + "/profile",
                          "--virtual-time-budget=20000", "--dump-dom", "file://" + folder + "/timed.html"});
  process.waitForFinished(60000);
  const QString dom = QString::fromUtf8(process.readAllStandardOutput());
  return 1e-3 * dom.section("there after ", 1).section('<', 0, 0).toDouble();
}

}  // namespace

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  const int entries = argc > 1 ? QByteArray(argv[1]).toInt() : 500, kills = argc > 2 ? QByteArray(argv[2]).toInt() : 10;
  if (entries < timedEntries || kills < 1 || argc > 3) {
    std::fprintf(stderr, "fleet: expected [ENTRIES [KILLS]], whole numbers from %d and from 1 on\n", timedEntries);
    return 2;
  }
  const QTemporaryDir place;
  const QString folder = place.path();
  makeFleet(folder, entries);

  const bool fast = gains(folder), same = sameByEach(folder);
  std::printf("results of one core and of two: %s\n", same ? "equal" : "DIFFER");
  std::fflush(stdout);

  const Used before = usedSoFar();
  const double all_s = run(folder, "batch list.jsonl --out whole.jsonl --jobs 2");
  const Used after = usedSoFar();
  const auto bytes = QFileInfo(folder + "/whole.jsonl").size();
  std::printf(
      "%d recordings of %.0f s: %.0f s with two jobs; each %.1f s of a processor, %lld bytes of results; at most %.0f "
      "MB\n",
      entries, recording_s, all_s, (after.processor_s - before.processor_s) / entries,
      static_cast<long long>(bytes / entries), after.memory_MB);
  std::fflush(stdout);

  const QString words = "batch list.jsonl --out killed.jsonl --jobs 2";
  const int amidst = killed(folder, words, kills, all_s);
  run(folder, words);
  const bool whole = lasting(folder + "/killed.jsonl") == lasting(folder + "/whole.jsonl");
  std::printf("killed %d times, %d amidst the work, and run to its end: results %s\n", kills, amidst,
              whole ? "equal to the undisturbed ones" : "DIFFER");

  multiply(folder + "/whole.jsonl", folder + "/page.jsonl");
  const double written_s = run(folder, "summary page.jsonl --out page.html");
  const double opened_s = openedIn(folder + "/page.html", folder);
  std::printf("page of %d entries: written in %.1f s, %.1f MB, ", pageEntries, written_s,
              1e-6 * static_cast<double>(QFileInfo(folder + "/page.html").size()));
  std::printf(opened_s < 0.0 ? "no chromium here to open it\n" : "there after %.2f s in chromium\n", opened_s);
  return fast && same && whole && amidst > 0 ? 0 : 1;
}
