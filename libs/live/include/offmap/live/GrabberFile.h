// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace mrpt::hwdrivers {
class CGenericSensor;
}

namespace offmap::live {

/// The sensors that an INI file of rawlog-grabber names: each section but [global], unless it says
/// `rawlog-grabber-ignore = true`. Any thread may use it.
class GrabberFile {
 public:
    /// \throw std::runtime_error naming file, section and fix: what cannot be read, no sensor at
    /// all, one without driver, with an unknown one, without process_rate, or whose settings the
    /// driver refuses
    explicit GrabberFile(std::filesystem::path file);
    ~GrabberFile();
    GrabberFile(const GrabberFile&) = delete;
    GrabberFile& operator=(const GrabberFile&) = delete;

    /// One section a sensor, in the order of their names.
    const std::vector<std::string>& sections() const { return sections_; }

    /// The sensor of that section, with its settings; not initialised. \throw as the constructor
    std::unique_ptr<mrpt::hwdrivers::CGenericSensor> makeSensor(const std::string& section) const;

 private:
    struct Settings;
    [[noreturn]] void refuse(const std::string& section, const std::string& why) const;

    const std::filesystem::path file_;
    std::unique_ptr<Settings> settings_;
    std::vector<std::string> sections_;
};

}  // namespace offmap::live
