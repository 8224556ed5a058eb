// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cpl_error.h>
#include <string>
#include <vector>

namespace offmap::maps {

/// While it lives, GDAL works in this thread as a map reader needs it: it says nothing, fetches
/// nothing, and draws curves finely.
class GdalSession {
 public:
    GdalSession();
    ~GdalSession();
    GdalSession(const GdalSession&) = delete;
    GdalSession& operator=(const GdalSession&) = delete;

    /// What GDAL has said since; each sentence once.
    const std::vector<std::string>& messages() const { return messages_; }

    /// The last of them; without any, what is said instead.
    std::string lastMessage(const std::string& instead) const;

 private:
    static void listen(CPLErr severity, CPLErrorNum number, const char* message);

    std::vector<std::string> messages_;
};

}  // namespace offmap::maps
