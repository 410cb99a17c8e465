// Files that come with the program: presets, examples.
#pragma once

#include <QString>
#include <QStringList>

namespace breakaway {

/// Full paths of the files in the resources' folder `folder` whose names end so, by name; none when the folder is
/// missing.
QStringList resourceFiles(const QString& folder, const QString& ending);

}  // namespace breakaway
