// One step of the technician's job.
#pragma once

#include <QString>
#include <QWidget>

namespace breakaway {

class Page : public QWidget {
  Q_OBJECT

 public:
  Page(const char* objectName, const QString& title, const QString& icon, QWidget* parent)
      : QWidget(parent), title_(title), icon_(icon) {
    setObjectName(objectName);
    setAccessibleName(title);
  }

  const QString& title() const { return title_; }
  const QString& icon() const { return icon_; }

 private:
  QString title_;
  QString icon_;
};

}  // namespace breakaway
