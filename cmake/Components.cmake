# SPDX-License-Identifier: MIT
# Engines of their own targets, so that who links the core alone neither needs nor links what is
# behind them. The table below is all that CMake knows of them: options, targets, what is installed
# and who links it follow from it, and what `polydec backends` says of how to get them.
#   polydec_component(name what-is-behind-it package its-target debian-package
#       NEEDS other-component HEADER header SOURCES files-in-backends/ LIBRARIES ..)
# makes the module lib/polydec/NAME.so, which the library loads when one of its engines is asked
# for, and, for programs that link it instead, polydec::name, where there is a HEADER. POLYDEC_NAME
# says whether; the package is looked for by cmake/Find<package>.cmake.
# It adds to polydec_components, where it is built also to polydec_built_components, with a target
# to link to polydec_linked_components, and sets <name>_header, <name>_package and <name>_debian.
set(polydec_linked_components)
file(RELATIVE_PATH polydec_lib_from_bin ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set(polydec_needs_run_path ON) # to find a shared polydec and engines; in /usr the loader looks anyway
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    set(polydec_needs_run_path OFF)
endif()
set(polydec_module_folder ${CMAKE_INSTALL_LIBDIR}/polydec) # below the build tree or the prefix
set(polydec_components)
set(polydec_built_components)

function(polydec_component name behind package target debian)
    cmake_parse_arguments(PARSE_ARGV 5 arg "" "NEEDS;HEADER" "SOURCES;LIBRARIES")
    string(TOUPPER POLYDEC_${name} option)
    set(needs)
    if(arg_NEEDS)
        set(needs "; needs ${arg_NEEDS}")
    endif()
    set(${option} AUTO CACHE STRING
        "Build the component ${name}: ON, OFF or AUTO (where ${behind} is found${needs})")
    set_property(CACHE ${option} PROPERTY STRINGS AUTO ON OFF)
    set(polydec_components ${polydec_components} ${name} PARENT_SCOPE)
    set(${name}_header "${arg_HEADER}" PARENT_SCOPE)
    set(${name}_package ${package} PARENT_SCOPE)
    set(${name}_debian ${debian} PARENT_SCOPE)
    if(${option} STREQUAL "OFF")
        return()
    endif()

    if(arg_NEEDS AND NOT arg_NEEDS IN_LIST polydec_built_components)
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

    # Compiled once for both.
    list(TRANSFORM arg_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/backends/)
    add_library(polydec_${name}_engines OBJECT ${arg_SOURCES}
        ${PROJECT_SOURCE_DIR}/backends/component.h)
    set_target_properties(polydec_${name}_engines PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(polydec_${name}_engines PRIVATE polydec ${target} fmt::fmt)
    polydec_compile_options(polydec_${name}_engines)

    set(libraries ${target} fmt::fmt ${arg_LIBRARIES})
    polydec_engine_module(${name} "${arg_NEEDS}" ${libraries})
    if(arg_HEADER AND POLYDEC_LINKED_COMPONENTS)
        set(polydec_linked_components ${polydec_linked_components} ${name} PARENT_SCOPE)
        polydec_linked_component(${name} "${arg_NEEDS}" ${arg_HEADER} ${libraries})
    endif()
endfunction()

# A module brings its own copy of what it uses of a static polydec, and shows none of it. It is no
# MODULE for CMake, since one that needs another links it.
function(polydec_engine_module name needs)
    set(module polydec_${name}_module)
    add_library(${module} SHARED ${PROJECT_SOURCE_DIR}/backends/component_module.cpp
        $<TARGET_OBJECTS:polydec_${name}_engines>)
    target_compile_definitions(${module} PRIVATE POLYDEC_ADD_ENGINES=add_${name})
    set(run_path)
    if(needs)
        set(run_path "$ORIGIN")
    endif()
    if(polydec_needs_run_path)
        list(APPEND run_path "$ORIGIN/..")
    endif()
    set_target_properties(${module} PROPERTIES
        OUTPUT_NAME ${name} PREFIX "" SUFFIX .so
        LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${polydec_module_folder}
        INSTALL_RPATH "${run_path}" INSTALL_RPATH_USE_LINK_PATH ${polydec_needs_run_path})
    target_link_libraries(${module} PRIVATE polydec ${ARGN})
    if(needs)
        target_link_libraries(${module} PRIVATE polydec_${needs}_module)
    endif()
    if(NOT APPLE)
        target_link_options(${module} PRIVATE LINKER:--exclude-libs,ALL)
    endif()
    polydec_compile_options(${module})
    add_dependencies(polydec_modules ${module})
endfunction()

# Linking such a target is enough to have its engines: who links it asks the linker for the symbol
# whose initialization registers them, so that its file is not left out of a static library, or,
# where the component is shared, for the whole of it, which --as-needed would leave out.
function(polydec_linked_component name needs header)
    set(registering ${PROJECT_SOURCE_DIR}/backends/component_linked.cpp)
    add_library(polydec_${name} ${registering} $<TARGET_OBJECTS:polydec_${name}_engines>)
    add_library(polydec::${name} ALIAS polydec_${name})
    target_compile_definitions(polydec_${name} PRIVATE
        POLYDEC_ADD_ENGINES=add_${name}
        POLYDEC_REGISTER_ENGINES=register_${name}
        POLYDEC_IS_LINKED=polydec_${name}_is_linked)
    target_sources(polydec_${name} PUBLIC
        FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
        FILES ${PROJECT_SOURCE_DIR}/backends/${header})
    set_target_properties(polydec_${name} PROPERTIES
        VERSION ${PROJECT_VERSION} SOVERSION 0)
    target_link_libraries(polydec_${name} PUBLIC polydec PRIVATE ${ARGN})
    if(needs)
        target_link_libraries(polydec_${name} PRIVATE polydec_${needs})
    endif()
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

add_custom_target(polydec_modules ALL)
polydec_component(cholmod SuiteSparse CHOLMOD SuiteSparse::CHOLMOD libsuitesparse-dev
    HEADER linear/cholmod.h
    SOURCES linear/cholmod.cpp linear/one_thread.h
    LIBRARIES ${CMAKE_DL_LIBS})
polydec_component(cvode SUNDIALS SUNDIALS SUNDIALS::cvode libsundials-dev
    SOURCES integrators/cvode.cpp
    LIBRARIES SUNDIALS::sunnonlinsolfixedpoint)
polydec_component(mumps "the sequential MUMPS" MUMPS MUMPS::MUMPS libmumps-seq-dev
    SOURCES linear/mumps.cpp linear/one_thread.h # never linked with a program: it may have an MPI
    LIBRARIES ${CMAKE_DL_LIBS})
polydec_component(petsc PETSc PETSc PETSc::PETSc petsc-dev
    HEADER linear/petsc.h
    SOURCES linear/petsc.cpp linear/petsc_options.cpp linear/petsc_options.h
        linear/petsc_session.cpp linear/petsc_session.h)
polydec_component(slepc SLEPc SLEPc SLEPc::SLEPc slepc-dev
    NEEDS petsc # SLEPc starts and ends together with its PETSc
    HEADER eigen/slepc.h
    SOURCES eigen/slepc.cpp eigen/slepc_run.h)
