// SPDX-License-Identifier: MIT
//
// Compiled once for each figure and table, whose name POLYDEC_REPRODUCTION is.
#include "examples/paper/program.h"

int main(int argc, char** argv) {
    return polydec::paper::run_program(POLYDEC_REPRODUCTION, argc, argv);
}
