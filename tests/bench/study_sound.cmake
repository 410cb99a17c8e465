target_sources(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests/support/plain_motor.cpp)
target_link_libraries(${name} PRIVATE fmt::fmt)
