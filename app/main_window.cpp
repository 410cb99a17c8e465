#include "main_window.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDialog>
#include <QLineEdit>
#include <algorithm>
#include <chrono>

#include "session/session.h"
#include "widgets/click_guard.h"
#include "widgets/closing.h"
#include "widgets/fields.h"
#include "widgets/manual.h"
#include "widgets/stop_keys.h"
#include "widgets/wheel_guard.h"

using namespace std::chrono_literals;

namespace breakaway {

namespace {

constexpr auto soon = 50ms;

/// Somebody writes in a cell of a table: that isn't taken before it is left.
bool isCell(const QWidget* focused) {
  const QWidget* view =
      focused != nullptr && focused->parentWidget() ? focused->parentWidget()->parentWidget() : nullptr;
  return qobject_cast<const QLineEdit*>(focused) != nullptr && qobject_cast<const QAbstractItemView*>(view) != nullptr;
}

}  // namespace

MainWindow::MainWindow(Session& session, FileChooser& files, QWidget* parent)
    : QMainWindow(parent), session_(session), files_(files) {
  setObjectName("mainWindow");
  setWindowTitle("Breakaway");
  setWindowIcon(QIcon(":/icons/breakaway.svg"));
  resize(1366, 768);
  makeContents();
  buildHelp();
  new StopKeys([&connection = session.connection] { connection.stop(); }, this);
  new WheelGuard(this);
  new ClickGuard(this);
  next_.setInterval(soon);
  connect(&next_, &QTimer::timeout, this, &MainWindow::speakWhenItMay);
  contents_->findChild<QWidget*>("steps")->setFocus();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayClose(*this, session_.connection)) return event->ignore();
  keepLayout(*this);
  QMainWindow::closeEvent(event);
}

/// F1 and "?" anywhere but in a text: the manual on what is under the cursor, or has the focus where it is on nothing.
void MainWindow::buildHelp() {
  auto* action = new QAction(this);
  action->setObjectName("helpAction");
  action->setShortcuts({QKeySequence(Qt::Key_F1), QKeySequence(Qt::Key_Question)});
  connect(action, &QAction::triggered, this, [this] {
    const QWidget* under = QApplication::widgetAt(QCursor::pos());
    showHelp(under != nullptr && under->window() == this ? under : QApplication::focusWidget());
  });
  addAction(action);
}

void MainWindow::showHelp(const QWidget* about) {
  if (manual_ == nullptr) manual_ = new Manual(this);
  manual_->open(Manual::topicOf(about));
}

void MainWindow::makeContents() {
  setCentralWidget(contents_ = new WindowContents(session_, files_, this));
  connect(contents_, &WindowContents::languageChosen, this, &MainWindow::chooseLanguage);
  connect(contents_, &WindowContents::helpAsked, this, &MainWindow::showHelp);
}

void MainWindow::chooseLanguage(Language language) {
  keepLanguage(language);
  wanted_ = spokenAs(language);
  told_.clear();
  next_.start();  // not at once: what it was chosen in goes, too
}

std::optional<QString> MainWindow::obstacle() const {
  const Connection& connection = session_.connection;
  if (connection.powered() || connection.run().running()) return tr("The language changes once the motor stands");
  const auto questions = findChildren<QDialog*>();
  if (std::any_of(questions.begin(), questions.end(), [](const QDialog* one) { return one->isVisible(); }))
    return tr("The language changes once the open question is answered");
  const bool inHand = QApplication::activePopupWidget() != nullptr || QApplication::mouseButtons() != Qt::NoButton;
  return inHand || isCell(focusWidget()) || contents_->busy() ? std::optional(QString()) : std::nullopt;
}

void MainWindow::speakWhenItMay() {
  if (wanted_ == spokenLanguage()) return next_.stop();
  if (const auto why = obstacle()) {
    if (told_ != *why && !why->isEmpty()) session_.messages.say(told_ = *why);
    return;
  }
  next_.stop();
  speak(wanted_);
  makeContentsAnew();
}

void MainWindow::makeContentsAnew() {
  const Fields fields = fieldsIn(*contents_);
  const QString focused = focusWidget() != nullptr ? focusWidget()->objectName() : QString();
  setUpdatesEnabled(false);
  contents_->hide();  // whoever holds a motor by a button lets go
  delete takeCentralWidget();
  makeContents();
  setFields(*contents_, fields);
  contents_->show();
  if (auto* widget = focused.isEmpty() ? nullptr : contents_->findChild<QWidget*>(focused)) widget->setFocus();
  setUpdatesEnabled(true);
}

}  // namespace breakaway
