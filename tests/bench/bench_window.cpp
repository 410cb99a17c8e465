// Whether the window is ever in the way: repaints, processor time and the longest events of its thread while
// 10 kHz × 12 channels come live, while a recording of ten million rows is opened and zoomed, and with a project of a
// thousand runs; and whether half an hour of those channels goes to the disk whole, with flat memory, as fast as the
// disk takes it. ./dev bench window; with three arguments SECONDS ROWS RUNS less of it.
#include <qcustomplot.h>

#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileInfo>
#include <QLineEdit>
#include <QTableView>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>
#include <cstdio>
#include <functional>

#include "app/streaming_drive.h"
#include "base/atomic_file.h"
#include "bench/loop_watch.h"
#include "main_window.h"
#include "recording/block_file.h"
#include "recording/sample_recording.h"
#include "session/recorder.h"
#include "session/session.h"
#include "support/processor_time.h"
#include "support/resident_memory.h"
#include "widgets/file_chooser.h"
#include "widgets/look.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

constexpr double rate_Hz = 10'000.0, view_s = 60.0;

class NoFiles : public FileChooser {
 public:
  void ask(QWidget*, const FileQuestion&, Answer) override {}
};

/// Through the loop's own waiting: QApplication::processEvents() with a time never waits.
bool waitFor(const std::function<bool()>& reached, int most_ms) {
  QEventLoop loop;
  QTimer look;
  QElapsedTimer clock;
  clock.start();
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    if (reached() || clock.elapsed() > most_ms) loop.quit();
  });
  look.start(5);
  if (!reached()) loop.exec();
  return reached();
}

void rest(int time_ms) {
  QEventLoop loop;
  QTimer::singleShot(time_ms, &loop, &QEventLoop::quit);
  loop.exec();
}

WatchedApplication& watched() {
  return *static_cast<WatchedApplication*>(QApplication::instance());
}

void row(const char* what, const QString& more) {
  const WatchedApplication& watch = watched();
  std::printf("| %s | %zu | %.1f | %.1f | %.1f | %.1f | %s | %s |\n", what, watch.events(), watch.wall_ms(0.99),
              watch.wall_ms(1.0), watch.own_ms(0.99), watch.own_ms(1.0), qPrintable(watch.worst()), qPrintable(more));
  std::fflush(stdout);
}

struct Bench {
  explicit Bench(const QString& project) : window(session, files) {
    session.project.open(project);
    window.resize(1366, 768);
    window.show();
  }
  NoFiles files;
  Session session;
  MainWindow window;
};

void live(const QString& project, int seconds) {
  Bench bench(project);
  bench.window.showPage("handPage");
  bench.window.showLive(true);
  bench.window.findChild<QComboBox*>("spanBox")->setCurrentIndex(4);
  bench.session.connection.adopt(std::make_unique<StreamingDrive>(rate_Hz), "streaming");
  // A minute of samples before, so that the view is full.
  SampleBatch before;
  for (double ago_s = view_s; ago_s > 0.1; ago_s -= 1.0 / rate_Hz)
    before.samples.push_back(StreamingDrive::at(steadyNow_s() - ago_s));
  bench.session.live.take(before);
  rest(2000);
  auto* plot = bench.window.findChild<QCustomPlot*>("livePlot");
  int repaints = 0;
  QObject::connect(plot, &QCustomPlot::afterReplot, plot, [&repaints] { ++repaints; });
  bench.session.live.startRecording();
  watched().forget();
  const ProcessorTime all;
  QElapsedTimer clock;
  clock.start();
  rest(1000 * seconds);
  const double elapsed_s = 1e-3 * static_cast<double>(clock.elapsed());
  row("live, recording", QString("%1 repaints/s, %2 of a core, of it the window's thread %3")
                             .arg(repaints / elapsed_s, 0, 'f', 0)
                             .arg(all.elapsed_s() / elapsed_s, 0, 'f', 2)
                             .arg(watched().ownTotal_s() / elapsed_s, 0, 'f', 2));
  bench.session.live.finishRecording();
  bench.session.connection.close();
  rest(2000);  // the recording is sealed
  watched().forget();
  const ProcessorTime idle;
  clock.restart();
  rest(5000);
  row("disconnected",
      QString("%1 % of a core").arg(1e5 * idle.elapsed_s() / static_cast<double>(clock.elapsed()), 0, 'f', 1));
}

/// Half an hour of recording, as fast as the disk takes it: what is read back is compared by number and last sample.
void record(const QString& folder, double length_s) {
  const std::string path = folder.toStdString() + "/half-an-hour.blocks";
  auto blocks = BlockWriter::create(path, {sampleColumns(Axis::rotary), {}});
  if (!blocks) return;
  constexpr size_t batch = 10'000, mostAhead = 200'000;
  const size_t row_bytes = sizeof(double) * sampleColumns(Axis::rotary).size();
  const auto rows = static_cast<size_t>(length_s * rate_Hz);
  double begin_MB = 0.0, most_MB = 0.0;
  QElapsedTimer clock;
  clock.start();
  Recorder recorder(std::move(*blocks), {});
  std::vector<Sample> samples(batch);
  for (size_t first = 0; first < rows; first += batch) {
    samples.resize(std::min(batch, rows - first));
    for (size_t k = 0; k < samples.size(); ++k)
      samples[k] = StreamingDrive::at(static_cast<double>(first + k) / rate_Hz);
    recorder.append(samples, 0);
    const auto written = [&] {
      return static_cast<size_t>(QFileInfo(QString::fromStdString(path)).size()) / row_bytes;
    };
    while (first > written() + mostAhead) QThread::msleep(1);
    most_MB = std::max(most_MB, resident_MB(QCoreApplication::applicationPid()));
    if (first < mostAhead) begin_MB = most_MB;
  }
  recorder.finish();
  recorder.wait();
  const double took_s = 1e-3 * static_cast<double>(clock.elapsed());
  const auto survey = surveyBlocks(path);
  std::printf(
      "| recorded, %.0f min | | | | | | | %zu samples handed over, %llu on disk%s, in %.0f s; memory %.0f MB, at most "
      "%.0f MB |\n",
      length_s / 60.0, rows, survey ? static_cast<unsigned long long>(survey->rows) : 0ULL,
      survey && survey->ended && survey->why.empty() ? "" : " (NOT ENDED IN ORDER)", took_s, begin_MB, most_MB);
  std::fflush(stdout);
  QFile::remove(QString::fromStdString(path));
}

std::string longRecording(const QString& folder, size_t rows) {
  const std::string path = folder.toStdString() + "/long.blocks";
  auto blocks = BlockWriter::create(path, {{"time_s", "angle_rad", "current_A", "voltage_V"}, {}});
  constexpr size_t perBlock = 10'000;
  for (size_t first = 0; blocks && first < rows; first += perBlock) {
    std::vector<double> block;
    block.reserve(4 * perBlock);
    for (size_t k = first; k < std::min(rows, first + perBlock); ++k) {
      const Sample sample = StreamingDrive::at(static_cast<double>(k) / rate_Hz);
      block.insert(block.end(), {sample.time_s, sample.angle_rad, sample.current_A, 3.0 * sample.current_A});
    }
    if (!blocks->append(block)) return {};
  }
  return blocks && blocks->end("") ? path : std::string();
}

void open(const QString& folder, const QString& project, size_t rows) {
  const std::string path = longRecording(folder, rows);
  Bench bench(project);
  bench.window.showPage("comparePage");
  rest(500);
  watched().forget();
  QElapsedTimer clock;
  clock.start();
  bench.session.comparison.openRecording(QString::fromStdString(path));
  auto* plot = bench.window.findChild<QCustomPlot*>("residualPlot");
  const bool drawn = waitFor([plot] { return plot->graph(0)->dataCount() > 0; }, 120'000);
  plot->replot();
  row("a recording opened",
      QString("%1 rows, first picture after %2 s").arg(rows).arg(drawn ? 1e-3 * clock.elapsed() : -1.0, 0, 'f', 2));
  watched().forget();
  int moves = 0;
  clock.restart();
  QCPAxis* time = plot->axisRect(0)->axis(QCPAxis::atBottom);
  const double whole_s = time->range().size();
  QTimer hand;
  QObject::connect(&hand, &QTimer::timeout, plot, [&] {
    const double span_s = whole_s * (moves % 2 == 0 ? 0.3 : 0.02), from_s = (moves % 50) / 50.0 * (whole_s - span_s);
    time->setRange(from_s, from_s + span_s);
    plot->replot();
    ++moves;
  });
  hand.start(1);
  rest(3000);
  hand.stop();
  row("the same, panned and zoomed", QString("%1 pictures/s").arg(1e3 * moves / clock.elapsed(), 0, 'f', 0));
}

void fill(const QString& project, int runs) {
  auto opened = Project::open(project.toStdString(), Project::Missing::isMade);
  for (int k = 0; opened && k < runs; ++k) {
    NewRun run;
    run.name = "run " + std::to_string(k);
    run.motor = "m" + std::to_string(k % 20);
    run.write = [](const std::string& into) { return writeFile(into + "/note.txt", "kept\n"); };
    if (!opened->add(run)) return;
  }
}

void list(const QString& project, int runs) {
  fill(project, runs);
  QElapsedTimer clock;
  clock.start();
  Bench bench(project);
  watched().forget();
  bench.window.showPage("runsPage");
  auto* table = bench.window.findChild<QTableView*>("runsTable");
  const auto listed = [table] { return table->model()->rowCount(); };
  waitFor([&] { return listed() >= runs; }, 60'000);
  row("a project opened and listed",
      QString("%1 runs, window and list after %2 s").arg(listed()).arg(1e-3 * clock.elapsed(), 0, 'f', 2));
  watched().forget();
  auto* text = bench.window.findChild<QLineEdit*>("runsText");
  clock.restart();
  for (const char* part : {"r", "ru", "run", "run ", "run 7", "run 77"}) {
    text->setText(part);
    rest(20);
  }
  waitFor([&] { return listed() < runs / 5; }, 10'000);
  row("the same, filtered",
      QString("6 letters, %1 runs left after %2 s").arg(listed()).arg(1e-3 * clock.elapsed(), 0, 'f', 2));
}

}  // namespace

int main(int argc, char** argv) {
  const QTemporaryDir place;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  for (const char* name : {"XDG_RUNTIME_DIR", "XDG_DATA_HOME", "XDG_CONFIG_HOME"}) qputenv(name, place.path().toUtf8());
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  WatchedApplication application(argc, argv);
  wear(Theme::light);
  const auto number = [&](int at, int otherwise) { return argc == 4 ? QByteArray(argv[at]).toInt() : otherwise; };
  std::printf("| the window | events | p99, ms | worst, ms | p99, own ms | worst, own ms | whose | |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  live(place.filePath("a"), number(1, 20));
  record(place.path(), argc == 4 ? 60.0 : 1800.0);
  open(place.path(), place.filePath("b"), static_cast<size_t>(number(2, 10'000'000)));
  list(place.filePath("c"), number(3, 1000));
  return 0;
}
