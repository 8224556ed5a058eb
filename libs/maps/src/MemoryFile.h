// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace offmap::maps {

/// A file that GDAL can open and that stands in memory, under a name that no other has.
class MemoryFile {
 public:
    /// One that is yet to be written.
    MemoryFile();
    explicit MemoryFile(std::string bytes, std::string_view extension = {});
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const char* name() const { return name_.c_str(); }
    std::string bytes() const;

 private:
    std::string content_, name_;
};

}  // namespace offmap::maps
