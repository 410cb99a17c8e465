// The manual in a window of its own: the page and heading that belong to what is under the cursor.
#pragma once

#include <QString>
#include <QWidget>

class QPushButton;
class QTextBrowser;

namespace breakaway {

class Manual : public QWidget {
  Q_OBJECT

 public:
  /// A window beside `parent`.
  explicit Manual(QWidget* parent);
  /// Shows a page, or its heading: "window.md#tune". Where the manual isn't installed, it says so.
  void open(const QString& topic);
  /// Of the widget, or of the nearest one around it that has one; the manual's first page where none does.
  static QString topicOf(const QWidget* widget);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void nameParts();
  void follow(const QUrl& link);

  QTextBrowser* text_ = nullptr;
  QPushButton* contents_ = nullptr;
  QPushButton* back_ = nullptr;
  QString page_;
};

/// The name of a heading as links have it: "## Drive by hand" is "drive-by-hand".
QString anchorOf(const QString& heading);

}  // namespace breakaway
