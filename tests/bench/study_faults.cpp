// What is left of outputs when a command is killed at random moments, when its disk is full, when its files may not
// grow, and when two work on one folder; and of a project, by kills. ./dev bench faults [KILLS [SIZES [COMMAND]]],
// where COMMAND may be project.
#include <sys/resource.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <random>
#include <vector>

#include "bench/window_kills.h"
#include "firmware_link/presets.h"
#include "house/pushed_mass.h"
#include "support/disturbed_output.h"
#include "support/small_disk.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

struct Counts {
  int whole = 0, before = 0, half = 0;
  int silent = 0;  ///< ended neither whole nor with a status and one line

  void add(Left left) { ++(left == Left::whole ? whole : left == Left::before ? before : half); }
  void add(Left left, const Ended& ended) {
    add(left);
    const bool told = ended.status > 0 && ended.said.count('\n') == 1;
    if (ended.status != 0 ? !told : left != Left::whole) ++silent;
  }
};

struct Tested {
  Counts killed, full, limited;
  int next = 0, nextWhole = 0;  ///< runs after a kill
  bool two = true;

  bool good() const {
    return killed.half + full.half + limited.half + full.silent + limited.silent == 0 && next == nextWhole && two;
  }
};

/// Every second time over an earlier run's output; every second pair in the last fifth, where files are put in place.
void killed(const DisturbedOutput& output, bool replaces, int kills, std::mt19937& random, Tested& tested) {
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < kills; ++k) {
    const QTemporaryDir place;
    const bool over = replaces && k % 2 == 1;
    if (over) output.lay(place.path());
    const double at = k / 2 % 2 == 0 ? 1.05 * part(random) : 0.8 + 0.25 * part(random);
    output.kill(place.path(), static_cast<int>(at * static_cast<double>(output.took_ms())));
    tested.killed.add(output.left(place.path(), over));
    if (k % 20 != 0) continue;
    ++tested.next;
    output.run(place.path(), true);
    if (output.onlyWhole(place.path())) {
      ++tested.nextWhole;
    } else {
      std::fprintf(stderr, "after a kill differs: %s\n", qPrintable(output.difference(place.path())));
    }
  }
}

/// Disks of sizes up to what the output takes, and somewhat more.
void onFullDisks(const DisturbedOutput& output, bool replaces, int sizes, Tested& tested) {
  for (int k = 0; k < sizes; ++k) {
    const QTemporaryDir place;
    const QString folder = place.filePath("disk");
    QDir().mkpath(folder);
    const bool over = replaces && k % 2 == 1;
    const qint64 room = 4096 + output.bytes() * 11 * k / (10LL * std::max(1, sizes - 1));
    const SmallDisk disk(folder.toStdString(), static_cast<size_t>(room + (over ? output.bytes() : 0)));
    if (!disk.mounted()) return;
    if (over) output.lay(folder);
    const Ended ended = output.run(folder);
    const Left left = output.left(folder, over);
    tested.full.add(over && ended.status == 0 && left == Left::before ? Left::whole : left, ended);  // the same again
  }
}

/// Files that may not grow beyond a size: errors, not signals.
void limited(const DisturbedOutput& output, int sizes, Tested& tested) {
  for (int k = 0; k < sizes; ++k) {
    const QTemporaryDir place;
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit limit{static_cast<rlim_t>(64) << static_cast<unsigned>(k % 20), before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const Ended ended = output.run(place.path());
    ::setrlimit(RLIMIT_FSIZE, &before);
    tested.limited.add(output.left(place.path(), false), ended);
  }
}

bool aloneOfTwo(const DisturbedOutput& output, OutputJob::Kind kind) {
  const QTemporaryDir place;
  const bool ended = output.runTwo(place.path());
  return ended && (kind == OutputJob::Kind::lines ? output.left(place.path(), false) == Left::whole
                                                  : output.onlyWhole(place.path()));
}

void write(const QString& path, const QByteArray& content) {
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) qFatal("%s", qPrintable(path));
}

std::vector<OutputJob> jobsIn(const QTemporaryDir& place) {
  using Kind = OutputJob::Kind;
  const QString bench = place.filePath("b.json"), recording = place.filePath("r.csv");
  write(bench, pushedMassBench());
  write(recording, pushedMassRecording(200, {}, "time_s,position_m,force_N", 4e-2));
  QByteArray list;
  for (const char* id : {"a", "b", "c", "d"})
    list += QByteArray("{\"id\": \"") + id + "\", \"bench\": \"b.json\", \"recordings\": [\"r.csv\"]}\n";
  write(place.filePath("l.jsonl"), list);
  const QString log = QString::fromStdString(resourcesFolder()) + "/examples/example.csv";
  return {{"diagnose", {"diagnose", "--bench", bench, "--recording", recording, "--out", "out"}},
          {"commission",
           {"commission", "--bins", "36", "--turns", "1", "--run-s", "2", "--out", "out"},
           Kind::folder,
           {"--anew"}},
          {"batch", {"batch", place.filePath("l.jsonl"), "--out", "out"}, Kind::lines},
          {"trial", {"trial", "--family", "clean", "--seed", "3", "--out", "out"}},
          {"import", {"import", log, "--out", "out"}, Kind::file}};
}

/// A project, killed while runs are put in and while it records.
bool projectOutlives(int kills, int disks, std::mt19937& random) {
  const QTemporaryDir place;
  const std::string folder = place.path().toStdString();
  const std::pair<const char*, ProjectKills> tested[] = {
      {"putting runs in", killsWhileAdding(folder + "/a", kills, random)},
      {"recording 10 kHz × 12 channels", killsWhileRecording(folder + "/r", kills, random)}};
  std::vector<std::pair<std::string, ProjectKills>> all(std::begin(tested), std::end(tested));
  if (disks > 0) all.emplace_back("recording until the disk is full", fullDisksWhileRecording(folder + "/f", disks));
  const QString window = QString::fromStdString(BREAKAWAY_WINDOW_AT_WORK);
  for (const char* work : windowWorks)
    all.emplace_back(std::string("the window, ") + work,
                     killsOfTheWindow(window, work, place.filePath(work), kills, random));
  std::printf("\n| project, killed while | times | opens | whole | cut short | said | most lost, s |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  bool good = true;
  for (const auto& [what, left] : all) {
    std::printf("| %s | %d | %d | %d | %d | %d | %.2f |\n", what.c_str(), left.kills, left.opened, left.whole, left.cut,
                left.said, left.worst_s);
    for (const std::string& fault : left.faults) std::fprintf(stderr, "%s\n", fault.c_str());
    good = good && left.good();
  }
  std::fflush(stdout);
  return good;
}

QString cells(const Counts& counts) {
  return QString("%1 | %2 | %3").arg(counts.whole).arg(counts.before).arg(counts.half);
}

}  // namespace

int main(int argc, char** argv) {
  const bool disks = takeOwnMounts();
  const QCoreApplication application(argc, argv);
  const int kills = argc > 1 ? QByteArray(argv[1]).toInt() : 200, sizes = argc > 2 ? QByteArray(argv[2]).toInt() : 20;
  if (kills < 1 || sizes < 1 || argc > 4) {
    std::fprintf(stderr, "faults: expected [KILLS [SIZES [COMMAND]]], whole numbers above 0\n");
    return 2;
  }
  const QTemporaryDir place;
  std::mt19937 random(1);
  bool good = true;
  std::printf(
      "%d kills (-9) at random moments, %d sizes of disks %s, %d limits of a file from 64 B on (RLIMIT_FSIZE)\n", kills,
      disks ? sizes : 0, disks ? "(tmpfs)" : "(no mounts allowed here)", sizes);
  std::printf(
      "| command | killed: whole | as before | half | next run whole | disk full: whole | as before | half "
      "| file limited: whole | as before | half | untold | two at once |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const OutputJob& job : jobsIn(place)) {
    if (argc == 4 && job.name != argv[3]) continue;
    DisturbedOutput output(QCoreApplication::applicationDirPath() + "/breakaway", job);
    if (const QString fault = output.measure(); !fault.isEmpty()) {
      std::fprintf(stderr, "faults: %s\n", qPrintable(fault));
      return 1;
    }
    const bool replaces = job.kind != OutputJob::Kind::lines;
    Tested tested;
    killed(output, replaces, kills, random, tested);
    if (disks) onFullDisks(output, replaces, sizes, tested);
    limited(output, sizes, tested);
    tested.two = aloneOfTwo(output, job.kind);
    std::printf("| `%s` | %s | %d of %d | %s | %s | %d | %s |\n", qPrintable(job.name),
                qPrintable(cells(tested.killed)), tested.nextWhole, tested.next, qPrintable(cells(tested.full)),
                qPrintable(cells(tested.limited)), tested.full.silent + tested.limited.silent,
                !tested.two                         ? "MIXED"
                : job.kind != OutputJob::Kind::file ? "one refused"
                                                    : "both whole");
    std::fflush(stdout);
    good = good && tested.good();
  }
  if (argc < 4 || std::string(argv[3]) == "project") good = projectOutlives(kills, disks ? sizes : 0, random) && good;
  return good ? 0 : 1;
}
