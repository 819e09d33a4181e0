# SPDX-License-Identifier: MIT
# An overlay port beside its sources. A release replaces SOURCE_PATH by vcpkg_from_github or by
# vcpkg_download_distfile with the sha512 of the tarball.
cmake_path(SET SOURCE_PATH NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../..")

vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES
    tools POLYDEC_COMMAND
    cholmod POLYDEC_CHOLMOD
    cvode POLYDEC_CVODE)

vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        ${features}
        -DPOLYDEC_EXAMPLES=OFF
        -DPOLYDEC_BENCHMARKS=OFF
        -DPOLYDEC_PYTHON=OFF
        -DPOLYDEC_DISTRIBUTED=OFF
        -DPOLYDEC_MUMPS=OFF
        -DPOLYDEC_PETSC=OFF
        -DPOLYDEC_SLEPC=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/polydec)
vcpkg_fixup_pkgconfig()
if("tools" IN_LIST FEATURES)
    vcpkg_copy_tools(TOOL_NAMES polydec AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
