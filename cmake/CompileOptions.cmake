# SPDX-License-Identifier: MIT
# The warnings every target of polydec is compiled with.
function(polydec_compile_options target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
    if(POLYDEC_WERROR)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()

# Compiles the files of each folder together, which takes half the time: what they read is read
# once. Their anonymous namespaces become one, so that names there differ within a folder.
function(polydec_compile_by_folder target)
    if(NOT POLYDEC_COMPILE_BY_FOLDER)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # Types in anonymous namespaces may be members in a file but not in what it reads, and a local
    # name may hide one of another file.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage -Wno-shadow -Wshadow=local)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    foreach(source IN LISTS sources)
        cmake_path(ABSOLUTE_PATH source NORMALIZE)
        cmake_path(GET source PARENT_PATH folder)
        file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
        string(MAKE_C_IDENTIFIER ${folder} group)
        set_source_files_properties(${source} TARGET_DIRECTORY ${target}
            PROPERTIES UNITY_GROUP ${group})
    endforeach()
endfunction()
