// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/SegmentStory.h>

#include <string>

namespace offmap::view {

/// "wall 17"
std::string wallName(const SegmentStory& story);

/// Whether the wall of the story is the one that its predicted interval and residual are of. They
/// are of the wall on the ray; the one that it was matched to may be another.
bool isOfPrediction(const SegmentStory& story);

/// One sentence that explains to a person what became of the return.
std::string whyOf(const SegmentStory& story);

}  // namespace offmap::view
