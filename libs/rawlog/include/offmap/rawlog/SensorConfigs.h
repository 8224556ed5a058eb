// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>

#include <map>
#include <string>

namespace offmap::rawlog {

/// What a configuration says of each sensor, put together when it is first asked for: observations
/// are many, labels are few.
class SensorConfigs {
 public:
    explicit SensorConfigs(const Config& config) : config_(config) {}

    /// See Config::sensorOf(). The reference holds as long as this object, moved or not.
    const SensorConfig& of(const std::string& label) {
        const auto known = byLabel_.find(label);
        if (known != byLabel_.end()) return known->second;
        return byLabel_.emplace(label, config_.sensorOf(label)).first->second;
    }

 private:
    Config config_;
    std::map<std::string, SensorConfig> byLabel_;  // as far as asked for
};

}  // namespace offmap::rawlog
