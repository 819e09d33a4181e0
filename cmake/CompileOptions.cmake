# SPDX-License-Identifier: MIT
# The warnings every target of polydec is compiled with.
function(polydec_compile_options target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
    if(POLYDEC_WERROR)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()
