#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QSettings>
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
#include "line/help_as.h"
#include "main_window.h"
#include "screenshots.h"
#include "session/language.h"
#include "session/session.h"
#include "version.h"
#include "widgets/closing.h"
#include "widgets/look.h"

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

int wrong(const std::string& why) {
  return fail(QString::fromStdString(why) + "; see breakaway-gui --help");
}

struct Line {
  std::string board, project, screenshots, language;
  CLI::App app{"Breakaway: the bench instrument for a servo motor's friction", "breakaway-gui"};

  explicit Line(const std::string& version) {
    app.add_option("--board", board,
                   "connect to this board at the start; without it to the last one, or a simulated one")
        ->type_name("URI");
    app.add_option("--project", project, "keep everything in this project, made where there is none")->type_name("DIR");
    app.add_option("--screenshots", screenshots, "render every page in each of its states into DIR, without a display")
        ->type_name("DIR");
    app.add_option("--language", language,
                   "the window in English (en) or German (de), this time; without it as chosen in it")
        ->type_name("CODE")
        ->check(CLI::IsMember({"en", "de"}));
    app.set_version_flag("-v,--version", version);
    app.footer("Examples:\n  breakaway-gui\n  breakaway-gui --board serial:ttyACM0");
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

/// The words that Qt left.
std::vector<std::string> given() {
  std::vector<std::string> words;
  for (const QString& one : QCoreApplication::arguments().mid(1)) words.push_back(one.toStdString());
  return words;
}

constexpr const char* boardKey = "board";

/// Nothing turns at the start. The board that was there last is connected again, unless another one is named.
int show(const QString& board, const QString& project) {
  using namespace breakaway;
  Session session;
  FileDialogs files;
  session.project.open(project.isEmpty() ? BenchProject::defaultFolder() : project);
  MainWindow window(session, files);
  restoreLayout(window);
  window.showParameters(parametersKeptOpen());
  window.show();
  QObject::connect(&session.connection, &Connection::came, &window,
                   [&session] { QSettings("breakaway", "breakaway").setValue(boardKey, session.connection.uri()); });
  const QString last = QSettings("breakaway", "breakaway").value(boardKey, "simulated:servo").toString();
  QTimer::singleShot(0, &window, [&] { session.connection.open(board.isEmpty() ? last : board); });
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  beginRunOf(words);
  nameApplication();
  const std::string program = "breakaway-gui " + std::string(breakaway::versionText());
  Line line(program);
  if (const auto help = breakaway::line::helpAs(line.app, program, words)) {
    if (!*help) return fail(QString::fromStdString(help->error().message()));
    std::fputs((*help)->c_str(), stdout);
    return 0;
  }
  if (hasWord(words, {"-h", "--help", "-v", "--version"})) {
    try {
      line.app.parse(argc, argv);
    } catch (const CLI::ParseError& asked) {
      return asked.get_exit_code() == 0 ? line.app.exit(asked) : wrong(asked.what());
    }
  }
  const QTemporaryDir runtime;
  if (hasWord(words, {"--screenshots"})) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("XDG_DATA_HOME", runtime.path().toUtf8());  // nobody's project is filled by pictures
    if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) qputenv("XDG_RUNTIME_DIR", runtime.path().toUtf8());
    qInstallMessageHandler(quietAboutSizeHints);
  }
  const auto application = applicationOnDisplay(argc, argv);
  QApplication::setApplicationDisplayName("Breakaway");
  breakaway::wear(breakaway::keptTheme());
  try {
    std::vector<std::string> left = given();
    std::reverse(left.begin(), left.end());  // as the parser takes them
    line.app.parse(left);
  } catch (const CLI::ParseError& error) {
    return wrong(error.what());
  }
  breakaway::speak(line.language.empty() ? breakaway::keptLanguage()
                                         : breakaway::languageOf(QString::fromStdString(line.language)));
  if (line.screenshots.empty()) return show(QString::fromStdString(line.board), QString::fromStdString(line.project));
  const auto taken = breakaway::takeScreenshots(QString::fromStdString(line.screenshots));
  return taken ? 0 : fail(QString::fromStdString(taken.error().message()));
}
