# Warnings are a target: link it last and privately.
add_library(corpuscle_warnings INTERFACE)
add_library(corpuscle::warnings ALIAS corpuscle_warnings)
target_compile_options(corpuscle_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wnull-dereference
    -Wno-maybe-uninitialized)  # false alarms from inlined Eigen temporaries in g++ 12
