target_link_libraries(${name} PRIVATE Qt6::Core)
add_dependencies(${name} breakaway)
