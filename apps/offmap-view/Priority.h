// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace offmap::window {

/// This thread, and those that it starts, stand back where the window wants the processor, too:
/// reducing may take every core, and the window must answer all the same.
void standBack();

}  // namespace offmap::window
