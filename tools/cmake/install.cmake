# cmake --install: the program, and the rooms as libraries with their headers under corpuscle/.
include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/corpuscle)

install(TARGETS corpuscle COMPONENT program)

set(rooms base fabric broad_phase contact gas solver io)
foreach(room ${rooms})
    set_target_properties(corpuscle_${room} PROPERTIES EXPORT_NAME ${room})
    install(TARGETS corpuscle_${room} EXPORT corpuscle-targets COMPONENT library)
endforeach()
install(EXPORT corpuscle-targets NAMESPACE corpuscle:: DESTINATION ${config_dir} COMPONENT library)

set(headers ${CMAKE_BINARY_DIR}/public_headers)
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DFROM=${CMAKE_SOURCE_DIR}\" \"-DTO=${headers}\"
    -P \"${CMAKE_SOURCE_DIR}/tools/cmake/public_headers.cmake\" COMMAND_ERROR_IS_FATAL ANY)" COMPONENT library)
install(DIRECTORY ${headers}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)

configure_package_config_file(tools/package/corpuscle-config.cmake.in ${CMAKE_BINARY_DIR}/corpuscle-config.cmake
    INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/corpuscle-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/corpuscle-config.cmake ${CMAKE_BINARY_DIR}/corpuscle-config-version.cmake
    DESTINATION ${config_dir} COMPONENT library)

file(RELATIVE_PATH CORPUSCLE_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" CORPUSCLE_PC_PREFIX "${CORPUSCLE_PC_PREFIX}")
if(CORPUSCLE_THREADS)
    set(CORPUSCLE_PC_LIBS -pthread)
else()
    set(CORPUSCLE_PC_LIBS "")
endif()
configure_file(tools/package/corpuscle.pc.in ${CMAKE_BINARY_DIR}/corpuscle.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/corpuscle.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)

# Manual pages and completions, as tools/package makes them from the description of the command line
install(DIRECTORY ${CMAKE_BINARY_DIR}/pages/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
install(FILES ${CMAKE_BINARY_DIR}/pages/bash/corpuscle
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${CMAKE_BINARY_DIR}/pages/zsh/_corpuscle
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(DIRECTORY models DESTINATION ${CMAKE_INSTALL_DATADIR}/corpuscle COMPONENT program)
install(FILES tools/package/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/corpuscle COMPONENT program)
install(FILES tools/package/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libcorpuscle-dev COMPONENT library)

# The program once more, for processors with AVX2, which it then starts in its place
set(CORPUSCLE_PROGRAM_V3 "" CACHE FILEPATH "Program of a build with CORPUSCLE_ARCH=x86-64-v3, to be installed beside this one")
if(CORPUSCLE_PROGRAM_V3)
    install(PROGRAMS ${CORPUSCLE_PROGRAM_V3} DESTINATION libexec/corpuscle RENAME corpuscle-x86-64-v3 COMPONENT program)
endif()

# cpack: corpuscle_VERSION_amd64.deb and libcorpuscle-dev_VERSION_amd64.deb
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The corpuscle developers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME corpuscle)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Reads LS-DYNA keyword decks: membrane finite elements, gas as particles that
obey kinetic theory, and contact, in one central-difference integrator.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libcorpuscle-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
    "libeigen3-dev, libfmt-dev, libfcl-dev, libccd-dev, libassimp-dev, libhdf5-dev, libspdlog-dev, librandom123-dev")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "Fabric, gas, contact, solver and input/output, each of use by itself: static
libraries, headers, and files for CMake and pkg-config.")
include(CPack)
