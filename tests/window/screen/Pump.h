// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../WaitFor.h"

#include <wx/app.h>

namespace offmap::test {

/// Lets the toolkit work until something has come about. \return whether it has
inline bool pumpUntil(const std::function<bool()>& condition,
                      std::chrono::milliseconds longest = std::chrono::seconds(20)) {
    return waitFor(
        [&] {
            wxYield();
            wxTheApp->ProcessIdle();  // windows that are closed are deleted here
            return condition();
        },
        longest);
}

}  // namespace offmap::test
