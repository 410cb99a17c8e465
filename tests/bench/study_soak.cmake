target_link_libraries(${name} PRIVATE breakaway_transport Qt6::Core)
add_dependencies(${name} breakaway-board)
