#include <unistd.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "base/made.h"
#include "main_window.h"
#include "screenshots.h"
#include "session/session.h"
#include "version.h"

namespace {

/// Whether one of `options` was given: some must be known before the application is made.
bool hasWord(const std::vector<std::string>& words, std::initializer_list<std::string_view> options) {
  return std::any_of(words.begin(), words.end(), [options](const std::string& word) {
    return std::find(options.begin(), options.end(), std::string_view(word).substr(0, word.find('='))) != options.end();
  });
}

/// The offscreen platform has nothing to tell window managers, and says so each time.
void quietAboutSizeHints(QtMsgType, const QMessageLogContext&, const QString& message) {
  if (!message.contains("propagateSizeHints")) std::fprintf(stderr, "breakaway-gui: %s\n", qPrintable(message));
}

/// While the application looks for its display: where there is none, Qt warns at length and aborts.
void oneLineWithoutDisplay(QtMsgType type, const QMessageLogContext&, const QString&) {
  if (type != QtFatalMsg) return;
  const char* display = std::getenv("DISPLAY");
  std::fprintf(stderr, "breakaway-gui: has no display to open its window on (DISPLAY is %s); breakaway needs none\n",
               display == nullptr || *display == '\0' ? "empty" : display);
  std::fflush(stderr);
  _exit(2);
}

/// What libraries throw from within an event ends the window with one line; the connection's end stops the motor.
class Application : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override {
    try {
      return QApplication::notify(receiver, event);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "breakaway-gui: cannot go on: %s\n", error.what());
      QCoreApplication::exit(2);
      return false;
    }
  }
};

std::unique_ptr<QApplication> applicationOnDisplay(int& argc, char** argv) {
  const auto before = qInstallMessageHandler(oneLineWithoutDisplay);
  std::unique_ptr<QApplication> application = std::make_unique<Application>(argc, argv);
  qInstallMessageHandler(before);
  return application;
}

int fail(const QString& line) {
  std::fprintf(stderr, "breakaway-gui: %s\n", qPrintable(line));
  return 2;
}

struct Line {
  QCommandLineOption board{"board", QObject::tr("Connect to this board at the start."), "URI", "simulated"};
  QCommandLineOption screenshots{
      "screenshots", QObject::tr("Render every page in each of its states into DIR, without a display."), "DIR"};
  QCommandLineParser parser;

  Line() {
    parser.setApplicationDescription(
        QObject::tr("Breakaway: the bench instrument for a servo motor's friction\n"
                    "Examples:\n"
                    "  breakaway-gui\n"
                    "  breakaway-gui --board serial:ttyACM0"));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOptions({board, screenshots});
  }
};

void nameApplication() {
  QCoreApplication::setApplicationName("breakaway");
  const std::string_view version = breakaway::versionText();
  QCoreApplication::setApplicationVersion(QString::fromUtf8(version.data(), static_cast<qsizetype>(version.size())));
}

void beginRunOf(const std::vector<std::string>& given) {
  std::vector<std::string> words{"breakaway-gui"};
  words.insert(words.end(), given.begin(), given.end());
  breakaway::beginRun("breakaway-gui " + std::string(breakaway::versionText()), breakaway::asCommand(words));
}

int show(const QString& board) {
  using namespace breakaway;
  Session session;
  FileDialogs files;
  MainWindow window(session, files);
  window.show();
  QTimer::singleShot(0, &window, [&] {
    session.connection.open(board);
    if (session.connection.identity().simulated) session.bench.turnSlowly();
  });
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  beginRunOf(words);
  nameApplication();
  if (hasWord(words, {"-h", "--help", "--help-all", "-v", "--version"})) {
    const QCoreApplication application(argc, argv);
    Line().parser.process(application);  // says it and ends
  }
  const QTemporaryDir runtime;
  if (hasWord(words, {"--screenshots"})) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) qputenv("XDG_RUNTIME_DIR", runtime.path().toUtf8());
    qInstallMessageHandler(quietAboutSizeHints);
  }
  const auto application = applicationOnDisplay(argc, argv);
  QApplication::setApplicationDisplayName("Breakaway");
  Line line;
  if (!line.parser.parse(QApplication::arguments())) {
    QString why = line.parser.errorText();
    if (why.endsWith('.')) why.chop(1);
    return fail(why + "; see breakaway-gui --help");
  }
  if (!line.parser.isSet(line.screenshots)) return show(line.parser.value(line.board));
  const auto taken = breakaway::takeScreenshots(line.parser.value(line.screenshots));
  return taken ? 0 : fail(QString::fromStdString(taken.error().message()));
}
