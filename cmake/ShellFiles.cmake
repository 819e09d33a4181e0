# SPDX-License-Identifier: MIT
# Manual pages and completions for bash, zsh and fish, which a script makes of what the command says
# of itself. They need Python at build time, and a command that runs here.
find_program(POLYDEC_SCRIPT_PYTHON python3 DOC "The Python that runs scripts at build time")
if(NOT POLYDEC_SCRIPT_PYTHON OR CMAKE_CROSSCOMPILING)
    message(STATUS "Manual pages and completions are left out: they need python3 and a build for this machine")
    return()
endif()
set(share ${PROJECT_BINARY_DIR}/share)
set(completions ${share}/bash-completion/completions/polydec)
add_custom_command(OUTPUT ${completions}
    COMMAND ${POLYDEC_SCRIPT_PYTHON} ${PROJECT_SOURCE_DIR}/cmake/shell_files.py
        $<TARGET_FILE:polydec_command> ${PROJECT_VERSION} ${share}
    DEPENDS polydec_command ${PROJECT_SOURCE_DIR}/cmake/shell_files.py
    VERBATIM)
add_custom_target(polydec_shell_files ALL DEPENDS ${completions})
install(DIRECTORY ${share}/man DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT polydec OPTIONAL)
install(DIRECTORY ${share}/bash-completion ${share}/zsh ${share}/fish
    DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT polydec OPTIONAL)
