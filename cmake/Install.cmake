# SPDX-License-Identifier: MIT
# What `cmake --install` puts where, and the package that find_package(polydec) finds there.
include(CMakePackageConfigHelpers)

# The include directory that is exported is include/polydec itself, so that #include "dec/stars/star.h"
# and <polydec.h> read the same before and after installing.
set(polydec_include_dir ${CMAKE_INSTALL_INCLUDEDIR}/polydec)
set(polydec_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/polydec)

install(TARGETS polydec EXPORT polydecTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT polydec
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT polydec
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT polydec
    FILE_SET HEADERS DESTINATION ${polydec_include_dir} COMPONENT polydec)
install(EXPORT polydecTargets NAMESPACE polydec::
    DESTINATION ${polydec_package_dir} COMPONENT polydec)

foreach(name IN LISTS polydec_built_components)
    install(TARGETS polydec_${name}_module
        LIBRARY DESTINATION ${polydec_module_folder} COMPONENT ${name})
endforeach()

# A component to link is an export set of its own: who installs the core alone needs nothing of what
# is behind it.
foreach(name IN LISTS polydec_linked_components)
    set_target_properties(polydec_${name} PROPERTIES EXPORT_NAME ${name} INSTALL_RPATH "$ORIGIN")
    install(TARGETS polydec_${name} EXPORT polydecTargets_${name}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${name}
        FILE_SET HEADERS DESTINATION ${polydec_include_dir} COMPONENT ${name})
    install(EXPORT polydecTargets_${name} NAMESPACE polydec::
        DESTINATION ${polydec_package_dir} COMPONENT ${name})
    install(FILES ${PROJECT_SOURCE_DIR}/cmake/Find${${name}_package}.cmake
        DESTINATION ${polydec_package_dir} COMPONENT ${name})
endforeach()

# The command finds a shared polydec beside itself, wherever the whole tree is moved.
if(TARGET polydec_command)
    if(polydec_needs_run_path)
        set_target_properties(polydec_command PROPERTIES
            INSTALL_RPATH "$ORIGIN/${polydec_lib_from_bin}")
    endif()
    install(TARGETS polydec_command
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT polydec)
    install(FILES ${PROJECT_SOURCE_DIR}/cmake/polydec.metainfo.xml COMPONENT polydec
        DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo RENAME invalid.polydec.polydec.metainfo.xml)
    include(ShellFiles)
endif()

if(TARGET polydec_mpi_command)
    set_target_properties(polydec_mpi_command PROPERTIES
        INSTALL_RPATH "$ORIGIN/${polydec_lib_from_bin}")
    install(TARGETS polydec_mpi_command
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT distributed)
endif()

get_target_property(polydec_type polydec TYPE)

# For compilers without CMake: g++ program.cpp $(pkg-config --cflags --libs polydec). A program has
# the library folder in its run path, where it finds a shared polydec, and a static one the engines.
set(polydec_pc_requires)
set(polydec_pc_libraries)
set(polydec_pc_run_path)
if(polydec_type STREQUAL "STATIC_LIBRARY")
    set(polydec_pc_requires ", fmt, zlib")
    set(polydec_pc_libraries " ${OpenMP_CXX_FLAGS}")
    foreach(library IN LISTS CMAKE_DL_LIBS)
        string(APPEND polydec_pc_libraries " -l${library}")
    endforeach()
endif()
if(UNIX AND polydec_needs_run_path)
    set(polydec_pc_run_path " -Wl,-rpath,\${libdir}")
endif()
file(RELATIVE_PATH polydec_prefix_from_pc
    ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" polydec_prefix_from_pc "${polydec_prefix_from_pc}")
configure_file(${PROJECT_SOURCE_DIR}/cmake/polydec.pc.in ${PROJECT_BINARY_DIR}/polydec.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/polydec.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT polydec)

set(polydec_find_components)
foreach(name IN LISTS polydec_components)
    if(${name}_header)
        string(APPEND polydec_find_components
            "polydec_find_component(${name} ${${name}_package} ${${name}_debian})\n")
    endif()
endforeach()
# Before 1.0 a new minor version may break its users.
configure_package_config_file(
    ${PROJECT_SOURCE_DIR}/cmake/polydecConfig.cmake.in
    ${PROJECT_BINARY_DIR}/polydecConfig.cmake
    INSTALL_DESTINATION ${polydec_package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
    ${PROJECT_BINARY_DIR}/polydecConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/polydecConfig.cmake
    ${PROJECT_BINARY_DIR}/polydecConfigVersion.cmake
    DESTINATION ${polydec_package_dir} COMPONENT polydec)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE
    DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT polydec)
