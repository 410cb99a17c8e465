# What every target of the house shares: warnings are errors, sanitizers on request, ways to add a room's files and a test.

add_library(breakaway_options INTERFACE)
target_compile_options(breakaway_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Werror)
if(BREAKAWAY_SANITIZE)
  target_compile_options(breakaway_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -Wno-maybe-uninitialized)
  target_link_options(breakaway_options INTERFACE -fsanitize=address,undefined)
endif()

# breakaway_library(NAME DIRECTORY [EXCEPT FOLDER…]): a static library of all sources below DIRECTORY, without those of
# FOLDERs in it; its headers must stand alone.
function(breakaway_library name directory)
  cmake_parse_arguments(PARSE_ARGV 2 library "" "" "EXCEPT")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${directory}/*.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${directory}/*.h)
  foreach(folder ${library_EXCEPT})
    list(FILTER sources EXCLUDE REGEX "^${directory}/${folder}/")
    list(FILTER headers EXCLUDE REGEX "^${directory}/${folder}/")
  endforeach()
  add_library(${name} STATIC ${sources})
  target_sources(${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${directory} FILES ${headers})
  target_link_libraries(${name} PRIVATE breakaway_options)
endfunction()

# breakaway_test_program(NAME LIBRARIES…): tests/…/NAME.cpp, relative to the caller, one QTest class with its own main.
function(breakaway_test_program name)
  get_filename_component(base ${name} NAME)
  add_executable(${base} ${name}.cpp)
  set_target_properties(${base} PROPERTIES AUTOMOC ON RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_link_libraries(${base} PRIVATE breakaway_options breakaway_test_support Qt6::Test ${ARGN})
endfunction()

# breakaway_test(NAME LIBRARIES…): the same, run with all tests.
function(breakaway_test name)
  get_filename_component(base ${name} NAME)
  breakaway_test_program(${name} ${ARGN})
  add_test(NAME ${base} COMMAND ${base})
  set_tests_properties(${base} PROPERTIES
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;BREAKAWAY_SOURCE_DIR=${CMAKE_SOURCE_DIR};BREAKAWAY_BIN_DIR=${CMAKE_BINARY_DIR}/bin;UBSAN_OPTIONS=print_stacktrace=1;QTEST_FUNCTION_TIMEOUT=1200000"
    SKIP_REGULAR_EXPRESSION "SKIP   : .*all real recordings"
    TIMEOUT 1200)
endfunction()
