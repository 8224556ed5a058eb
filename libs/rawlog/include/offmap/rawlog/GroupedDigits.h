// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace offmap::rawlog {

/// "1,234,567", whatever the locale.
std::string grouped(uint64_t number);

}  // namespace offmap::rawlog
