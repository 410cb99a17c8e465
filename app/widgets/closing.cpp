#include "widgets/closing.h"

#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QSettings>

#include "session/connection.h"

namespace breakaway {

namespace {
constexpr const char* geometryKey = "window/geometry";
constexpr const char* parametersKey = "window/parameters";
}  // namespace

bool mayClose(QWidget& window, Connection& connection) {
  if (!connection.powered() && !connection.run().running()) return true;
  if (auto* asked = window.findChild<QMessageBox*>("closeQuestion"); asked != nullptr) {
    asked->raise();
    return false;
  }
  auto* question = new QMessageBox(QMessageBox::Question, QObject::tr("Close Breakaway"),
                                   QObject::tr("The motor turns. Stop it and close?"), QMessageBox::NoButton, &window);
  question->setObjectName("closeQuestion");
  question->setAttribute(Qt::WA_DeleteOnClose);
  question->setWindowModality(Qt::NonModal);
  auto* stop = question->addButton(QObject::tr("Stop and close"), QMessageBox::AcceptRole);
  stop->setObjectName("stopAndCloseButton");
  question->setDefaultButton(question->addButton(QObject::tr("Stay"), QMessageBox::RejectRole));
  QObject::connect(stop, &QPushButton::clicked, &window, [&window, &connection] {
    connection.close();  // stops the motor first
    window.close();
  });
  question->show();
  return false;
}

bool restoreLayout(QMainWindow& window) {
  if (window.restoreGeometry(QSettings("breakaway", "breakaway").value(geometryKey).toByteArray())) return true;
  window.resize(window.size().boundedTo(window.screen()->availableSize()));
  return false;
}

bool parametersKeptOpen() {
  return QSettings("breakaway", "breakaway").value(parametersKey, false).toBool();
}

void keepParametersOpen(bool open) {
  QSettings("breakaway", "breakaway").setValue(parametersKey, open);
}

void keepLayout(const QMainWindow& window) {
  QSettings("breakaway", "breakaway").setValue(geometryKey, window.saveGeometry());
}

}  // namespace breakaway
