// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/GuardedRun.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace offmap::app {

using Bytes = std::vector<uint8_t>;

/// What the work gives, done in a child of this program, which survives what damaged files do to
/// their readers.
/// \param capacity [byte] of what it gives, at most
/// \param messageOfDeath what to tell of a child that died
/// \throw std::runtime_error with the message of what the work throws, or with that of its death;
/// Interrupted
Bytes bytesFromChild(
    size_t capacity, const std::function<Bytes(rawlog::GuardedStatus&)>& work,
    const std::function<std::string(const rawlog::GuardedOutcome&)>& messageOfDeath);

}  // namespace offmap::app
