// SPDX-License-Identifier: BSD-3-Clause
#include "Console.h"

#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace offmap::app {

void prepareStandardStreams() {
    int opened = 0;
    while (opened >= 0 && opened <= STDERR_FILENO) opened = open("/dev/null", O_RDWR);
    if (opened > STDERR_FILENO) close(opened);
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace offmap::app
