# SPDX-License-Identifier: MIT
# Finds PETSc, which Debian installs apart from everything else and without a CMake package.
#   PETSC_DIR and PETSC_ARCH, as variables or in the environment: where a PETSc built by hand lies
#   PETSc_FOUND, PETSc_VERSION
#   PETSc::PETSc   imported target, with the MPI that it was built with
# Only real numbers in double precision will do. Integers may have 32 bits, as in Debian's petsc-dev,
# or 64, as in its petsc64-dev, which PETSC_DIR selects.
include(FindPackageHandleStandardArgs)

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(PC_PETSC QUIET petsc)
endif()
foreach(variable PETSC_DIR PETSC_ARCH)
    if(NOT ${variable})
        set(${variable} "$ENV{${variable}}")
    endif()
endforeach()
set(places)
if(PETSC_DIR)
    list(APPEND places "${PETSC_DIR}/${PETSC_ARCH}" "${PETSC_DIR}")
endif()
list(APPEND places ${PC_PETSC_PREFIX})

find_path(PETSC_INCLUDE_DIR petscksp.h HINTS ${places} PATH_SUFFIXES include)
find_path(PETSC_CONFIG_INCLUDE_DIR petscconf.h HINTS ${places} PATH_SUFFIXES include)
find_library(PETSC_LIBRARY NAMES petsc petsc_real petsc64_real NAMES_PER_DIR
    HINTS ${places} PATH_SUFFIXES lib)

if(EXISTS "${PETSC_INCLUDE_DIR}/petscversion.h")
    set(numbers)
    foreach(part MAJOR MINOR SUBMINOR)
        file(STRINGS "${PETSC_INCLUDE_DIR}/petscversion.h" line
            REGEX "#define[ \t]+PETSC_VERSION_${part}[ \t]+[0-9]+")
        if(line MATCHES "PETSC_VERSION_${part}[ \t]+([0-9]+)")
            list(APPEND numbers ${CMAKE_MATCH_1})
        endif()
    endforeach()
    list(JOIN numbers "." PETSc_VERSION)
endif()

# PETSc is built for one kind of number; what does not fit is as good as not there.
set(PETSC_HAS_FITTING_NUMBERS FALSE)
set(needs_mpi TRUE)
set(reason)
if(EXISTS "${PETSC_CONFIG_INCLUDE_DIR}/petscconf.h")
    file(READ "${PETSC_CONFIG_INCLUDE_DIR}/petscconf.h" configuration)
    set(PETSC_HAS_FITTING_NUMBERS TRUE)
    if(NOT configuration MATCHES "#define PETSC_USE_REAL_DOUBLE 1"
       OR configuration MATCHES "#define PETSC_USE_COMPLEX 1")
        set(PETSC_HAS_FITTING_NUMBERS FALSE)
        set(reason "The PETSc in ${PETSC_CONFIG_INCLUDE_DIR} is not one of real double \
numbers. Set PETSC_DIR and PETSC_ARCH to one that is.")
    endif()
    if(configuration MATCHES "#define PETSC_HAVE_MPIUNI 1")
        set(needs_mpi FALSE)
    endif()
endif()
set(mpi_variables)
if(needs_mpi AND PETSC_HAS_FITTING_NUMBERS)
    set(MPI_CXX_SKIP_MPICXX TRUE)
    find_package(MPI QUIET COMPONENTS CXX)
    set(mpi_variables MPI_CXX_FOUND)
endif()

find_package_handle_standard_args(PETSc
    REQUIRED_VARS PETSC_LIBRARY PETSC_INCLUDE_DIR PETSC_CONFIG_INCLUDE_DIR
        PETSC_HAS_FITTING_NUMBERS ${mpi_variables}
    VERSION_VAR PETSc_VERSION
    REASON_FAILURE_MESSAGE "${reason}")
mark_as_advanced(PETSC_INCLUDE_DIR PETSC_CONFIG_INCLUDE_DIR PETSC_LIBRARY)

if(PETSc_FOUND AND NOT TARGET PETSc::PETSc)
    add_library(PETSc::PETSc UNKNOWN IMPORTED)
    set_target_properties(PETSc::PETSc PROPERTIES
        IMPORTED_LOCATION "${PETSC_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${PETSC_INCLUDE_DIR};${PETSC_CONFIG_INCLUDE_DIR}")
    if(needs_mpi)
        set_target_properties(PETSc::PETSc PROPERTIES INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
    endif()
endif()
