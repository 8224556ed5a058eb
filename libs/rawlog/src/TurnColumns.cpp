// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/RangeSigma.h>
#include <offmap/rawlog/SelfMask.h>
#include <offmap/rawlog/TurnColumns.h>

namespace offmap::rawlog {

TurnColumns::TurnColumns(const ScanClass& scanClass, const PoseSource& poses,
                         const SensorConfig& config, double sigmaRange)
    : scanClass_(scanClass),
      poses_(poses),
      config_(config),
      sigmaRange_(sigmaRange),
      revision_(poses.settled().revision),
      stream_(scanClass.columnStream(poses, config)) {}

void TurnColumns::add(const Turn& soFar) {
    const size_t known = turn_.scan.columns.size();
    stream_->add(soFar, turn_);
    complete(soFar, known);
}

void TurnColumns::finish(const Turn& turn) {
    const size_t known = turn_.scan.columns.size();
    stream_->finish(turn, turn_);
    complete(turn, known);
}

void TurnColumns::complete(const Turn& turn, size_t firstColumn) {
    maskSelfReturns(turn_, config_, firstColumn);
    findRangeSigmas(turn_, turn, scanClass_, config_, sigmaRange_);
}

}  // namespace offmap::rawlog
