target_sources(${name} PRIVATE map_score.cpp)
target_link_libraries(${name} PRIVATE CLI11::CLI11)
