#include <QApplication>
#include <QCommandLineParser>
#include <QStyleFactory>

#include "main_window.h"
#include "session.h"

int main(int argc, char** argv) {
  using namespace breakaway;
  QApplication application(argc, argv);
  QApplication::setApplicationName("breakaway");
  QApplication::setApplicationDisplayName("Breakaway");
  QCommandLineParser parser;
  parser.setApplicationDescription(QObject::tr("Breakaway: the bench instrument for a servo motor's friction"));
  parser.addHelpOption();
  const QCommandLineOption board("board", QObject::tr("Connect to this board at the start."), "URI", "simulated");
  parser.addOption(board);
  parser.process(application);
  Session session;
  FileDialogs files;
  MainWindow window(session, files);
  window.show();
  session.connectTo(parser.value(board));
  if (session.connected() && session.identity().simulated) session.turnSlowly();
  return QApplication::exec();
}
