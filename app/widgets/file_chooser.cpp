#include "widgets/file_chooser.h"

#include <QFileDialog>

namespace breakaway {

namespace {
constexpr const char* dialogName = "fileDialog";
}

void FileDialogs::ask(QWidget* parent, const FileQuestion& question, Answer answer) {
  for (auto* open : parent->findChildren<QFileDialog*>(dialogName)) {
    if (open->windowTitle() != question.title) continue;
    open->raise();  // asked again while the question stands: it is the same one
    open->activateWindow();
    return;
  }
  auto* dialog = new QFileDialog(parent, question.title);
  dialog->setObjectName(dialogName);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  if (!question.filter.isEmpty()) dialog->setNameFilter(question.filter);
  dialog->setAcceptMode(question.save && !question.folder ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
  dialog->setFileMode(question.folder ? QFileDialog::Directory
                      : question.save ? QFileDialog::AnyFile
                                      : QFileDialog::ExistingFile);
  if (question.folder) dialog->setOption(QFileDialog::ShowDirsOnly);
  if (!question.suggestion.isEmpty()) dialog->selectFile(question.suggestion);
  QObject::connect(dialog, &QFileDialog::fileSelected, parent, answer);
  dialog->show();
}

}  // namespace breakaway
