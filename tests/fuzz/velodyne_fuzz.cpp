// SPDX-License-Identifier: BSD-3-Clause
#include "../support/VelodyneFuzz.h"

#include <cstdint>

/// An exception that leaves it ends the run, and libFuzzer keeps the input.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    offmap::test::fuzzVelodyne({bytes, size});
    return 0;
}
