# SPDX-License-Identifier: MIT
# Finds the sequential MUMPS in double precision, for which Debian ships no CMake package.
#   MUMPS_FOUND, MUMPS_VERSION
#   MUMPS::MUMPS   imported target, with its stand-in for MPI
include(FindPackageHandleStandardArgs)

find_path(MUMPS_INCLUDE_DIR dmumps_c.h)
find_library(MUMPS_LIBRARY dmumps_seq)
find_library(MUMPS_COMMON_LIBRARY mumps_common_seq)
find_library(MUMPS_MPI_LIBRARY mpiseq_seq)

if(EXISTS "${MUMPS_INCLUDE_DIR}/dmumps_c.h")
    file(STRINGS "${MUMPS_INCLUDE_DIR}/dmumps_c.h" line REGEX "#define[ \t]+MUMPS_VERSION[ \t]+\"")
    if(line MATCHES "\"([0-9.]+)\"")
        set(MUMPS_VERSION ${CMAKE_MATCH_1})
    endif()
endif()

find_package_handle_standard_args(MUMPS
    REQUIRED_VARS MUMPS_LIBRARY MUMPS_COMMON_LIBRARY MUMPS_MPI_LIBRARY MUMPS_INCLUDE_DIR
    VERSION_VAR MUMPS_VERSION)
mark_as_advanced(MUMPS_INCLUDE_DIR MUMPS_LIBRARY MUMPS_COMMON_LIBRARY MUMPS_MPI_LIBRARY)

if(MUMPS_FOUND AND NOT TARGET MUMPS::MUMPS)
    add_library(MUMPS::MUMPS UNKNOWN IMPORTED)
    set_target_properties(MUMPS::MUMPS PROPERTIES
        IMPORTED_LOCATION "${MUMPS_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${MUMPS_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES "${MUMPS_COMMON_LIBRARY};${MUMPS_MPI_LIBRARY}")
endif()
