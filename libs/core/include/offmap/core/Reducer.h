// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>

#include <memory>

namespace offmap::core {

/// Finds the returns of a scan that the map knows. Keeps its working memory from scan to scan; one
/// Reducer per thread. The map must outlive it.
class Reducer {
 public:
    /// \throw std::invalid_argument if the configuration is not valid.
    Reducer(const LineMap& map, const ReductionConfig& config);
    ~Reducer();
    Reducer(Reducer&&) noexcept;
    Reducer& operator=(Reducer&&) = delete;

    /// The result belongs to the reducer and holds until the next call.
    const ReductionResult& reduce(const OrganizedScan& scan);

 private:
    struct Workspace;
    void reduceByRays(const OrganizedScan& scan);
    void reduceByGates(const OrganizedScan& scan);

    const LineMap& map_;
    ReductionConfig config_;
    std::unique_ptr<Workspace> work_;
};

}  // namespace offmap::core
