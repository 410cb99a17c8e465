target_sources(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests/support/foreign_rig.cpp)
target_link_libraries(${name} PRIVATE fmt::fmt)
