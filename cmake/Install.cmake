# SPDX-License-Identifier: MIT
# What `cmake --install` puts where, and the package that find_package(polydec) finds there.
include(CMakePackageConfigHelpers)

# The include directory that is exported is include/polydec itself, so that #include "dec/star.h"
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

# An engine is an export set of its own: who installs the core alone needs nothing of SuiteSparse.
if(TARGET polydec_cholmod)
    set_target_properties(polydec_cholmod PROPERTIES EXPORT_NAME cholmod INSTALL_RPATH "$ORIGIN")
    get_target_property(header_sets polydec_cholmod INTERFACE_HEADER_SETS)
    set(headers)
    if(header_sets)
        set(headers FILE_SET HEADERS DESTINATION ${polydec_include_dir} COMPONENT cholmod)
    endif()
    install(TARGETS polydec_cholmod EXPORT polydecCholmodTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT cholmod
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT cholmod
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT cholmod
        ${headers})
    install(EXPORT polydecCholmodTargets NAMESPACE polydec::
        DESTINATION ${polydec_package_dir} COMPONENT cholmod)
    install(FILES ${PROJECT_SOURCE_DIR}/cmake/FindCHOLMOD.cmake
        DESTINATION ${polydec_package_dir} COMPONENT cholmod)
endif()

# The command finds a shared polydec beside itself, wherever the whole tree is moved.
if(TARGET polydec_command)
    file(RELATIVE_PATH bin_to_lib
        ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
    set_target_properties(polydec_command PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")
    install(TARGETS polydec_command
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT polydec)
endif()

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
