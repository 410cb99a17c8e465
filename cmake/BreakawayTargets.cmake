# What every target of the house shares: warnings are errors, sanitizers on request, ways to add a room's files and a test.

add_library(breakaway_options INTERFACE)
target_compile_options(breakaway_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Werror)
# GCC collects its garbage only after another gigabyte: each time it goes through all that is precompiled, too, and that was
# a fifth of compiling a test.
target_compile_options(breakaway_options INTERFACE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=1048576>)
if(BREAKAWAY_TOGETHER)
  # What one source calls its own hides what another one beside it does.
  target_compile_options(breakaway_options INTERFACE -Wno-shadow -Wshadow=local -Wno-subobject-linkage)
endif()
if(BREAKAWAY_SANITIZE)
  # What a wrong address does, the address sanitizer sees; that of undefined behaviour would look before each access as well,
  # which was two fifths of compiling. Of its checks of addresses only alignment is seen by nobody then; the fuzzers, under
  # which all that reads bytes is, have every check.
  target_compile_options(breakaway_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize=null,alignment,object-size,pointer-overflow,vptr -fno-sanitize-recover=all -fno-omit-frame-pointer -Wno-maybe-uninitialized
    -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  # At a fixed address: the many places that the sanitizers name in reports needn't be moved, in the file or at each start.
  target_link_options(breakaway_options INTERFACE -fsanitize=address,undefined -no-pie)
endif()

# breakaway_room(NAME [FOLDER FOLDER] [SPELT FROM] [KIND KIND] [ALONE] [MOC] [USES ROOM…] [PUBLIC LIBRARY…] [PRIVATE LIBRARY…]):
# the target breakaway_NAME of the sources in FOLDER (default NAME), of the given kind (default plain), whose headers must
# stand alone (./dev lint compiles each). It sees its own headers and those of the rooms that it uses, with what these use; an
# include of any other room's header doesn't compile. For that each room has an include folder of its own in the build folder, with a link to the room and nothing else. Includes are
# spelt from the folder FROM (default: the caller's). ALONE: without the folders in FOLDER, which are rooms themselves.
# MOC: its classes are Qt's, and its headers needn't stand alone.
# With BREAKAWAY_TOGETHER, up to twelve sources of a room are compiled as one: what a source calls its own, no other source of
# its room may call so.
function(breakaway_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "ALONE;MOC" "FOLDER;SPELT;KIND" "USES;PUBLIC;PRIVATE")
  if(NOT room_FOLDER)
    set(room_FOLDER ${name})
  endif()
  if(NOT room_SPELT)
    set(room_SPELT ${CMAKE_CURRENT_SOURCE_DIR})
  endif()
  if(NOT room_KIND)
    set(room_KIND plain)
  endif()
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR}/${room_FOLDER} ABSOLUTE)
  file(RELATIVE_PATH spelt ${room_SPELT} ${folder})
  file(RELATIVE_PATH layer ${CMAKE_SOURCE_DIR} ${room_SPELT})
  set(includes ${CMAKE_BINARY_DIR}/rooms/${name})
  if(layer)
    set(includes ${includes}/${layer})
  endif()
  if(room_ALONE)
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*.h)
    foreach(header ${headers})
      breakaway_link_to(${folder}/${header} ${includes}/${spelt}/${header})
    endforeach()
    foreach(source ${sources})
      get_filename_component(base ${source} NAME)
      breakaway_link_to(${source} ${includes}/${spelt}/${base})
    endforeach()
  else()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*.h)
    breakaway_link_to(${folder} ${includes}/${spelt})
  endif()
  list(TRANSFORM room_USES PREPEND breakaway_)
  if(NOT sources)
    add_library(breakaway_${name} INTERFACE)
    set(seen INTERFACE)
  else()
    if(BREAKAWAY_TOGETHER)
      breakaway_together(${name} ${folder} "${spelt}" "${sources}" compiled)
    else()
      set(compiled ${sources})
    endif()
    add_library(breakaway_${name} STATIC ${compiled})
    target_link_libraries(breakaway_${name} PRIVATE breakaway_options ${room_PRIVATE})
    breakaway_of_kind(breakaway_${name} ${room_KIND})
    set(seen PUBLIC)
  endif()
  target_link_libraries(breakaway_${name} ${seen} ${room_USES} ${room_PUBLIC})
  if(room_MOC)
    list(TRANSFORM headers PREPEND ${folder}/)
    target_sources(breakaway_${name} PRIVATE ${headers})
    set_target_properties(breakaway_${name} PROPERTIES AUTOMOC ON)
    target_include_directories(breakaway_${name} ${seen} ${includes})
  else()
    list(TRANSFORM headers PREPEND ${includes}/${spelt}/)
    target_sources(breakaway_${name} ${seen} FILE_SET HEADERS BASE_DIRS ${includes} FILES ${headers})
  endif()
endfunction()

# Into COMPILED the files that include a room's sources, twelve each. They name them as the room's headers are named, not by
# where the checkout lies, as CMake's own unity builds do: for these a compiler cache serves no other checkout.
function(breakaway_together name folder spelt sources compiled)
  set(files "")
  list(LENGTH sources left)
  while(left GREATER 0)
    list(SUBLIST sources 0 12 some)
    list(REMOVE_ITEM sources ${some})
    list(LENGTH files count)
    list(LENGTH sources left)
    list(TRANSFORM some REPLACE "^${folder}/(.*)$" "#include \"${spelt}/\\1\"\n")
    list(JOIN some "" text)
    string(REPLACE "\"./" "\"" text "${text}")
    set(file ${CMAKE_CURRENT_BINARY_DIR}/together/${name}_${count}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)
    list(APPEND files ${file})
  endwhile()
  set(${compiled} ${files} PARENT_SCOPE)
endfunction()

function(breakaway_link_to from to)
  if(IS_SYMLINK ${to})
    file(READ_SYMLINK ${to} there)
    if(there STREQUAL from)
      return() # what is being built may be looking through it
    endif()
  else()
    file(REMOVE_RECURSE ${to})
  endif()
  get_filename_component(folder ${to} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  file(CREATE_LINK ${from} ${to} SYMBOLIC)
endfunction()

# breakaway_test_program(NAME LIBRARIES…): tests/…/NAME.cpp, relative to the caller, one QTest class with its own main.
function(breakaway_test_program name)
  set(kind test)
  if(breakaway_window IN_LIST ARGN)
    set(kind window_test)
  elseif(ARGN MATCHES "Qt6::(Gui|Widgets|Svg)")
    set(kind "") # a few only
  endif()
  get_filename_component(base ${name} NAME)
  # Its one class lies in that source: moc reads just it. AUTOMOC would look for more, and took a sixth of a build.
  set(slots ${CMAKE_CURRENT_BINARY_DIR}/moc/${base}.moc)
  qt_generate_moc(${name}.cpp ${slots})
  add_executable(${base} ${name}.cpp ${slots})
  set_target_properties(${base} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_include_directories(${base} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/moc)
  target_link_libraries(${base} PRIVATE breakaway_options breakaway_test_support Qt6::Test ${ARGN})
  target_compile_options(${base} PRIVATE ${BREAKAWAY_TEST_OPTIMISATION})  # as their kinds: what takes long is in the rooms
  if(kind)
    breakaway_of_kind(${base} ${kind})
  endif()
endfunction()

# The tests that take longest, longest first: begun first, so that no core is idle in the end while one of them runs.
set(breakaway_long_tests tst_diagnosis_quick tst_foreign_rigs tst_printed_commands tst_held_beliefs tst_commission
  tst_commission_wire tst_diagnose_noise tst_linear_journey tst_diagnose tst_diagnose_rigs tst_trial tst_wiring tst_commission_resume tst_compare_journey
  tst_faults tst_batch tst_honest_rig tst_servo_law tst_check tst_skeleton tst_provenance tst_tune tst_fuzz_corpus)

# breakaway_test(NAME LIBRARIES…): the same, run with all tests.
function(breakaway_test name)
  get_filename_component(base ${name} NAME)
  breakaway_test_program(${name} ${ARGN})
  add_test(NAME ${base} COMMAND ${base})
  list(FIND breakaway_long_tests ${base} place)
  if(place GREATER_EQUAL 0)
    math(EXPR cost "1000 - ${place}")
    set_tests_properties(${base} PROPERTIES COST ${cost})
  endif()
  set_tests_properties(${base} PROPERTIES
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;BREAKAWAY_SOURCE_DIR=${CMAKE_SOURCE_DIR};BREAKAWAY_BIN_DIR=${CMAKE_BINARY_DIR}/bin;UBSAN_OPTIONS=print_stacktrace=1;QTEST_FUNCTION_TIMEOUT=1200000"
    SKIP_REGULAR_EXPRESSION "SKIP   : .*all real recordings"
    TIMEOUT 1200)
endfunction()
