// SPDX-License-Identifier: MIT
#include "base/lists.h"
#include "dec/merging/mean_spheres.h"
#include "distributed/facet_classes.h"

#include <algorithm>
#include <map>

namespace polydec {

namespace {

constexpr Eigen::Index term_count = 4;

/// A mean as it is sent: origin, center, terms, side and count.
Eigen::Index width_of_mean(int n) {
    return 2 * n + term_count + 2;
}

/// Members of classes, as they are sent: their numbers, and volume, first corner, circumcenter from
/// there, terms and side of each; no volume where they are flat.
struct Members {
    Parcels<std::array<GlobalIndex, 2>> numbers; // class, simplex
    Parcels<double> values;
};

Members members_of(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
                   const FacetClasses& classes, const std::vector<bool>& flat,
                   const MeanSpheres& spheres) {
    const int n = local.dimension();
    const auto& tops = local.degree(n);
    const EqualStretches stretches(tops.count, ranks.size());
    Members members{ranks.empty_parcels<std::array<GlobalIndex, 2>>(),
                    ranks.empty_parcels<double>()};
    for (Index t = 0; t < tops.size(); ++t) {
        if (tops.owner[t] != ranks.rank())
            continue;
        const int r = stretches.rank_of(classes.first[t]);
        members.numbers[r].push_back({classes.first[t], tops.number[t]});
        auto& values = members.values[r];
        values.push_back(flat.empty() || !flat[t] ? volumes.primal(n)[t] : 0);
        for (const double x : local.points.row(local.complex.simplices(n)(t, 0)))
            values.push_back(x);
        for (const double x : spheres.own_center(t))
            values.push_back(x);
        for (const double x : spheres.own_terms(t))
            values.push_back(x);
        values.push_back(spheres.own_side(t));
    }
    return members;
}

/// The means of classes, added in the order of simplices.
std::map<GlobalIndex, Vector> means_of(const Members& arrived, int n) {
    const Eigen::Index width = 1 + 2 * n + term_count + 1;
    struct Member {
        std::array<GlobalIndex, 2> numbers;
        const double* values;
    };
    std::vector<Member> members;
    for (std::size_t r = 0; r < arrived.numbers.size(); ++r)
        for (std::size_t i = 0; i < arrived.numbers[r].size(); ++i)
            members.push_back({arrived.numbers[r][i],
                               arrived.values[r].data() + static_cast<Eigen::Index>(i) * width});
    std::sort(members.begin(), members.end(),
              [](const Member& a, const Member& b) { return a.numbers < b.numbers; });
    std::map<GlobalIndex, Vector> means;
    for (std::size_t begin = 0, end = 0; begin < members.size(); begin = end) {
        const GlobalIndex of = members[begin].numbers[0];
        Vector mean = Vector::Zero(width_of_mean(n));
        const Eigen::Map<const Vector> origin(members[begin].values + 1, n);
        double weight = 0, side = 0;
        for (; end < members.size() && members[end].numbers[0] == of; ++end) {
            const Eigen::Map<const Vector> values(members[end].values, width);
            const double volume = values[0];
            if (volume == 0)
                continue;
            weight += volume;
            mean.segment(n, n) +=
                volume * (values.segment(1, n) - origin + values.segment(1 + n, n));
            mean.segment(2 * n, term_count) += volume * values.segment(1 + 2 * n, term_count);
            side += values[width - 1];
        }
        if (weight > 0)
            mean /= weight;
        mean.head(n) = origin;
        mean[mean.size() - 2] = side;
        mean[mean.size() - 1] = static_cast<double>(end - begin);
        means.emplace(of, std::move(mean));
    }
    return means;
}

/// The means of the classes of all simplices here.
MeanSpheres::Means fetch_means(const Ranks& ranks, const LocalComplex& local,
                               const FacetClasses& classes, const Members& arrived) {
    const int n = local.dimension();
    const auto& tops = local.degree(n);
    const auto means = ranks.together("centers", [&] { return means_of(arrived, n); });
    const auto found =
        ranks.ask_rows<double>("centers", width_of_mean(n),
                               EqualStretches(tops.count, ranks.size()).ranks_of(classes.first),
                               classes.first, [&](GlobalIndex of, double* row) {
                                   std::copy(means.at(of).begin(), means.at(of).end(), row);
                               });
    const Index size = tops.size();
    MeanSpheres::Means result{Points(size, n), Points(size, n), Points(size, term_count),
                              std::vector<Index>(static_cast<std::size_t>(size)), Vector(size)};
    for (Index t = 0; t < size; ++t) {
        const double* const mean = found.data() + t * width_of_mean(n);
        std::copy_n(mean, n, result.origins.row(t).begin());
        std::copy_n(mean + n, n, result.centers.row(t).begin());
        std::copy_n(mean + 2 * n, term_count, result.terms.row(t).begin());
        result.sides[t] = mean[2 * n + term_count];
        result.counts[t] = static_cast<Index>(mean[2 * n + term_count + 1]);
    }
    return result;
}

} // namespace

Centers shared_centers(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
                       const FacetClasses& classes, const std::vector<bool>& flat) {
    MeanSpheres spheres = ranks.together("centers", [&] {
        return MeanSpheres({local.complex, local.points, volumes}, flat);
    });
    const Members members = ranks.together(
        "centers", [&] { return members_of(ranks, local, volumes, classes, flat, spheres); });
    const Members arrived{ranks.deliver(std::move(members.numbers)),
                          ranks.deliver(std::move(members.values))};
    auto means = fetch_means(ranks, local, classes, arrived);
    return ranks.together("centers", [&] {
        std::vector<Index> own =
            numbers_below(classes.first.size()); // each has the means of its class
        spheres.gather(own, std::move(means));
        return spheres.shared_centers();
    });
}

} // namespace polydec
