#include <QApplication>
#include <QCommandLineParser>
#include <QTemporaryDir>
#include <QTimer>
#include <cstdio>
#include <cstring>

#include "main_window.h"
#include "screenshots.h"
#include "session/session.h"

namespace {

/// Pictures need no display; this must be known before the application is made.
bool wantsScreenshots(int argc, char** argv) {
  for (int k = 1; k < argc; ++k) {
    if (std::strncmp(argv[k], "--screenshots", 13) == 0) return true;
  }
  return false;
}

/// The offscreen platform has nothing to tell window managers, and says so each time.
void quietAboutSizeHints(QtMsgType, const QMessageLogContext&, const QString& message) {
  if (!message.contains("propagateSizeHints")) std::fprintf(stderr, "breakaway-gui: %s\n", qPrintable(message));
}

int fail(const breakaway::Error& error) {
  std::fprintf(stderr, "breakaway-gui: %s\n", error.message().c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace breakaway;
  const QTemporaryDir runtime;
  if (wantsScreenshots(argc, argv)) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) qputenv("XDG_RUNTIME_DIR", runtime.path().toUtf8());
    qInstallMessageHandler(quietAboutSizeHints);
  }
  QApplication application(argc, argv);
  QApplication::setApplicationName("breakaway");
  QApplication::setApplicationDisplayName("Breakaway");
  QCommandLineParser parser;
  parser.setApplicationDescription(QObject::tr("Breakaway: the bench instrument for a servo motor's friction"));
  parser.addHelpOption();
  const QCommandLineOption board("board", QObject::tr("Connect to this board at the start."), "URI", "simulated");
  const QCommandLineOption screenshots(
      "screenshots", QObject::tr("Render every page in each of its states into DIR, without a display."), "DIR");
  parser.addOptions({board, screenshots});
  parser.process(application);
  if (parser.isSet(screenshots)) {
    const auto taken = takeScreenshots(parser.value(screenshots));
    return taken ? 0 : fail(taken.error());
  }
  Session session;
  FileDialogs files;
  MainWindow window(session, files);
  window.show();
  QTimer::singleShot(0, &window, [&] {
    session.connection.open(parser.value(board));
    if (session.connection.identity().simulated) session.bench.turnSlowly();
  });
  return QApplication::exec();
}
