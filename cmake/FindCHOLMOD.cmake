# SPDX-License-Identifier: MIT
# Finds SuiteSparse's CHOLMOD, for which Debian ships no CMake package.
#   CHOLMOD_FOUND, CHOLMOD_VERSION
#   SuiteSparse::CHOLMOD   imported target, with the SuiteSparse libraries that it needs
include(FindPackageHandleStandardArgs)

find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
set(CHOLMOD_DEPENDENCIES)
set(CHOLMOD_DEPENDENCY_VARIABLES)
foreach(library amd colamd camd ccolamd suitesparseconfig)
    find_library(CHOLMOD_${library}_LIBRARY ${library})
    list(APPEND CHOLMOD_DEPENDENCIES "${CHOLMOD_${library}_LIBRARY}")
    list(APPEND CHOLMOD_DEPENDENCY_VARIABLES CHOLMOD_${library}_LIBRARY)
endforeach()

# Up to SuiteSparse 5 the numbers stand in cholmod_core.h, since 6 in cholmod.h itself.
foreach(header cholmod_core.h cholmod.h)
    if(NOT CHOLMOD_VERSION AND EXISTS "${CHOLMOD_INCLUDE_DIR}/${header}")
        set(numbers)
        foreach(part MAIN SUB SUBSUB)
            file(STRINGS "${CHOLMOD_INCLUDE_DIR}/${header}" line
                REGEX "#define[ \t]+CHOLMOD_${part}_VERSION[ \t]+[0-9]+")
            if(line MATCHES "VERSION[ \t]+([0-9]+)")
                list(APPEND numbers ${CMAKE_MATCH_1})
            endif()
        endforeach()
        list(JOIN numbers "." CHOLMOD_VERSION)
    endif()
endforeach()

find_package_handle_standard_args(CHOLMOD
    REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_INCLUDE_DIR ${CHOLMOD_DEPENDENCY_VARIABLES}
    VERSION_VAR CHOLMOD_VERSION)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY ${CHOLMOD_DEPENDENCY_VARIABLES})

if(CHOLMOD_FOUND AND NOT TARGET SuiteSparse::CHOLMOD)
    add_library(SuiteSparse::CHOLMOD UNKNOWN IMPORTED)
    set_target_properties(SuiteSparse::CHOLMOD PROPERTIES
        IMPORTED_LOCATION "${CHOLMOD_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES "${CHOLMOD_DEPENDENCIES}")
endif()
