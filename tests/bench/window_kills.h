// What kills of the window leave of its project: while it records, sweeps, saves, and compares.
#pragma once

#include <QString>
#include <random>

#include "bench/project_kills.h"

namespace breakaway::test {

/// What the window is at when it is killed, as the program that is killed takes it.
inline constexpr const char* windowWorks[] = {"recording", "sweeping", "saving", "comparing"};

/// Starts `program --at-work WORK FOLDER`, which drives the real window, and kills it at random moments, always on the
/// same project.
ProjectKills killsOfTheWindow(const QString& program, const QString& work, const QString& folder, int kills,
                              std::mt19937& random);

}  // namespace breakaway::test
