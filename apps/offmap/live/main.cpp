// SPDX-License-Identifier: BSD-3-Clause
#include "../CommandLine.h"
#include "../LiveProgram.h"
#include "LiveCommand.h"

int main(int argc, char** argv) {
    using namespace offmap::app;
    return runCommandLine(argc, argv, "offmap live", liveDescription, addLive);
}
