// SPDX-License-Identifier: MIT
#pragma once

#include "examples/paper/report.h"

namespace polydec::paper {

/// A figure or table of the paper, or a further experiment.
struct Reproduction {
    std::string name;
    std::string summary; ///< one line
    Report (*run)(const Request&);
};

/// All reproductions, in the order of the paper.
const std::vector<Reproduction>& reproductions();

Report table1(const Request& request);
Report table2(const Request& request);
Report fig2(const Request& request);
Report fig6(const Request& request);
Report fig7(const Request& request);
Report fig8(const Request& request);
Report fig9(const Request& request);
Report fig10(const Request& request);
Report spectra(const Request& request);

} // namespace polydec::paper
