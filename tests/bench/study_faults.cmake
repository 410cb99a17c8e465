target_sources(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests/support/disturbed_output.cpp ${CMAKE_SOURCE_DIR}/tests/support/small_disk.cpp
  ${CMAKE_CURRENT_SOURCE_DIR}/project_kills.cpp ${CMAKE_CURRENT_SOURCE_DIR}/window_kills.cpp)
target_compile_definitions(${name} PRIVATE BREAKAWAY_WINDOW_AT_WORK="$<TARGET_FILE:tst_window_kills>")
target_link_libraries(${name} PRIVATE breakaway_session Qt6::Core)
add_dependencies(${name} breakaway tst_window_kills)
