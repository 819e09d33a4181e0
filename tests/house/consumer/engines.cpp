// SPDX-License-Identifier: MIT
//
// Whether the engines named on the command line are in this program, which registers none.
#include <iostream>

bool has_engine(const char* name);

int main(int count, char** words) {
    for (int i = 1; i < count; ++i)
        if (!has_engine(words[i])) {
            std::cout << "no " << words[i] << '\n';
            return 1;
        }
    return has_engine("nosuch") ? 1 : 0;
}
