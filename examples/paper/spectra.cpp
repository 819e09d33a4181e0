// SPDX-License-Identifier: MIT
//
// The eigenvalue problem: certified spectra of Delta_0, Delta_1 and Delta_2 on tessellated spheres,
// compared with l (l + 1). The multiplicity is 2 l + 1 for functions and densities, and twice this
// for 1-forms.
#include "examples/paper/problems.h"
#include "examples/paper/reproductions.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec::paper {

namespace {

constexpr int largest_l = 3;

/// The eigenvalues that belong to one l.
struct Cluster {
    int l;
    Index first, count;
};

/// In the order of the spectrum of k-forms: 1-forms have no zero eigenvalue and two copies.
std::vector<Cluster> clusters(int k) {
    std::vector<Cluster> result;
    Index first = 0;
    for (int l = k % 2; l <= largest_l; ++l) {
        const Index count = (k % 2 + 1) * (2 * l + 1);
        result.push_back({l, first, count});
        first += count;
    }
    return result;
}

std::vector<Family> tessellations() {
    auto families = sphere_families();
    families.push_back({"triangles", [](int level) { return icosphere(4 << level); }});
    return families;
}

void add_degree(Report& report, const Request& request, int k, int levels) {
    Table table{
        fmt::format("delta{}", k),
        fmt::format("eigenvalues of Delta_{} on the unit sphere", k),
        {"tessellation", "faces", "l (l+1)", "multiplicity", "mean", "width", "order", "certified"},
        {}};
    SvgPlot plot{.title = fmt::format("Eigenvalues of Delta_{}, l = {}", k, largest_l),
                 .x = {"mean edge length"},
                 .y = {"error of the mean of the eigenvalues"},
                 .slopes = {{2}}};
    for (const auto& family : tessellations()) {
        std::vector<std::vector<double>> errors(largest_l + 1);
        std::vector<double> lengths;
        for (int level = 0; level < levels; ++level) {
            if (request.progress)
                request.progress(fmt::format("Delta_{}, {}, level {}", k, family.name, level));
            const auto mesh = discretized(family.make(level));
            const auto all = clusters(k);
            const auto modes = spectrum({mesh, polydec::Side::primal, k},
                                        {.count = all.back().first + all.back().count});
            lengths.push_back(mesh.volumes().primal(1).mean());
            for (const auto& [l, first, count] : all) {
                const Vector values = modes.eigenvalues.segment(first, count);
                errors[l].push_back(std::abs(values.mean() - l * (l + 1)));
                table.rows.push_back(
                    {family.name, long{mesh.complex().size(2)}, long{l} * (l + 1), long{count},
                     values.mean(), values.maxCoeff() - values.minCoeff(),
                     level == 0 || l == 0 ? none : order_between(lengths, errors[l], level),
                     std::string(modes.certificate.complete ? "yes" : "no")});
            }
        }
        plot.series.push_back({family.name, lengths, errors[largest_l]});
    }
    report.tables.push_back(std::move(table));
    report.plots.push_back({fmt::format("delta{}", k), std::move(plot)});
}

} // namespace

Report spectra(const Request& request) {
    const int levels = request.levels > 0 ? request.levels : 3;
    Report report{.name = "spectra", .title = "Certified spectra of the sphere"};
    for (int k = 0; k <= 2; ++k)
        add_degree(report, request, k, levels);
    return report;
}

} // namespace polydec::paper
