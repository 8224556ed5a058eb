// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
    // Property tests draw the same cases in every run, unless RC_PARAMS says otherwise.
    setenv("RC_PARAMS", "seed=2006", 0);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
