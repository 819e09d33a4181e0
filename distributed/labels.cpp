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
        of_class_.reserve(degree_.number.size());
        for (Index s = 0; s < degree_.size(); ++s) // the first one has the least number here
            of_class_.push_back({degree_.number[s], degree_.owner[s], 1});
    }

    /// Whether any label became less.
    bool go_round() {
        bool changed = false;
        const auto label = [this](Index s) { return label_of(s); };
        const auto take = [&](Index s, const Label& other) { changed |= this->take(s, other); };
        collect(ranks_, degree_.copies, label, take);
        tell_copies(ranks_, degree_.copies, label, take);
        return ranks_.any(changed);
    }

    Labels finish() const {
        Labels result{{}, std::vector<bool>(of_class_.size(), false)};
        result.of.reserve(of_class_.size());
        for (Index s = 0; s < degree_.size(); ++s)
            result.of.push_back(label_of(s));
        tell_copies(
            ranks_, degree_.copies, [&](Index s) { return result.of[s]; },
            [&](Index s, const Label& of_owner) {
                const Label& own = result.of[s];
                result.clashes[s] =
                    own.owner != nobody && of_owner.owner != nobody && of_owner.sign != own.sign;
            });
        return result;
    }

private:
    Label label_of(Index s) const {
        Label label = of_class_[classes_.first[s]];
        label.sign *= classes_.sign[s];
        if (!classes_.takes_part[s])
            label.owner = nobody;
        return label;
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
