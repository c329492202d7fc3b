# Sample and Frame -> files; mesh import
target_sources(corpuscle_io PRIVATE
    ascii_files.cpp
    ascii_tables.cpp
    atomic_file.cpp
    hdf5.cpp
    history_table.cpp
    progress.cpp
    results_file.cpp
    units.cpp
    xdmf.cpp)
