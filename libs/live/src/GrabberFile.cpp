// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/GrabberFile.h>
#include <offmap/rawlog/ShortReason.h>

#include <fmt/format.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/hwdrivers/CGenericSensor.h>

#include <fstream>
#include <mutex>
#include <sstream>
#include <stdexcept>

namespace offmap::live {

using mrpt::hwdrivers::CGenericSensor;

struct GrabberFile::Settings {
    mrpt::config::CConfigFileMemory ini;
    // Neither the table of drivers nor what reads settings is made for several threads.
    static inline std::mutex mutex;
};

namespace {

constexpr const char* ignoreKey = "rawlog-grabber-ignore";

std::string contentOf(const std::filesystem::path& file) {
    constexpr std::uintmax_t largest = 1 << 20;  // [byte]
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        throw std::runtime_error(
            fmt::format("{}: it is not there; an INI file as rawlog-grabber takes it is needed",
                        file.string()));
    }
    if (!std::filesystem::is_regular_file(file, error) ||
        std::filesystem::file_size(file, error) > largest) {
        throw std::runtime_error(
            fmt::format("{}: not an INI file as rawlog-grabber takes it", file.string()));
    }
    std::ostringstream content;
    std::ifstream in(file, std::ios::binary);
    if (!(content << in.rdbuf())) {
        throw std::runtime_error(fmt::format("{}: cannot be read, or is empty", file.string()));
    }
    return content.str();
}

}  // namespace

GrabberFile::GrabberFile(std::filesystem::path file)
    : file_(std::move(file)), settings_(std::make_unique<Settings>()) {
    settings_->ini.setContent(contentOf(file_));
    std::vector<std::string> sections;
    settings_->ini.getAllSections(sections);
    for (const std::string& section : sections) {
        if (section.empty() || section == "global") continue;
        try {
            if (settings_->ini.read_bool(section, ignoreKey, false)) continue;
        } catch (const std::exception& error) {
            refuse(section, fmt::format("{}: {}", ignoreKey, rawlog::shortReason(error)));
        }
        makeSensor(section);
        sections_.push_back(section);
    }
    if (sections_.empty()) {
        throw std::runtime_error(
            fmt::format("{}: no sensor; add a section as [LIDAR] with driver = CVelodyneScanner "
                        "and process_rate = 1000",
                        file_.string()));
    }
}

GrabberFile::~GrabberFile() = default;

void GrabberFile::refuse(const std::string& section, const std::string& why) const {
    throw std::runtime_error(fmt::format("{}: [{}]: {}", file_.string(), section, why));
}

std::unique_ptr<CGenericSensor> GrabberFile::makeSensor(const std::string& section) const {
    const std::lock_guard lock(Settings::mutex);
    const std::string driver = settings_->ini.read_string(section, "driver", "");
    if (driver.empty()) {
        refuse(section, fmt::format("no driver; add driver = CVelodyneScanner, or {} = true if it "
                                    "is no sensor",
                                    ignoreKey));
    }
    std::unique_ptr<CGenericSensor> sensor(CGenericSensor::createSensor(driver));
    if (!sensor) {
        refuse(section,
               fmt::format("driver = {}: there is none of that name; rawlog-grabber's manual "
                           "lists them",
                           driver));
    }
    try {
        sensor->loadConfig(settings_->ini, section);
    } catch (const std::exception& error) {
        refuse(section, fmt::format("{}: {}", driver, rawlog::shortReason(error)));
    }
    constexpr double slowest = 1e-3, fastest = 1e6;  // [Hz]
    const double rate = sensor->getProcessRate();
    if (!(rate >= slowest && rate <= fastest)) {
        refuse(section, fmt::format("process_rate = {}: {} ... {} Hz is allowed; add one, as "
                                    "process_rate = 1000",
                                    rate, slowest, fastest));
    }
    return sensor;
}

}  // namespace offmap::live
