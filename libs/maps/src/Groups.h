// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace offmap::maps {

/// Disjoint sets of numbers from 0 on, which grow together.
class Groups {
 public:
    explicit Groups(size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), uint32_t{0});
    }

    /// The smallest number of the set.
    uint32_t of(uint32_t member) {
        while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
        return member;
    }

    void unite(uint32_t one, uint32_t other) {
        const uint32_t a = of(one), b = of(other);
        parent_[std::max(a, b)] = std::min(a, b);
    }

 private:
    std::vector<uint32_t> parent_;
};

}  // namespace offmap::maps
