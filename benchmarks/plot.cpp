// SPDX-License-Identifier: MIT
//
// Reads a plot from standard input, one thing a line, and writes it to standard output as SVG:
//   title TEXT | x LABEL | y LABEL | linear_y LABEL | series NAME | slope VALUE SERIES | X Y (of
//   the last series)
// The axes are logarithmic but for a linear_y.
#include "base/errors.h"
#include "examples/plots/svg_plot.h"

#include <iostream>
#include <sstream>

namespace {

void take(polydec::SvgPlot& plot, const std::string& line) {
    std::istringstream words(line);
    std::string word, rest;
    words >> word;
    std::getline(words >> std::ws, rest);
    std::istringstream numbers(rest);
    if (word == "title") {
        plot.title = rest;
    } else if (word == "x") {
        plot.x.label = rest;
    } else if (word == "y") {
        plot.y.label = rest;
    } else if (word == "linear_y") {
        plot.y = {.label = rest, .scale = polydec::Scale::linear};
    } else if (word == "series") {
        plot.series.push_back({.name = rest, .x = {}, .y = {}});
    } else if (word == "slope") {
        polydec::SvgSlope slope{};
        numbers >> slope.slope >> slope.series;
        plot.slopes.push_back(slope);
    } else if (!plot.series.empty()) {
        double y = 0;
        if (!(numbers >> y))
            throw polydec::InvalidInput("`" + line + "` is no point");
        plot.series.back().x.push_back(std::stod(word));
        plot.series.back().y.push_back(y);
    } else {
        throw polydec::InvalidInput("`" + line + "` stands before the first series");
    }
}

} // namespace

int main() {
    try {
        polydec::SvgPlot plot;
        for (std::string line; std::getline(std::cin, line);)
            take(plot, line);
        std::cout << polydec::to_svg(plot);
        return std::cout.flush() ? 0 : 4;
    } catch (const std::exception& error) {
        std::cerr << "plot: " << error.what() << '\n';
        return 2;
    }
}
