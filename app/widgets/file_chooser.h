// Asks for a file without blocking anything: the motor can be stopped while the question stands. Tests answer it
// themselves.
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace breakaway {

struct FileQuestion {
  QString title;
  QString filter;      ///< as in QFileDialog: "Recording (*.csv)"
  QString suggestion;  ///< a file name to start from
  bool save = false;
  bool folder = false;  ///< a folder instead of a file
};

class FileChooser {
 public:
  using Answer = std::function<void(const QString& path)>;

  virtual ~FileChooser() = default;
  /// `answer` is called once with the path; not at all when nothing was chosen.
  virtual void ask(QWidget* parent, const FileQuestion& question, Answer answer) = 0;
};

/// The dialog of the program itself, which lets Esc through to STOP where a desktop's own dialog would not. A question
/// that stands already is shown, not asked twice.
class FileDialogs : public FileChooser {
 public:
  void ask(QWidget* parent, const FileQuestion& question, Answer answer) override;
};

}  // namespace breakaway
