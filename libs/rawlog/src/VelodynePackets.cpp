// SPDX-License-Identifier: BSD-3-Clause
#include "LaserDirections.h"
#include "VelodyneFields.h"
#include "VelodynePoint.h"

#include <offmap/rawlog/VelodyneModel.h>
#include <offmap/rawlog/VelodynePackets.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;
using Packet = Scan::TVelodyneRawPacket;

constexpr size_t blocksPerPacket = Scan::BLOCKS_PER_PACKET;

/// Median of what the head turns [1/100 deg] from block to block, of those that are `stride` apart.
double medianStep(const Packet& packet, size_t stride) {
    std::vector<int> steps;
    for (size_t i = 0; i + stride < blocksPerPacket; ++i) {
        const int step = rotationOf(packet.blocks[i + stride]) - rotationOf(packet.blocks[i]);
        steps.push_back((step + 2 * Scan::ROTATION_MAX_UNITS) % Scan::ROTATION_MAX_UNITS);
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

/// The packet's stamp counts microseconds from the full hour, and starts again at the next.
std::chrono::microseconds sinceFirstPacket(const Scan& obs, const Packet& packet) {
    constexpr int64_t hour = 3'600'000'000;
    const int64_t first = stampOf(obs.scan_packets.front());
    int64_t elapsed = stampOf(packet) - first;
    if (elapsed <= -hour / 2) elapsed += hour;
    if (elapsed > hour / 2) elapsed -= hour;
    return std::chrono::microseconds(elapsed);
}

mrpt::Clock::time_point timeOfFirstPacket(const Scan& obs, TimeReference reference) {
    if (reference == TimeReference::First || obs.scan_packets.empty()) return obs.timestamp;
    const auto lasted = sinceFirstPacket(obs, obs.scan_packets.back());
    return obs.timestamp - (reference == TimeReference::Last ? lasted : lasted / 2);
}

class Decoder {
 public:
    Decoder(const Scan& obs, const VelodyneDecoding& decoding, VelodyneReturns& out)
        : obs_(obs),
          model_(modelOf(obs)),
          lasers_(calibrationOf(obs, model_)),
          lasersPerBlock_(Scan::SCANS_PER_BLOCK / model_.firingsPerBlock),
          start_(timeOfFirstPacket(obs, decoding.timeReference)),
          out_(out),
          directions_(model_, lasers_.size(), out.azimuthCorrections) {
        if (!out_.firings.empty()) return;
        out_.points.reserve(obs.scan_packets.size() * slotsPerPacket);
        out_.slots.reserve(obs.scan_packets.size() * slotsPerPacket);
        out_.lasers.reserve(obs.scan_packets.size() * slotsPerPacket);
        out_.upward.resize(lasers_.size());
        std::iota(out_.upward.begin(), out_.upward.end(), uint8_t{0});
        std::ranges::stable_sort(out_.upward, {},
                                 [&](uint8_t laser) { return lasers_[laser].sinVertCorrection; });
        const auto turned = [](const auto& laser) { return laser.azimuthCorrection != 0; };
        if (!decoding.correctAzimuth || std::ranges::none_of(lasers_, turned)) return;
        out_.azimuthCorrections.resize(lasers_.size());
        std::ranges::transform(lasers_, out_.azimuthCorrections.begin(), [](const auto& laser) {
            return mrpt::DEG2RAD(laser.azimuthCorrection + 0.0);
        });
    }

    void decodeFrom(size_t firstPacket) {
        for (size_t p = firstPacket; p < obs_.scan_packets.size(); ++p) decodePacket(p);
    }

 private:
    /// Where the returns of one firing are.
    struct Place {
        size_t packet, block;
        size_t firing;                ///< in the block
        std::optional<size_t> other;  ///< block of its lower bank, or of its strongest returns
    };

    bool isUpper(const Scan::raw_block_t& block) const {
        return headerOf(block) == Scan::UPPER_BANK;
    }
    bool isMangled(const Scan::raw_block_t& block) const {
        const bool lower = model_.twoBanks && headerOf(block) == Scan::LOWER_BANK;
        return (!isUpper(block) && !lower) || rotationOf(block) >= Scan::ROTATION_MAX_UNITS;
    }

    /// Whether the block after b belongs to the same firing.
    bool isPair(const Packet& packet, size_t b) const {
        const auto &block = packet.blocks[b], &next = packet.blocks[b + 1];
        return isUpper(block) && !isMangled(next) && isUpper(next) != model_.twoBanks &&
               rotationOf(next) == rotationOf(block);
    }

    void decodePacket(size_t p) {
        const Packet& packet = obs_.scan_packets[p];
        const auto packetTime = start_ + sinceFirstPacket(obs_, packet);
        const bool dual = model_.tellsReturnMode && packet.laser_return_mode == Scan::RETMODE_DUAL;
        const size_t stride = dual || model_.twoBanks ? 2 : 1;
        directions_.setRate(medianStep(packet, stride) / model_.blockPeriod);
        for (size_t b = 0; b < blocksPerPacket; ++b) {
            const size_t first = b, turned = b / stride;
            if (isMangled(packet.blocks[first])) continue;
            ofBlock_ = Direction::of(toRadians(rotationOf(packet.blocks[first])));
            std::optional<size_t> other;
            if (stride == 2 && b % 2 == 0 && isPair(packet, b)) other = ++b;
            for (size_t f = 0; f < model_.firingsPerBlock; ++f) {
                const double late = static_cast<double>(turned) * model_.blockPeriod +
                                    static_cast<double>(f) * model_.firingPeriod;
                const auto sincePacket = std::chrono::duration<double, std::micro>(late);
                decodeFiring(
                    {p, first, f, other},
                    packetTime + std::chrono::duration_cast<mrpt::Clock::duration>(sincePacket));
            }
        }
    }

    void decodeFiring(const Place& place, mrpt::Clock::time_point time) {
        VelodyneFiring firing;
        firing.time = time;
        const double middle = 0.5 * static_cast<double>(lasersPerBlock_ - 1);
        const double rotation = rotationOf(obs_.scan_packets[place.packet].blocks[place.block]);
        firing.azimuth = -toRadians(rotation + directions_.turned(place.firing, middle));
        firing.begin = firing.second = pointCount();
        const Shots shots = shotsOf(place, place.block);
        const bool dual = place.other && !model_.twoBanks;
        if (dual) {
            addFirst(shots, shotsOf(place, *place.other));
        } else {
            addAll(shots);
            if (place.other) addAll(shotsOf(place, *place.other));
        }
        firing.second = pointCount();
        if (dual) addDifferent(shots, shotsOf(place, *place.other));
        firing.end = pointCount();
        out_.firings.push_back(firing);
    }

    /// What a firing has in one block.
    struct Shots {
        const Scan::laser_return_t* returns;
        size_t firstLaser, firstSlot;
        std::span<const Direction> turns;  ///< per laser, from `ofBlock_` on

        uint16_t distance(size_t l) const { return distanceOf(returns[l]); }
    };

    Shots shotsOf(const Place& place, size_t block) const {
        const auto& of = obs_.scan_packets[place.packet].blocks[block];
        const size_t inBlock = place.firing * lasersPerBlock_;
        const size_t blockOfScan = place.packet * blocksPerPacket + block;
        return {of.laser_returns + inBlock, isUpper(of) ? 0UL : Scan::SCANS_PER_BLOCK,
                blockOfScan * Scan::SCANS_PER_BLOCK + inBlock, directions_.ofFiring(place.firing)};
    }

    void addAll(const Shots& shots) {
        for (size_t l = 0; l < lasersPerBlock_; ++l) {
            if (const uint16_t distance = shots.distance(l)) addReturn(shots, l, distance);
        }
    }

    /// The last returns, and of the strongest those that equal them or have none beside them.
    void addFirst(const Shots& lasts, const Shots& strongests) {
        for (size_t l = 0; l < lasersPerBlock_; ++l) {
            const uint16_t last = lasts.distance(l), strongest = strongests.distance(l);
            if (last != 0) addReturn(lasts, l, last);
            if (strongest != 0 && (last == 0 || last == strongest)) {
                addReturn(strongests, l, strongest);
            }
        }
    }

    /// The strongest returns of lasers whose last return is another one.
    void addDifferent(const Shots& lasts, const Shots& strongests) {
        for (size_t l = 0; l < lasersPerBlock_; ++l) {
            const uint16_t last = lasts.distance(l), strongest = strongests.distance(l);
            if (last != 0 && strongest != 0 && last != strongest) {
                addReturn(strongests, l, strongest);
            }
        }
    }

    void addReturn(const Shots& shots, size_t l, uint16_t distance) {
        const size_t laser = shots.firstLaser + l;
        const Direction direction = ofBlock_.turned(shots.turns[laser]);
        out_.points.push_back(pointOf(distance, direction, lasers_[laser]));
        out_.slots.push_back(static_cast<uint32_t>(shots.firstSlot + l));
        out_.lasers.push_back(static_cast<uint8_t>(laser));
    }

    uint32_t pointCount() const { return static_cast<uint32_t>(out_.points.size()); }

    const Scan& obs_;
    const VelodyneModel& model_;
    LaserCalibrations lasers_;
    size_t lasersPerBlock_;
    mrpt::Clock::time_point start_;
    VelodyneReturns& out_;
    LaserDirections directions_;  ///< from `ofBlock_` on
    Direction ofBlock_;           ///< where the head looks when the block's first laser fires
};

}  // namespace

uint16_t distanceOf(const Scan::laser_return_t& laserReturn) {
    return field<uint16_t>(&laserReturn, 0);
}

VelodyneReturns decodePackets(const Scan& obs, const VelodyneDecoding& decoding) {
    VelodyneReturns out;
    decodeFurther(obs, 0, decoding, out);
    return out;
}

void decodeFurther(const Scan& obs, size_t firstPacket, const VelodyneDecoding& decoding,
                   VelodyneReturns& out) {
    Decoder(obs, decoding, out).decodeFrom(firstPacket);
}

const Scan::laser_return_t& returnInSlot(const Scan& obs, size_t slot) {
    const size_t block = slot / Scan::SCANS_PER_BLOCK;
    return obs.scan_packets[block / blocksPerPacket]
        .blocks[block % blocksPerPacket]
        .laser_returns[slot % Scan::SCANS_PER_BLOCK];
}

}  // namespace offmap::rawlog
