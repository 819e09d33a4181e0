# SPDX-License-Identifier: MIT
# Writes the template of pages as C++: cmake -DFOLDER=io/pages -DOUT=page_template.cpp
# -DSCRIPTS=a.js+b.js -P EmbedPage.cmake
string(REPLACE "+" ";" scripts "${SCRIPTS}")
set(script "")
foreach(name IN LISTS scripts)
    file(READ "${FOLDER}/${name}" text)
    string(APPEND script "${text}")
endforeach()
file(READ "${FOLDER}/page.html" html)
file(READ "${FOLDER}/album.html" album)
file(READ "${FOLDER}/page.css" css)

# In pieces, since a compiler need not take longer literals than 64 kB.
function(literal text out)
    string(LENGTH "${text}" length)
    set(result "")
    set(at 0)
    while(at LESS length)
        string(SUBSTRING "${text}" ${at} 8000 piece)
        string(APPEND result "\n    R\"polydec(${piece})polydec\"")
        math(EXPR at "${at} + 8000")
    endwhile()
    set(${out} "${result}" PARENT_SCOPE)
endfunction()
literal("${html}" html)
literal("${album}" album)
literal("${css}" css)
literal("${script}" script)
file(WRITE "${OUT}" "// SPDX-License-Identifier: MIT
#include \"io/pages/page_template.h\"

namespace polydec {

std::string_view page_template(std::string_view name) {
    if (name == \"page.html\")
        return ${html};
    if (name == \"album.html\")
        return ${album};
    if (name == \"page.css\")
        return ${css};
    return ${script};
}

} // namespace polydec
")
