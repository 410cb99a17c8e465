#include "screenshots.h"

#include "base/atomic_file.h"
#include "tour.h"
#include "widgets/look.h"

namespace breakaway {

Result<void> takeScreenshots(const QString& folder) {
  if (auto made = makeFolder(folder.toStdString()); !made) return made;
  for (const QString& theme : {QString("light"), QString("dark")}) {
    wear(theme == "dark" ? Theme::dark : Theme::light);
    Tour tour(folder, theme);
    if (auto done = tour.run(); !done) return done;
  }
  return {};
}

}  // namespace breakaway
