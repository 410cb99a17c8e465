include(${CMAKE_SOURCE_DIR}/tests/support/foreign.cmake)
