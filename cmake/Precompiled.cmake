# What most sources read anyway is read once for each kind of target: half of a cold build went into it. A source names what it
# uses all the same.

# breakaway_kind(NAME LIBRARY… HEADERS HEADER…): the kind NAME, precompiled with what targets of that kind compile with.
function(breakaway_kind name)
  cmake_parse_arguments(PARSE_ARGV 1 kind "" "" "LIBRARIES;HEADERS")
  set(source ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp)
  if(NOT EXISTS ${source})
    file(WRITE ${source} "")
  endif()
  add_library(breakaway_kind_${name} OBJECT ${source})
  target_link_libraries(breakaway_kind_${name} PRIVATE breakaway_options ${kind_LIBRARIES})
  target_precompile_headers(breakaway_kind_${name} PRIVATE ${kind_HEADERS})
endfunction()

# breakaway_of_kind(TARGET NAME): TARGET's sources begin with what the kind NAME has read.
function(breakaway_of_kind target name)
  target_precompile_headers(${target} REUSE_FROM breakaway_kind_${name})
endfunction()

# GCC 12 takes the code of a precompiled std::string for ours, and here and there warns of an overlap in it that isn't there
# (its bug 105329): for the targets in which it does.
function(breakaway_quiet_string target)
  target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endfunction()

set(common <algorithm> <array> <charconv> <chrono> <cmath> <complex> <cstdint> <cstdio> <cstring> <filesystem> <functional>
  <limits> <map> <memory> <numbers> <optional> <set> <span> <string> <string_view> <utility> <variant> <vector>)
breakaway_kind(plain LIBRARIES Eigen3::Eigen HEADERS ${common} <Eigen/Core>)
# What a command does is done in core; the options are read by templates that take long to optimise and gain nothing by it.
breakaway_kind(commands LIBRARIES CLI11::CLI11 nlohmann_json::nlohmann_json
  HEADERS ${common} <CLI/CLI.hpp> <nlohmann/json.hpp>)
target_compile_options(breakaway_kind_commands PRIVATE -O0)
if(BREAKAWAY_WINDOW)
  breakaway_kind(session LIBRARIES Qt6::Core HEADERS ${common} <QObject> <QString> <QStringList> <QVariant>)
  breakaway_kind(window LIBRARIES Qt6::Widgets Qt6::PrintSupport QCustomPlotQt6::QCustomPlotQt6
    HEADERS ${common} <qcustomplot.h> <QtWidgets>)
  breakaway_kind(test LIBRARIES Qt6::Test HEADERS ${common} <QTest>)
  breakaway_kind(window_test LIBRARIES Eigen3::Eigen Qt6::Widgets Qt6::Test HEADERS ${common} <Eigen/Core> <QtWidgets> <QTest>)
  # Of the sanitizers' checks a test's own code has so many that to optimise it takes a quarter of its compiling.
  set(BREAKAWAY_TEST_OPTIMISATION $<IF:$<BOOL:${BREAKAWAY_SANITIZE}>,-O0,-O1>)
  foreach(kind test window_test)
    target_compile_options(breakaway_kind_${kind} PRIVATE ${BREAKAWAY_TEST_OPTIMISATION})
  endforeach()
endif()
