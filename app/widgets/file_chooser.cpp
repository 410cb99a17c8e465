#include "widgets/file_chooser.h"

#include <QFileDialog>

namespace breakaway {

void FileDialogs::ask(QWidget* parent, const FileQuestion& question, Answer answer) {
  auto* dialog = new QFileDialog(parent, question.title);
  dialog->setObjectName("fileDialog");
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
