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
    /// \throw std::system_error if there is no memory to be had
    Handover();

    /// In the child. \throw std::length_error if it is too much
    void put(std::span<const uint8_t> bytes);
    /// What the child has put; empty if it did not come to it.
    std::span<const uint8_t> content() const;

 private:
    struct Shared;
    std::unique_ptr<Shared, void (*)(Shared*)> shared_;
};

}  // namespace offmap::app
