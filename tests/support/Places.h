// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace offmap::test {

// Defined in main.cpp: the only file of the tests that knows absolute paths, so that the others
// compile alike wherever the project stands.

/// The project's own folder.
std::filesystem::path sourceFolder();

/// The program under test; empty for the tests of a library.
std::filesystem::path offmapBinary();

}  // namespace offmap::test
