// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace offmap::rawlog {

/// Where MRPT's programs put what an observation stores in a file of its own: in <name>_Images and
/// Images beside the rawlog, and beside it.
/// \param what "point cloud" \param label of the sensor \param name as the observation tells it
/// \return absolute \throw std::runtime_error that tells where the file was looked for
std::filesystem::path findExternalFile(const std::string& what, const std::string& label,
                                       const std::filesystem::path& name,
                                       const std::filesystem::path& rawlogFile);

}  // namespace offmap::rawlog
