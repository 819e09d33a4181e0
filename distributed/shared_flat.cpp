// SPDX-License-Identifier: MIT
#include "distributed/shared_flat.h"

#include "base/lists.h"
#include "dec/merging/absorb_flat.h"
#include "dec/metric/geometry.h"
#include "distributed/labels.h"
#include "distributed/number_places.h"

#include <algorithm>
#include <iterator>

namespace polydec {

namespace {

/// An n-simplex as it is sent: its number and that of its class, the marks below, and its corners;
/// where these are, the shortest edge at each, and the size of the facet that lacks it.
struct Layout {
    int n;
    Eigen::Index N; // dimension of space

    static constexpr GlobalIndex is_flat = 1;
    static GlobalIndex is_free(int facet) { return GlobalIndex{2} << facet; }

    static constexpr int number = 0, of_class = 1, marks = 2, corners = 3; // places
    std::size_t numbers() const { return static_cast<std::size_t>(corners + n + 1); }
    std::size_t values() const { return static_cast<std::size_t>((N + 2) * (n + 1)); }
};

struct Gathered {
    Parcels<GlobalIndex> numbers;
    Parcels<double> values;
};

/// Joins those of equal class.
void join_equal(const std::vector<GlobalIndex>& classes, DisjointSets& sets) {
    const NumberPlaces place(classes);
    std::vector<Index> member(place.numbers().size(), -1);
    for (Index t = 0; t < std::ssize(classes); ++t) {
        Index& known = member[place(classes[t])];
        known = known < 0 ? t : known;
        sets.join(known, t);
    }
}

class Sending {
public:
    Sending(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
            const FacetDefects& defects, const std::vector<std::uint8_t>& free,
            const std::vector<GlobalIndex>& first)
        : ranks_(ranks),
          local_(local),
          flat_(defects.flat),
          sizes_(defects.scale),
          free_(free),
          first_(first),
          n_(local.dimension()),
          shortest_(shortest_edges(ranks, local, volumes)) {}

    Gathered run() {
        const LocalClasses parts = ranks_.together("flat cells", [&] { return parts_of(); });
        labels_ = spread_labels(ranks_, local_, n_, parts).of;
        const auto are_concerned = ask_for_flat();
        Gathered own = ranks_.together("flat cells", [&] { return simplices(are_concerned); });
        return {ranks_.deliver(std::move(own.numbers)), ranks_.deliver(std::move(own.values))};
    }

private:
    const LocalComplex::Degree& tops() const { return local_.degree(n_); }
    bool is_flat(Index t) const { return !flat_.empty() && flat_[t]; }

    LocalClasses parts_of() const;
    std::vector<bool> ask_for_flat() const;
    Gathered simplices(const std::vector<bool>& are_concerned) const;

    const Ranks& ranks_;
    const LocalComplex& local_;
    const std::vector<bool>& flat_;
    const Vector& sizes_;
    const std::vector<std::uint8_t>& free_;
    const std::vector<GlobalIndex>& first_;
    int n_;
    Vector shortest_;
    std::vector<Label> labels_;
};

/// Classes, flat simplices and what lies beside these hang together.
LocalClasses Sending::parts_of() const {
    DisjointSets sets(tops().size());
    join_equal(first_, sets);
    const Cofaces cofaces(local_.complex, n_);
    for (Index f = 0; f < local_.degree(n_ - 1).size(); ++f)
        if (const auto sides = cofaces.of(f); free_[f] != 0 && sides.size() == 2 &&
                                              (is_flat(sides[0].cell) || is_flat(sides[1].cell)))
            sets.join(sides[0].cell, sides[1].cell);
    return LocalClasses(sets.firsts());
}

/// Whether there is a flat one among those that hang together with each own simplex.
std::vector<bool> Sending::ask_for_flat() const {
    auto told = ranks_.empty_parcels<GlobalIndex>();
    std::vector<GlobalIndex> own;
    for (Index t = 0; t < tops().size(); ++t) {
        if (tops().owner[t] != ranks_.rank())
            continue;
        own.push_back(labels_[t].number);
        if (is_flat(t))
            told[labels_[t].owner].push_back(labels_[t].number);
    }
    auto with_flat = unpacked(ranks_.deliver(std::move(told)));
    std::sort(with_flat.begin(), with_flat.end());

    const NumberPlaces place(own);
    std::vector<int> whom(place.numbers().size());
    for (Index t = 0; t < tops().size(); ++t)
        if (tops().owner[t] == ranks_.rank())
            whom[place(labels_[t].number)] = labels_[t].owner;
    const auto answers =
        ranks_.ask<std::uint8_t>("flat cells", whom, place.numbers(), [&](GlobalIndex label) {
            return std::uint8_t{std::binary_search(with_flat.begin(), with_flat.end(), label)};
        });
    std::vector<bool> are_concerned(labels_.size(), false);
    for (Index t = 0; t < tops().size(); ++t)
        if (tops().owner[t] == ranks_.rank())
            are_concerned[t] = answers[place(labels_[t].number)] != 0;
    return are_concerned;
}

Gathered Sending::simplices(const std::vector<bool>& are_concerned) const {
    Gathered sent{ranks_.empty_parcels<GlobalIndex>(), ranks_.empty_parcels<double>()};
    for (Index t = 0; t < tops().size(); ++t) {
        if (!are_concerned[t])
            continue;
        auto& numbers = sent.numbers[labels_[t].owner];
        auto& values = sent.values[labels_[t].owner];
        GlobalIndex marks = is_flat(t) ? Layout::is_flat : 0;
        for (int i = 0; i <= n_; ++i)
            if (free_[local_.complex.face(n_, t, i)] != 0)
                marks |= Layout::is_free(i);
        numbers.insert(numbers.end(), {tops().number[t], first_[t], marks});
        for (int i = 0; i <= n_; ++i) {
            const Index v = local_.complex.simplices(n_)(t, i);
            numbers.push_back(local_.vertices[v]);
            const auto point = local_.points.row(v);
            values.insert(values.end(), point.begin(), point.end());
            values.insert(values.end(), {shortest_[v], sizes_[local_.complex.face(n_, t, i)]});
        }
    }
    return sent;
}

/// What came to this rank, as a complex of its own, in the order of the whole.
class Deciding {
public:
    Deciding(const Ranks& ranks, const Gathered& arrived, Layout layout)
        : ranks_(ranks),
          layout_(layout),
          corners_(corners_of(arrived)),
          complex_(tops_of(arrived), numbers_below(corners_.numbers().size())), // of nothing, too
          points_(complex_.size(0), layout.N) {
        find_rows(arrived);
        find_surroundings();
    }

    Parcels<SimplexClass> classes(double tolerance) const;

private:
    struct Row {
        int rank; // that it came from
        const GlobalIndex* numbers;
        const double* values;
    };

    NumberPlaces corners_of(const Gathered& arrived) const;
    Simplices tops_of(const Gathered& arrived) const;
    void find_rows(const Gathered& arrived);
    void find_surroundings();

    const Ranks& ranks_;
    Layout layout_;
    NumberPlaces corners_;
    SimplicialComplex complex_;
    Points points_;
    std::vector<Row> rows_; // of n-simplices
    std::vector<bool> flat_;
    AroundFlat around_;
};

NumberPlaces Deciding::corners_of(const Gathered& arrived) const {
    std::vector<GlobalIndex> corners;
    for (const auto& parcel : arrived.numbers)
        for (auto row = parcel.begin(); row != parcel.end(); row += layout_.numbers())
            corners.insert(corners.end(), row + Layout::corners, row + layout_.numbers());
    return NumberPlaces(corners);
}

Simplices Deciding::tops_of(const Gathered& arrived) const {
    std::vector<Index> places;
    for (const auto& parcel : arrived.numbers)
        for (auto row = parcel.begin(); row != parcel.end(); row += layout_.numbers())
            std::transform(row + Layout::corners, row + layout_.numbers(),
                           std::back_inserter(places), corners_);
    const auto width = layout_.n + 1;
    return Eigen::Map<const Simplices>(places.data(), std::ssize(places) / width, width);
}

void Deciding::find_rows(const Gathered& arrived) {
    std::vector<Row> in_order_of_arrival;
    for (std::size_t r = 0; r < arrived.numbers.size(); ++r)
        for (std::size_t i = 0; i < arrived.numbers[r].size() / layout_.numbers(); ++i)
            in_order_of_arrival.push_back({static_cast<int>(r),
                                           arrived.numbers[r].data() + i * layout_.numbers(),
                                           arrived.values[r].data() + i * layout_.values()});
    for (Index t = 0; t < complex_.size(layout_.n); ++t) {
        rows_.push_back(in_order_of_arrival[complex_.input_row(t)]);
        flat_.push_back((rows_.back().numbers[Layout::marks] & Layout::is_flat) != 0);
    }
}

void Deciding::find_surroundings() {
    const int n = layout_.n;
    const Index facets = complex_.size(n - 1);
    around_ = {BothSides(static_cast<std::size_t>(facets), {-1, -1}), Vector::Zero(facets),
               Vector::Zero(complex_.size(0))};
    const Cofaces cofaces(complex_, n);
    for (Index t = 0; t < complex_.size(n); ++t)
        for (int i = 0; i <= n; ++i) {
            const double* values = rows_[t].values + i * (layout_.N + 2);
            const Index v = complex_.simplices(n)(t, i), f = complex_.face(n, t, i);
            points_.row(v) = Eigen::Map<const Eigen::RowVectorXd>(values, layout_.N);
            around_.shortest[v] = values[layout_.N];
            around_.sizes[f] = values[layout_.N + 1];
            if (const auto sides = cofaces.of(f);
                sides.size() == 2 && (rows_[t].numbers[Layout::marks] & Layout::is_free(i)) != 0)
                around_.sides[f] = {sides[0].cell, sides[1].cell};
        }
}

Parcels<SimplexClass> Deciding::classes(double tolerance) const {
    auto parcels = ranks_.empty_parcels<SimplexClass>();
    if (rows_.empty())
        return parcels;
    std::vector<GlobalIndex> before;
    for (const Row& row : rows_)
        before.push_back(row.numbers[Layout::of_class]);
    DisjointSets classes(static_cast<Index>(rows_.size()));
    join_equal(before, classes);
    absorb_flat({complex_, points_, {}, FlatSimplices::passed_over}, flat_, around_, tolerance,
                classes);
    const auto firsts = classes.firsts();
    for (std::size_t t = 0; t < rows_.size(); ++t)
        parcels[rows_[t].rank].push_back(
            {rows_[t].numbers[Layout::number], rows_[firsts[t]].numbers[Layout::number]});
    return parcels;
}

} // namespace

void absorb_flat(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
                 const FacetDefects& defects, const std::vector<std::uint8_t>& free,
                 double tolerance, std::vector<GlobalIndex>& first) {
    const Layout layout{local.dimension(), local.points.cols()};
    const Gathered arrived = Sending(ranks, local, volumes, defects, free, first).run();
    auto found = ranks.deliver(ranks.together(
        "flat cells", [&] { return Deciding(ranks, arrived, layout).classes(tolerance); }));
    take_classes(ranks, local, found, first);
}

} // namespace polydec
