target_sources(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/plain_motor.cpp)
target_link_libraries(${name} PRIVATE fmt::fmt)
