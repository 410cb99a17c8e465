target_link_libraries(${name} PRIVATE breakaway_window)
