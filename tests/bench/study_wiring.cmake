target_sources(${name} PRIVATE wiring_runs.cpp)
target_link_libraries(${name} PRIVATE breakaway_transport CLI11::CLI11 nlohmann_json::nlohmann_json Qt6::Core)
add_dependencies(${name} breakaway breakaway-board)
