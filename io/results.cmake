# Sample and Frame -> files; mesh import
target_sources(corpuscle_io PRIVATE
    atomic_file.cpp
    hdf5.cpp
    history_table.cpp
    results_file.cpp
    units.cpp
    xdmf.cpp)
