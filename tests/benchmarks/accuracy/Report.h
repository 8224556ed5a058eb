// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Acceptance.h"

#include <string>

namespace offmap::accuracy {

/// The figures as Markdown. The drawings are expected in a folder beside it, of the same name.
/// \param date YYYY-MM-DD, that it bears
std::string reportOf(const Studies& studies, const Extent& extent, const std::string& date);

/// The rows of the bounds' table.
std::string tableOf(const std::vector<Bound>& bounds);

}  // namespace offmap::accuracy
