# SPDX-License-Identifier: MIT
# Engines of their own targets, so that who links the core alone neither needs nor links what is
# behind them. The table below is all that CMake knows of them: options, targets, what is installed
# and who links it follow from it, and what `polydec backends` says of how to get them.
#   polydec_component(name what-is-behind-it package its-target debian-package
#       NEEDS other-components SOURCES header other-files-in-backends/ LIBRARIES ..)
# makes polydec::name as POLYDEC_NAME says; the package is looked for by cmake/Find<package>.cmake.
# It adds to polydec_components, where it is built also to polydec_built_components, and sets
# <name>_package and <name>_debian.
#
# Linking such a target is enough to have its engines: who links it asks the linker for the symbol
# whose initialization registers them, so that its file is not left out of a static library, or,
# where the component is shared, for the whole of it, which --as-needed would leave out.
set(polydec_components)
set(polydec_built_components)

function(polydec_component name behind package target debian)
    cmake_parse_arguments(PARSE_ARGV 5 arg "" "NEEDS" "SOURCES;LIBRARIES")
    string(TOUPPER POLYDEC_${name} option)
    set(needs)
    if(arg_NEEDS)
        set(needs "; needs ${arg_NEEDS}")
    endif()
    set(${option} AUTO CACHE STRING
        "Build the component ${name}: ON, OFF or AUTO (where ${behind} is found${needs})")
    set_property(CACHE ${option} PROPERTY STRINGS AUTO ON OFF)
    set(polydec_components ${polydec_components} ${name} PARENT_SCOPE)
    set(${name}_package ${package} PARENT_SCOPE)
    set(${name}_debian ${debian} PARENT_SCOPE)
    if(${option} STREQUAL "OFF")
        return()
    endif()

    if(arg_NEEDS AND NOT TARGET polydec_${arg_NEEDS})
        if(${option} STREQUAL "ON")
            string(TOUPPER POLYDEC_${arg_NEEDS} needed_option)
            message(FATAL_ERROR "${option}=ON needs the component ${arg_NEEDS}, which is not built "
                "here: install ${${arg_NEEDS}_debian} and set ${needed_option}=ON")
        endif()
        return()
    endif()
    if(${option} STREQUAL "AUTO")
        find_package(${package} QUIET)
    else()
        find_package(${package} REQUIRED)
    endif()
    if(NOT TARGET ${target})
        return()
    endif()
    set(polydec_built_components ${polydec_built_components} ${name} PARENT_SCOPE)

    list(TRANSFORM arg_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/backends/)
    list(POP_FRONT arg_SOURCES header)
    add_library(polydec_${name} ${arg_SOURCES} ${PROJECT_SOURCE_DIR}/backends/linked.h)
    add_library(polydec::${name} ALIAS polydec_${name})
    target_sources(polydec_${name} PUBLIC
        FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${header})
    set_target_properties(polydec_${name} PROPERTIES
        VERSION ${PROJECT_VERSION} SOVERSION 0 POSITION_INDEPENDENT_CODE ON
        VERIFY_INTERFACE_HEADER_SETS ON)
    target_link_libraries(polydec_${name}
        PUBLIC polydec
        PRIVATE ${target} fmt::fmt ${arg_LIBRARIES})
    get_target_property(type polydec_${name} TYPE)
    if(NOT type STREQUAL "SHARED_LIBRARY")
        target_link_options(polydec_${name} INTERFACE
            "LINKER:-u,$<$<PLATFORM_ID:Darwin>:_>polydec_${name}_is_linked")
    elseif(NOT APPLE)
        target_link_options(polydec_${name} INTERFACE
            "LINKER:--push-state,--no-as-needed,$<TARGET_FILE:polydec::${name}>,--pop-state")
    endif()
    polydec_compile_options(polydec_${name})
endfunction()

polydec_component(cholmod SuiteSparse CHOLMOD SuiteSparse::CHOLMOD libsuitesparse-dev
    SOURCES linear/cholmod.h linear/cholmod.cpp
    LIBRARIES ${CMAKE_DL_LIBS})
polydec_component(petsc PETSc PETSc PETSc::PETSc petsc-dev
    SOURCES linear/petsc.h linear/petsc.cpp linear/petsc_session.cpp linear/petsc_session.h)
polydec_component(slepc SLEPc SLEPc SLEPc::SLEPc slepc-dev
    NEEDS petsc # SLEPc starts and ends together with its PETSc
    SOURCES eigen/slepc.h eigen/slepc.cpp
    LIBRARIES polydec_petsc)
