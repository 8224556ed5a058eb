// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace offmap::test {

/// Runs `work` in a child process, so that it may give up rights or limit itself.
/// \return what it returned, or threw; or how it died.
inline std::string inForkedChild(const std::function<std::string()>& work) {
    int ends[2];
    if (pipe(ends) != 0) return "no pipe";
    const pid_t child = fork();
    if (child == 0) {
        std::string answer;
        try {
            answer = work();
        } catch (const std::exception& e) {
            answer = e.what();
        }
        const bool sent = write(ends[1], answer.data(), answer.size()) >= 0;
        _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    std::string answer(4096, '\0');
    const ssize_t size = read(ends[0], answer.data(), answer.size());
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0) return "died with status " + std::to_string(status);
    answer.resize(size < 0 ? 0 : static_cast<size_t>(size));
    return answer;
}

/// Root may do anything in spite of permissions; nobody may not.
inline void dropRoot() {
    constexpr unsigned nobody = 65534;
    if (geteuid() != 0) return;
    if (setgid(nobody) != 0 || setuid(nobody) != 0) throw std::runtime_error("cannot drop root");
}

}  // namespace offmap::test
