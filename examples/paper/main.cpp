// SPDX-License-Identifier: MIT
//
// Compiled once for each figure and table; POLYDEC_REPRODUCTION is its name.
#include "examples/paper/program.h"

int main(int argc, char** argv) {
    return polydec::paper::run_program(POLYDEC_REPRODUCTION, argc, argv);
}
