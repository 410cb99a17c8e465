// What journeys through the window need: no warning of Qt passes, questions for files are answered, widgets are found
// by name.
#pragma once

#include <QAbstractButton>
#include <QLabel>
#include <QMap>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <cstdlib>

#include "main_window.h"
#include "session/session.h"
#include "widgets/file_chooser.h"
#include "widgets/look.h"

namespace breakaway::test {

/// Any warning ends the test program; the one exception is a remark of the offscreen platform.
inline void failOnWarning(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtDebugMsg || type == QtInfoMsg || message.contains("propagateSizeHints")) return;
  std::fprintf(stderr, "FAIL!  : a warning of Qt: %s\n", qPrintable(message));
  std::abort();
}

/// Answers by the question's title; a question nobody prepared an answer for stays open.
class Answers : public FileChooser {
 public:
  QMap<QString, QString> byTitle;
  void ask(QWidget*, const FileQuestion& question, Answer answer) override {
    asked << question.title;
    if (byTitle.contains(question.title)) answer(byTitle.value(question.title));
  }
  QStringList asked;
};

template <typename Widget>
Widget* named(QWidget& window, const char* objectName) {
  auto* widget = window.findChild<Widget*>(objectName);
  if (widget == nullptr) qFatal("the window has no %s", objectName);
  return widget;
}

/// Presses a button as a person would: it must be visible and enabled.
inline void press(QWidget& window, const char* objectName) {
  auto* button = named<QAbstractButton>(window, objectName);
  if (!button->isVisible()) qFatal("%s is not visible", objectName);
  if (!button->isEnabled()) qFatal("%s is disabled: %s", objectName, qPrintable(button->toolTip()));
  QTest::mouseClick(button, Qt::LeftButton);
}

}  // namespace breakaway::test

/// main() of a journey: as QTEST_MAIN, after Qt's warnings were made fatal.
#define JOURNEY_MAIN(TestClass)                             \
  int main(int argc, char** argv) {                         \
    qInstallMessageHandler(breakaway::test::failOnWarning); \
    const QTemporaryDir runtime;                            \
    qputenv("XDG_RUNTIME_DIR", runtime.path().toUtf8());    \
    const QTemporaryDir kept;                               \
    qputenv("XDG_DATA_HOME", kept.path().toUtf8());         \
    qputenv("XDG_CONFIG_HOME", kept.path().toUtf8());       \
    QApplication application(argc, argv);                   \
    breakaway::wear(breakaway::Theme::light);               \
    TestClass test;                                         \
    return QTest::qExec(&test, argc, argv);                 \
  }
