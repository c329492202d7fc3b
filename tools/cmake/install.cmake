# cmake --install: the program, and the rooms as libraries with their headers under corpuscle/.
include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/corpuscle)

install(TARGETS corpuscle COMPONENT program)

set(rooms base fabric contact gas solver io)
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
    set(CORPUSCLE_PC_LIBS -fopenmp)
else()
    set(CORPUSCLE_PC_LIBS "")
endif()
configure_file(tools/package/corpuscle.pc.in ${CMAKE_BINARY_DIR}/corpuscle.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/corpuscle.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)
