#include "session/resource_folder.h"

#include <QDir>

#include "firmware_link/presets.h"

namespace breakaway {

QStringList resourceFiles(const QString& folder, const QString& ending) {
  const std::string resources = resourcesFolder();
  if (resources.empty()) return {};
  const QDir place(QString::fromStdString(resources) + "/" + folder);
  QStringList files;
  for (const QString& name : place.entryList({"*" + ending}, QDir::Files, QDir::Name)) files << place.filePath(name);
  return files;
}

}  // namespace breakaway
