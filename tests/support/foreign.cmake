# Other people's rigs, for the target `name`.
set(foreign ${CMAKE_SOURCE_DIR}/tests/support/foreign)
target_sources(${name} PRIVATE ${foreign}_rig.cpp ${foreign}_families.cpp ${foreign}_moves.cpp ${foreign}_plant.cpp
  ${foreign}_motor.cpp)
target_link_libraries(${name} PRIVATE fmt::fmt)
