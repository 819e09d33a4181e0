# SPDX-License-Identifier: MIT
# How targets of polydec are compiled: warnings, modules, and what programs with sanitizers load.
# The warnings of every target.
function(polydec_compile_options target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
    if(POLYDEC_WERROR)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()

# Compiles the files of each module together, which takes half the time: what they read is read and
# instantiated once. Their anonymous namespaces become one, so that names there differ in a module.
function(polydec_compile_by_module target)
    if(NOT POLYDEC_COMPILE_BY_MODULE)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # Types in anonymous namespaces may be members in a file but not in what it reads, and a local
    # name may hide one of another file.
    target_compile_options(${target} PRIVATE -Wno-shadow
        "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage;-Wshadow=local>")
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    foreach(source IN LISTS sources)
        cmake_path(ABSOLUTE_PATH source NORMALIZE)
        file(RELATIVE_PATH module ${PROJECT_SOURCE_DIR} ${source})
        string(REGEX REPLACE "/.*" "" module ${module})
        math(EXPR files_${module} "${files_${module}} + 1")
        math(EXPR part "${files_${module}} / 45") # so that a change occupies both processors
        set_source_files_properties(${source} TARGET_DIRECTORY ${target}
            PROPERTIES UNITY_GROUP ${module}_${part})
    endforeach()
endfunction()

# Programs without the address sanitizer, such as Python and the test programs, must preload it to
# run with a sanitized library; it also needs the C++ library, whose exceptions it intercepts. Programs with it find it by
# their run path, since clang keeps its own where nothing looks.
set(polydec_preloaded)
string(TOUPPER "CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}" flags)
if("${CMAKE_CXX_FLAGS} ${${flags}}" MATCHES "-fsanitize=[^ ]*address")
    set(runtime libasan.so)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
        set(runtime libclang_rt.asan-${CMAKE_SYSTEM_PROCESSOR}.so)
    endif()
    foreach(name IN ITEMS ${runtime} libstdc++.so.6)
        execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=${name}
            OUTPUT_VARIABLE path OUTPUT_STRIP_TRAILING_WHITESPACE)
        list(APPEND polydec_preloaded ${path})
    endforeach()
    list(GET polydec_preloaded 0 path)
    cmake_path(GET path PARENT_PATH CMAKE_BUILD_RPATH)
    list(JOIN polydec_preloaded ":" polydec_preloaded)
endif()
