# Warnings are a target: link it last and privately.
add_library(corpuscle_warnings INTERFACE)
add_library(corpuscle::warnings ALIAS corpuscle_warnings)
set(null_dereference -Wnull-dereference)
if(CORPUSCLE_SANITIZE)
    set(null_dereference)  # minutes a file, where sanitizers have put a branch before every access
endif()
target_compile_options(corpuscle_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual ${null_dereference})
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # false alarms from inlined Eigen temporaries in g++ 12
    target_compile_options(corpuscle_warnings INTERFACE -Wno-maybe-uninitialized)
    if(CORPUSCLE_ARCH)
        # packs of four numbers go through memory where a processor has no AVX; nobody outside is handed one
        target_compile_options(corpuscle_warnings INTERFACE -Wno-psabi)
    endif()
else()
    # comparisons joined by & have no branch: meant so
    target_compile_options(corpuscle_warnings INTERFACE -Wno-bitwise-instead-of-logical)
endif()
