// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ColumnStream.h>
#include <offmap/rawlog/ScanClass.h>

#include <fmt/format.h>

#include <stdexcept>

namespace offmap::rawlog {

namespace {

/// Of a class whose columns are known only when the turn is complete.
class ColumnsAtTheEnd final : public ColumnStream {
 public:
    ColumnsAtTheEnd(const ScanClass& scanClass, const PoseSource& poses, const SensorConfig& config)
        : scanClass_(scanClass), poses_(poses), config_(config) {}

    void add(const Turn&, TurnScan&) override {}
    void finish(const Turn& turn, TurnScan& out) override {
        out = scanClass_.organize(turn, poses_, config_);
    }

 private:
    const ScanClass& scanClass_;
    const PoseSource& poses_;
    const SensorConfig& config_;
};

}  // namespace

std::unique_ptr<ColumnStream> ScanClass::columnStream(const PoseSource& poses,
                                                      const SensorConfig& config) const {
    return std::make_unique<ColumnsAtTheEnd>(*this, poses, config);
}

void ScanClass::checkMask(const mrpt::obs::CObservation& obs, SlotMask keep) const {
    if (keep.size() == slotCount(obs)) return;
    throw std::invalid_argument(fmt::format("a mask of {} entries for the {} slots of '{}'",
                                            keep.size(), slotCount(obs), obs.sensorLabel));
}

}  // namespace offmap::rawlog
