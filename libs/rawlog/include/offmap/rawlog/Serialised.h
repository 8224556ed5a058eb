// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <cstddef>
#include <vector>

namespace offmap::rawlog {

/// Appends the object as it stands in a rawlog.
void serialise(const mrpt::serialization::CSerializable& object, std::vector<std::byte>& to);

}  // namespace offmap::rawlog
