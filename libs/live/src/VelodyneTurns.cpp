// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/VelodyneTurns.h>
#include <offmap/rawlog/VelodyneModel.h>

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace offmap::live {

namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;

constexpr int circle = 36000;  // [1/100 deg]

/// The packet's fields are not aligned.
int rotationOf(const VelodynePacket& packet) {
    uint16_t rotation = 0;
    std::memcpy(&rotation, reinterpret_cast<const char*>(&packet.blocks[0]) + 2, sizeof rotation);
    return mrpt::toNativeEndianness(rotation) % circle;
}

uint32_t stampOf(const VelodynePacket& packet) {
    uint32_t stamp = 0;
    std::memcpy(&stamp,
                reinterpret_cast<const char*>(&packet) + Scan::BLOCKS_PER_PACKET * Scan::SIZE_BLOCK,
                sizeof stamp);
    return mrpt::toNativeEndianness(stamp);
}

/// \throw std::invalid_argument for another model than a VLP-16 or HDL-32E
const rawlog::VelodyneModel& modelOf(const VelodynePacket& packet) {
    Scan scan;
    scan.scan_packets.push_back(packet);
    const rawlog::VelodyneModel& model = rawlog::modelOf(scan);
    if (model.twoBanks) {
        throw std::invalid_argument("an HDL-64E, whose calibration its packets do not tell");
    }
    return model;
}

/// [us] from packet to packet.
double periodOf(const VelodynePacket& packet, const rawlog::VelodyneModel& model) {
    const int rotations = packet.laser_return_mode == Scan::RETMODE_DUAL
                              ? Scan::BLOCKS_PER_PACKET / 2
                              : Scan::BLOCKS_PER_PACKET;
    return rotations * model.blockPeriod;
}

}  // namespace

VelodyneTurn VelodyneTurns::add(const VelodynePacket& packet, mrpt::Clock::time_point arrived) {
    const rawlog::VelodyneModel& model = modelOf(packet);
    if (model_ && model_ != &model) {
        throw std::invalid_argument(
            fmt::format("of a {}, while a {} sends to the same place", model.name, model_->name));
    }
    model_ = &model;
    countMissing(stampOf(packet), periodOf(packet, model));
    const Passage passage = passageTo(rotationOf(packet));
    VelodyneTurn ended = passage.ended ? std::exchange(turn_, nullptr) : nullptr;
    if (!turn_) {
        turn_ = Scan::Create();
        turn_->sensorLabel = label_;
        turn_->timestamp = turn_->originalReceivedTimestamp = arrived;
        swept_ = 0;
        inPieces_ = 0;
    }
    turn_->scan_packets.push_back(packet);
    if (passage.ends) ended = std::exchange(turn_, nullptr);
    return ended;
}

std::optional<VelodynePiece> VelodyneTurns::piece(size_t leastPackets) {
    if (!turn_ || turn_->scan_packets.size() < inPieces_ + leastPackets) return std::nullopt;
    auto packets = Scan::Create();
    packets->sensorLabel = turn_->sensorLabel;
    packets->timestamp = packets->originalReceivedTimestamp = turn_->timestamp;
    const auto first = turn_->scan_packets.begin() + static_cast<std::ptrdiff_t>(inPieces_);
    packets->scan_packets.assign(first, turn_->scan_packets.end());
    return VelodynePiece{std::exchange(inPieces_, turn_->scan_packets.size()), packets};
}

VelodyneTurn VelodyneTurns::finish() {
    model_ = nullptr;
    lastStamp_.reset();
    lastRotation_.reset();
    return std::exchange(turn_, nullptr);
}

/// Stamps count within the hour. What is late by more than a second was not lost but not sent.
void VelodyneTurns::countMissing(uint32_t stamp, double period) {
    constexpr uint32_t hour = 3'600'000'000U, second = 1'000'000U;
    const auto before = std::exchange(lastStamp_, stamp);
    if (!before || stamp >= hour || *before >= hour) return;
    const uint32_t passed = (stamp + hour - *before) % hour;
    if (passed > second) return;
    const long periods = std::lround(passed / period);
    if (periods > 1) missing_ += static_cast<uint64_t>(periods - 1);
}

/// A turn that has just begun short of 0 degrees does not end there, if the head is slower than it
/// was.
VelodyneTurns::Passage VelodyneTurns::passageTo(int rotation) {
    const auto before = std::exchange(lastRotation_, rotation);
    if (!before) return {};
    const int advance = (rotation + circle - *before) % circle;
    swept_ += advance;
    if (swept_ <= circle / 2) return {};
    const bool ended = rotation < *before;
    return {ended, !ended && rotation + advance >= circle};
}

}  // namespace offmap::live
