#include "widgets/manual.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QEvent>
#include <QFile>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include "firmware_link/presets.h"
#include "widgets/controls.h"

namespace breakaway {

namespace {

constexpr const char* firstPage = "index.md";

struct Topic {
  const char* widget;  ///< its object name
  const char* topic;
};

// The narrower ones stand within the wider ones: the nearest to the cursor is taken.
constexpr Topic topics[] = {{"connectPage", "connect.md"},
                            {"profileTable", "connect.md#profiles"},
                            {"saveProfileButton", "connect.md#profiles"},
                            {"openProfileButton", "connect.md#profiles"},
                            {"restoreProfileButton", "connect.md#profiles"},
                            {"parametersDock", "window.md#parameters"},
                            {"identifyPage", "bench.md"},
                            {"tunePage", "window.md#tune"},
                            {"cutoffSlider", "stability.md#what-a-cutoff-costs"},
                            {"homePage", "bench.md"},
                            {"frictionPage", "bench.md"},
                            {"comparePage", "diagnosis.md"},
                            {"verdictCard", "diagnosis.md#the-verdict"},
                            {"findingsList", "effects.md"},
                            {"logPanel", "import.md"},
                            {"reportPage", "window.md#the-pages"},
                            {"handPage", "window.md#drive-by-hand"},
                            {"runsPage", "window.md#runs"},
                            {"shownMap", "window.md#runs"},
                            {"mapBeneath", "window.md#runs"},
                            {"logDrawer", "trouble.md"},
                            {"livePlots", "window.md#what-is-always-there"},
                            {"liveStrip", "window.md#what-is-always-there"},
                            {"mainWindow", "window.md"}};

}  // namespace

QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar& one : heading.trimmed().toLower()) {
    if (one.isLetterOrNumber() || one == '-' || one == '_') anchor += one;
    if (one == ' ') anchor += '-';
  }
  return anchor;
}

Manual::Manual(QWidget* parent) : QWidget(parent, Qt::Window) {
  setObjectName("manual");
  auto* column = columnIn(this, 8, {16, 12, 16, 12});
  text_ = new QTextBrowser(this);
  text_->setObjectName("manualText");
  text_->setOpenLinks(false);
  auto* row = new QHBoxLayout;
  contents_ = pushButton(this, "manualContentsButton", {});
  back_ = pushButton(this, "manualBackButton", {});
  row->addWidget(contents_);
  row->addStretch(1);
  row->addWidget(back_);
  column->addLayout(row);
  column->addWidget(text_, 1);
  connect(contents_, &QPushButton::clicked, this, [this] { open(firstPage); });
  connect(back_, &QPushButton::clicked, this, &QWidget::close);
  connect(text_, &QTextBrowser::anchorClicked, this, &Manual::follow);
  nameParts();
  resize(860, 680);
}

void Manual::nameParts() {
  setWindowTitle(tr("The manual"));
  text_->setAccessibleName(tr("The manual"));
  text_->setToolTip(tr("Links lead to other pages"));
  const auto name = [](QPushButton& button, const QString& text, const QString& tip) {
    button.setText(text);
    button.setAccessibleName(text);
    button.setToolTip(tip);
  };
  name(*contents_, tr("Contents"), tr("The manual's first page"));
  name(*back_, tr("Close"), tr("Closes the manual"));
}

void Manual::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) nameParts();
  QWidget::changeEvent(event);
}

QString Manual::topicOf(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget()) {
    for (const Topic& one : topics) {
      if (widget->objectName() == QLatin1String(one.widget)) return one.topic;
    }
  }
  return firstPage;
}

void Manual::open(const QString& topic) {
  const QString page = topic.section('#', 0, 0), anchor = topic.section('#', 1);
  const QString folder = QString::fromStdString(resourcesFolder()) + "/help/";
  if (page != page_) {
    QFile file(folder + page);
    if (file.open(QIODevice::ReadOnly)) {
      text_->document()->setBaseUrl(QUrl::fromLocalFile(folder));
      text_->setMarkdown(QString::fromUtf8(file.readAll()));
      page_ = page;
    } else {
      text_->setPlainText(tr("The manual is not installed: %1 is missing").arg(file.fileName()));
      page_.clear();
    }
  }
  show();
  raise();
  int top = 0;
  for (QTextBlock block = text_->document()->begin(); block.isValid() && !anchor.isEmpty(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || anchorOf(block.text()) != anchor) continue;
    top = static_cast<int>(text_->document()->documentLayout()->blockBoundingRect(block).top());
    text_->setTextCursor(QTextCursor(block));
    break;
  }
  text_->verticalScrollBar()->setValue(top);
}

/// Links within the manual are followed here, others in the browser.
void Manual::follow(const QUrl& link) {
  if (!link.isRelative()) {
    QDesktopServices::openUrl(link);
    return;
  }
  const QString page = link.path().isEmpty() ? page_ : link.path();
  open(link.hasFragment() ? page + "#" + link.fragment() : page);
}

}  // namespace breakaway
