set(support ${CMAKE_SOURCE_DIR}/tests/support)
target_sources(${name} PRIVATE ${support}/foreign_rig.cpp ${support}/foreign_families.cpp ${support}/foreign_moves.cpp
  ${support}/foreign_plant.cpp ${support}/foreign_motor.cpp)
target_link_libraries(${name} PRIVATE fmt::fmt)
