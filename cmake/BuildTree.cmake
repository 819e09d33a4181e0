# SPDX-License-Identifier: MIT
# Writes two files to the build folder that the project tests/ includes: polydecBuildTargets.cmake
# with the targets of this build, and polydecBuild.cmake with its settings.
set(polydec_build_targets polydec)
foreach(name IN LISTS polydec_linked_components)
    list(APPEND polydec_build_targets polydec_${name})
endforeach()
foreach(name IN ITEMS json plots paper tools command mpi_command)
    if(TARGET polydec_${name})
        list(APPEND polydec_build_targets polydec_${name})
    endif()
endforeach()
set_target_properties(${polydec_build_targets} PROPERTIES EXPORT_NO_SYSTEM ON)
export(TARGETS ${polydec_build_targets} NAMESPACE polydec::
    FILE ${PROJECT_BINARY_DIR}/polydecBuildTargets.cmake)

# The public headers, one a line.
set(headers "$<TARGET_PROPERTY:polydec,HEADER_SET>")
set(component_headers)
foreach(name IN LISTS polydec_linked_components)
    list(APPEND component_headers "$<TARGET_PROPERTY:polydec_${name},HEADER_SET>")
endforeach()
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/public_headers.txt
    CONTENT "$<JOIN:${headers};${component_headers},\n>\n")
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/component_headers.txt
    CONTENT "$<JOIN:${component_headers},\n>\n")

# What the shared library is linked of, one a line: the tests link it again with sanitized objects.
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/library_objects.txt
    CONTENT "$<JOIN:$<TARGET_OBJECTS:polydec>;$<TARGET_OBJECTS:polydec_page_template>,\n>\n")

set(polydec_packages)
foreach(name IN LISTS polydec_built_components)
    list(APPEND polydec_packages ${${name}_package})
endforeach()
set(polydec_openmp ${OpenMP_CXX_LIBRARIES})
set(polydec_version ${PROJECT_VERSION})
set(polydec_compiler ${CMAKE_CXX_COMPILER})
set(polydec_build)
foreach(name IN ITEMS version compiler packages preloaded module_folder built_components
        linked_components openmp python mpirun)
    string(APPEND polydec_build "set(polydec_${name} \"${polydec_${name}}\")\n")
endforeach()
file(WRITE ${PROJECT_BINARY_DIR}/polydecBuild.cmake "${polydec_build}")
