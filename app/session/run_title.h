// What a run of a project is called: its kind and when it was.
#pragma once

#include <QString>
#include <span>
#include <string>
#include <string_view>

#include "project/run.h"

namespace breakaway {

/// A name in the project's files, and what the window calls it: words of the context "RunWords".
struct NameInWords {
  std::string_view name;
  const char* words;
};

/// Words of the context "RunWords" in the language that is spoken.
QString runWords(const char* text);
/// What `name` is called by the list; one that isn't in it as it is.
QString inWords(std::span<const NameInWords> list, const std::string& name);

/// "Friction map" of commission and map, "Recording", …; a kind without words as it is.
QString kindInWords(const std::string& kind);
/// "2026-03-02 10:14", by the clock on the wall.
QString timeInWords(const ProjectRun& run);
/// "Friction map of 2026-03-02 10:14 (before greasing)".
QString titleOf(const ProjectRun& run);

}  // namespace breakaway
