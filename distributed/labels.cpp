// SPDX-License-Identifier: MIT
#include "distributed/labels.h"

namespace polydec {

namespace {

/// A label on its way; without a rank where the simplex takes no part.
constexpr std::int32_t nobody = -1;

class Spreading {
public:
    Spreading(const Ranks& ranks, const LocalComplex& local, int k, const LocalClasses& classes)
        : ranks_(ranks), degree_(local.degree(k)), classes_(classes) {
        for (Index s = 0; s < degree_.size(); ++s) // the first one has the least number here
            of_class_.push_back({degree_.number[s], degree_.owner[s], 1});
    }

    /// Whether any label became less.
    bool go_round() {
        bool changed = false;
        std::vector<Label> labels = all();
        collect(ranks_, degree_.copies, labels,
                [&](Index s, const Label& label) { changed |= take(s, label); });
        labels = all();
        refresh(ranks_, degree_.copies, labels);
        for (const auto& from : degree_.copies.in)
            for (const Index s : from)
                changed |= take(s, labels[s]);
        return ranks_.any(changed);
    }

    Labels finish() {
        Labels result{all(), std::vector<bool>(of_class_.size(), false)};
        std::vector<Label> of_owner = result.of;
        refresh(ranks_, degree_.copies, of_owner);
        for (std::size_t s = 0; s < of_class_.size(); ++s)
            result.clashes[s] = result.of[s].owner != nobody && of_owner[s].owner != nobody &&
                                of_owner[s].sign != result.of[s].sign;
        return result;
    }

private:
    std::vector<Label> all() const {
        std::vector<Label> labels;
        for (Index s = 0; s < degree_.size(); ++s) {
            Label label = of_class_[classes_.first[s]];
            label.sign *= classes_.sign[s];
            if (!classes_.takes_part[s])
                label.owner = nobody;
            labels.push_back(label);
        }
        return labels;
    }

    /// Signs do not count: where they contradict each other they would never settle.
    bool take(Index s, const Label& label) {
        Label& known = of_class_[classes_.first[s]];
        if (label.owner == nobody || !classes_.takes_part[s] || label.number >= known.number)
            return false;
        known = {label.number, label.owner, label.sign * classes_.sign[s]};
        return true;
    }

    const Ranks& ranks_;
    const LocalComplex::Degree& degree_;
    const LocalClasses& classes_;
    std::vector<Label> of_class_; // at its first simplex
};

} // namespace

Labels spread_labels(const Ranks& ranks, const LocalComplex& local, int k,
                     const LocalClasses& classes) {
    Spreading spreading(ranks, local, k, classes);
    while (spreading.go_round()) {
    }
    return spreading.finish();
}

} // namespace polydec
