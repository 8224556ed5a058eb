// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Gzip.h"
#include "GridSeeds.h"

#include <offmap/maps/GridWriter.h>

/// Writes grid maps into the folder that it is given.
int main(int argc, char** argv) {
    if (argc != 2) return 1;
    const std::filesystem::path folder = argv[1];
    const std::string bytes = offmap::maps::gridMapBytes(offmap::test::seedGrid());
    offmap::test::writeFile(folder / "plain", bytes);
    offmap::test::writeFile(folder / "zipped", offmap::test::gzipped(bytes));
}
