target_link_libraries(${name} PRIVATE breakaway_trial Qt6::Core)
add_dependencies(${name} breakaway)
