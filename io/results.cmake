# Sample and Frame -> files; mesh import
target_sources(corpuscle_io PRIVATE
    ascii_files.cpp
    ascii_tables.cpp
    rigid_history.cpp
    responses/body_responses.cpp
    responses/channel_filter.cpp
    responses/criteria.cpp
    responses/response_tables.cpp
    atomic_file.cpp
    checkpoint.cpp
    deck_writer.cpp
    export/binout.cpp
    export/d3plot.cpp
    export/history_source.cpp
    export/iso_mme.cpp
    export/lsda.cpp
    hdf5.cpp
    history_table.cpp
    mesh_check.cpp
    mesh_file.cpp
    mesh_weld.cpp
    progress.cpp
    reserve.cpp
    results_file.cpp
    units.cpp
    xdmf.cpp)
