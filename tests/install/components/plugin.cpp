// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/Reducer.h>

extern "C" bool reducesNothing() {
    const offmap::core::LineMap map({});
    const auto result = offmap::core::Reducer(map, {}).reduce(offmap::core::OrganizedScan());
    return result.labels.empty();
}
