target_sources(${name} PRIVATE map_score.cpp map_families.cpp)
target_link_libraries(${name} PRIVATE CLI11::CLI11 nlohmann_json::nlohmann_json)
