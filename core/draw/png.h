// Figures as PNG, for programs that show no SVG.
#pragma once

#include <string>

#include "base/result.h"

namespace breakaway {

/// Draws the SVG file at `svgPath` into a PNG at `pngPath`, `scale` px per px, on white; written under a temporary name
/// and renamed. By the program rsvg-convert (package librsvg2-bin) in a process of its own: linked in, its drawing
/// library would bring X11 into a program that needs no display. Errors: that program is missing, or says why not.
Result<void> convertToPng(const std::string& svgPath, const std::string& pngPath, double scale = 1.5);

/// Whether rsvg-convert can be run; the error says what is missing. To be asked before long work.
Result<void> pngCanBeWritten();

}  // namespace breakaway
