#include "widgets/closing.h"

#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QSettings>

#include "session/connection.h"
#include "widgets/fields.h"

namespace breakaway {

namespace {
constexpr const char* geometryKey = "window/geometry";
constexpr const char* parametersKey = "window/parameters";
constexpr const char* fieldsGroup = "window/fields/";
// By their names. None of them is a motor's or sets anything on a board.
constexpr const char* keptFields[] = {"bins", "turns", "speedCount", "speedDuration", "spanBox", "liveButton"};

void restoreFields(QWidget& window) {
  const QSettings settings("breakaway", "breakaway");
  Fields fields;
  for (const char* name : keptFields) {
    // A tick comes back as a text from some files.
    const QVariant kept = settings.value(QString(fieldsGroup) + name);
    if (kept.isValid()) fields[name] = kept == "true" || kept == "false" ? QVariant(kept.toBool()) : kept;
  }
  setFields(window, fields);
}
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
  restoreFields(window);
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

void keepLayout(QMainWindow& window) {
  QSettings settings("breakaway", "breakaway");
  settings.setValue(geometryKey, window.saveGeometry());
  const Fields fields = fieldsIn(window);
  for (const char* name : keptFields) {
    if (const QVariant held = fields.value(name); held.isValid()) settings.setValue(QString(fieldsGroup) + name, held);
  }
}

}  // namespace breakaway
