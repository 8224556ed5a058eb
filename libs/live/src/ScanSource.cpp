// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/ScanSource.h>

namespace offmap::live {

std::string_view toString(SourceState state) {
    switch (state) {
        case SourceState::Starting:
            return "starting";
        case SourceState::Running:
            return "running";
        case SourceState::Stalled:
            return "stalled";
        case SourceState::Ended:
            return "ended";
        case SourceState::Failed:
            break;
    }
    return "failed";
}

}  // namespace offmap::live
