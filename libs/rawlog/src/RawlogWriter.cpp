// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/RawlogWriter.h>
#include <offmap/rawlog/Serialised.h>

namespace offmap::rawlog {

RawlogWriter::RawlogWriter(const std::filesystem::path& target, OutputOptions options)
    : file_(target, options) {}

void RawlogWriter::write(const mrpt::serialization::CSerializable& object) {
    serialised_.clear();
    serialise(object, serialised_);
    file_.write(serialised_);
}

}  // namespace offmap::rawlog
