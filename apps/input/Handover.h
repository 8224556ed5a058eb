// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace offmap::app {

/// Memory that this program shares with its guarded child, for the child to tell what it found out.
/// No pipe, which may be full, and no file, whose size may be limited.
class Handover {
 public:
    /// \param capacity [byte] no memory is taken before it is used
    /// \throw std::system_error if there is no memory to be had
    explicit Handover(size_t capacity = size_t{1} << 22);

    /// In the child. \throw std::length_error if it is too much
    void put(std::span<const uint8_t> bytes);
    /// What the child has put; empty if it did not come to it.
    std::span<const uint8_t> content() const;

 private:
    struct Shared;
    struct Unmap {
        size_t size;  ///< [byte]
        void operator()(Shared* shared) const;
    };
    size_t capacity_;  ///< [byte]
    std::unique_ptr<Shared, Unmap> shared_;
};

}  // namespace offmap::app
