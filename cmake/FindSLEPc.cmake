# SPDX-License-Identifier: MIT
# Finds SLEPc, which Debian installs apart from everything else and without a CMake package.
#   SLEPC_DIR, as variable or in the environment, with PETSC_ARCH: where one built by hand lies
#   SLEPc_FOUND, SLEPc_VERSION
#   SLEPc::SLEPc   imported target, with PETSc::PETSc
include(FindPackageHandleStandardArgs)

find_package(PETSc QUIET)
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(PC_SLEPC QUIET slepc)
endif()
foreach(variable SLEPC_DIR PETSC_ARCH)
    if(NOT ${variable})
        set(${variable} "$ENV{${variable}}")
    endif()
endforeach()
set(places)
if(SLEPC_DIR)
    list(APPEND places "${SLEPC_DIR}/${PETSC_ARCH}" "${SLEPC_DIR}")
endif()
list(APPEND places ${PC_SLEPC_PREFIX})

find_path(SLEPC_INCLUDE_DIR slepceps.h HINTS ${places} PATH_SUFFIXES include)
find_path(SLEPC_CONFIG_INCLUDE_DIR slepcconf.h HINTS ${places} PATH_SUFFIXES include)
find_library(SLEPC_LIBRARY NAMES slepc slepc_real slepc64_real NAMES_PER_DIR
    HINTS ${places} PATH_SUFFIXES lib)

if(EXISTS "${SLEPC_INCLUDE_DIR}/slepcversion.h")
    set(numbers)
    foreach(part MAJOR MINOR SUBMINOR)
        file(STRINGS "${SLEPC_INCLUDE_DIR}/slepcversion.h" line
            REGEX "#define[ \t]+SLEPC_VERSION_${part}[ \t]+[0-9]+")
        if(line MATCHES "SLEPC_VERSION_${part}[ \t]+([0-9]+)")
            list(APPEND numbers ${CMAKE_MATCH_1})
        endif()
    endforeach()
    list(JOIN numbers "." SLEPc_VERSION)
endif()

# SLEPc works with the very PETSc that it was built with: their versions agree up to the last part.
set(SLEPC_FITS_PETSC FALSE)
if(PETSc_FOUND AND SLEPc_VERSION)
    string(REGEX MATCH "^[0-9]+\\.[0-9]+" of_petsc "${PETSc_VERSION}")
    string(REGEX MATCH "^[0-9]+\\.[0-9]+" of_slepc "${SLEPc_VERSION}")
    if(of_petsc STREQUAL of_slepc)
        set(SLEPC_FITS_PETSC TRUE)
    endif()
endif()

find_package_handle_standard_args(SLEPc
    REQUIRED_VARS SLEPC_LIBRARY SLEPC_INCLUDE_DIR SLEPC_CONFIG_INCLUDE_DIR PETSc_FOUND
        SLEPC_FITS_PETSC
    VERSION_VAR SLEPc_VERSION)
mark_as_advanced(SLEPC_INCLUDE_DIR SLEPC_CONFIG_INCLUDE_DIR SLEPC_LIBRARY)

if(SLEPc_FOUND AND NOT TARGET SLEPc::SLEPc)
    add_library(SLEPc::SLEPc UNKNOWN IMPORTED)
    set_target_properties(SLEPc::SLEPc PROPERTIES
        IMPORTED_LOCATION "${SLEPC_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${SLEPC_INCLUDE_DIR};${SLEPC_CONFIG_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES PETSc::PETSc)
endif()
