# SPDX-License-Identifier: MIT
# What `cmake --install` puts where, and the package that find_package(polydec) finds there.
include(CMakePackageConfigHelpers)

# The include directory that is exported is include/polydec itself, so that #include "dec/forms/star.h"
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

# An engine is an export set of its own: who installs the core alone needs nothing of what is behind
# it. polydec_install_component(cholmod Cholmod FindCHOLMOD ..), with the modules that find it.
function(polydec_install_component name Name)
    if(NOT TARGET polydec_${name})
        return()
    endif()
    set_target_properties(polydec_${name} PROPERTIES EXPORT_NAME ${name} INSTALL_RPATH "$ORIGIN")
    get_target_property(header_sets polydec_${name} INTERFACE_HEADER_SETS)
    set(headers)
    if(header_sets)
        set(headers FILE_SET HEADERS DESTINATION ${polydec_include_dir} COMPONENT ${name})
    endif()
    install(TARGETS polydec_${name} EXPORT polydec${Name}Targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${name}
        ${headers})
    install(EXPORT polydec${Name}Targets NAMESPACE polydec::
        DESTINATION ${polydec_package_dir} COMPONENT ${name})
    foreach(module IN LISTS ARGN)
        install(FILES ${PROJECT_SOURCE_DIR}/cmake/${module}.cmake
            DESTINATION ${polydec_package_dir} COMPONENT ${name})
    endforeach()
endfunction()
polydec_install_component(cholmod Cholmod FindCHOLMOD)
polydec_install_component(petsc Petsc FindPETSc)
polydec_install_component(slepc Slepc FindSLEPc)

# The command finds a shared polydec beside itself, wherever the whole tree is moved.
if(TARGET polydec_command)
    file(RELATIVE_PATH bin_to_lib
        ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
    set_target_properties(polydec_command PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")
    install(TARGETS polydec_command
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT polydec)
endif()

get_target_property(polydec_type polydec TYPE)
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
