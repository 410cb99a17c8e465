#include "resource_folder.h"

#include <QCoreApplication>
#include <QDir>

namespace breakaway {

QString resourceFolder(const QString& name) {
  const QString beside = QCoreApplication::applicationDirPath();
  for (const QString& base :
       {qEnvironmentVariable("BREAKAWAY_RESOURCES"), beside + "/../resources", beside + "/../../../resources",
        beside + "/../share/breakaway", QString("/usr/share/breakaway")}) {
    if (!base.isEmpty() && QDir(base + "/" + name).exists()) return QDir(base + "/" + name).canonicalPath();
  }
  return {};
}

QStringList resourceFiles(const QString& folder, const QString& ending) {
  const QString path = resourceFolder(folder);
  if (path.isEmpty()) return {};
  QStringList files;
  for (const QString& name : QDir(path).entryList({"*" + ending}, QDir::Files, QDir::Name)) files << path + "/" + name;
  return files;
}

}  // namespace breakaway
