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

    /// What GDAL has warned of, and what it could not read; each sentence once.
    const std::vector<std::string>& warnings() const { return warnings_; }
    const std::vector<std::string>& failures() const { return failures_; }

    /// The last failure; without any, the last warning, or what is said instead.
    std::string why(const std::string& instead) const;

 private:
    static void listen(CPLErr severity, CPLErrorNum number, const char* message);

    std::vector<std::string> warnings_, failures_;
};

}  // namespace offmap::maps
