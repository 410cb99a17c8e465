// Where presets, examples and the manual lie.
#pragma once

#include <QString>
#include <QStringList>

namespace breakaway {

/// The folder `name` of the resources: below BREAKAWAY_RESOURCES, beside the program, in the source tree, or installed;
/// empty when it is nowhere.
QString resourceFolder(const QString& name);

/// Full paths of the files in that folder whose names end so, by name.
QStringList resourceFiles(const QString& folder, const QString& ending);

}  // namespace breakaway
