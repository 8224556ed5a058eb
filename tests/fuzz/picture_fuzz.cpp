// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzedFile.h"

#include <offmap/maps/MapPicture.h>

/// Whatever the bytes: a message, or a picture whose walls make a map.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    static const offmap::test::FuzzedFile file("fuzz.png");  // GDAL goes by the content
    file.write(bytes, size);
    offmap::maps::MapOptions options;
    options.resolution = 0.1;
    offmap::test::expectMapOrMessage(
        [&] { return offmap::maps::readMapPicture(file.path(), options); });
    return 0;
}
