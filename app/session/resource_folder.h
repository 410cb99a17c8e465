// Files that come with the program: presets, examples.
#pragma once

#include <QString>
#include <QStringList>

namespace breakaway {

/// Full paths of those files in the resources' `folder` whose names end in `ending`, sorted by name; none if the folder
/// is missing.
QStringList resourceFiles(const QString& folder, const QString& ending);

}  // namespace breakaway
