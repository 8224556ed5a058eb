// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzedFile.h"

#include <offmap/maps/GridFile.h>

/// Whatever the bytes: a message, or a grid map whose walls make a map.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    static const offmap::test::FuzzedFile file("fuzz.gridmap");
    file.write(bytes, size);
    offmap::test::expectMapOrMessage(
        [&] { return offmap::maps::readGridMapDrawing(file.path(), {}); });
    return 0;
}
