// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

namespace polydec {

/// The data of a handle: a shared pointer without moves. A class with such a member has no moves
/// either: a move copies, so the old handle keeps its data.
template <class T>
class Shared : public std::shared_ptr<T> {
public:
    using std::shared_ptr<T>::shared_ptr;
    using std::shared_ptr<T>::operator=;
    Shared(std::shared_ptr<T> data) : std::shared_ptr<T>(std::move(data)) {}

    Shared(const Shared&) = default;
    Shared(Shared&&) = delete;
    Shared& operator=(const Shared&) = default;
    Shared& operator=(Shared&&) = delete;
};

} // namespace polydec
