target_sources(${name} PRIVATE regression_baselines.cpp)
target_link_libraries(${name} PRIVATE CLI11::CLI11)
