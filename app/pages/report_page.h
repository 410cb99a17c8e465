// Report: what was measured or compared as a file to hand over: seen before it is written, with a customer's name,
// remarks and the chapters that are wanted.
#pragma once

#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <functional>

#include "base/catalogue.h"
#include "base/result.h"
#include "pages/page.h"
#include "widgets/drawn_report.h"
#include "widgets/file_chooser.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QTextBrowser;

namespace breakaway {

class BenchRuns;
class Comparison;
class Messages;

class ReportPage : public Page {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  ReportPage(const BenchRuns& bench, const Comparison& comparison, Messages& messages, FileChooser& files,
             QWidget* parent = nullptr);
  ~ReportPage() override;
  bool wantsLive() const override { return false; }
  bool busy() const override { return writing_ > 0; }

  /// Which report was written last, and which chapters are ticked.
  QVariant kept() const;
  void take(const QVariant& kept);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum class Of { friction, comparison };
  /// Writes report.html into a folder; nothing where there is none to write.
  using Draft = std::function<Result<void>(const std::string& folder)>;

  QWidget* buildChoice();
  QWidget* buildWords();
  void choose(Of of);
  void showAvailable();
  Draft draft() const;
  /// Of the language that was chosen for the report.
  Catalogue words() const;
  ReportEdit edit() const;
  void preview();
  void showPreview(unsigned number, const Result<DrawnReport>& report);
  void showChapters(const QStringList& chapters);
  void writeFriction();
  void writeComparison();
  void writePaper();
  void write(const Draft& draft, const QString& path);
  void written(const Result<void>& result, const QString& report);
  void offerToOpen(const QString& report);

  const BenchRuns& bench_;
  const Comparison& comparison_;
  Messages& messages_;
  FileChooser& files_;
  QPushButton* ofFriction_ = nullptr;
  QPushButton* ofComparison_ = nullptr;
  QLineEdit* customer_ = nullptr;
  QComboBox* language_ = nullptr;
  QPlainTextEdit* remarks_ = nullptr;
  QListWidget* chapters_ = nullptr;
  QTextBrowser* text_ = nullptr;
  QPushButton* friction_ = nullptr;
  QPushButton* compared_ = nullptr;
  QPushButton* paper_ = nullptr;
  QPushButton* open_ = nullptr;
  QString last_;
  int writing_ = 0;  ///< reports that are being written
  Of of_ = Of::friction;
  QTimer soon_;
  std::atomic<unsigned> wanted_ = 0;  ///< number of the newest preview
  QThreadPool pool_;
};

}  // namespace breakaway
