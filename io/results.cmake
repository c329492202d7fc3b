# Sample and Frame -> files; mesh import
target_sources(corpuscle_io PRIVATE results_file.cpp)
