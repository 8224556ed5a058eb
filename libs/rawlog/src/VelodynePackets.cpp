// SPDX-License-Identifier: BSD-3-Clause
#include "AppendedReturns.h"
#include "LaserDirections.h"
#include "PacketTimes.h"
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
using Appender = AppendedReturns::Appender;

constexpr size_t blocksPerPacket = Scan::BLOCKS_PER_PACKET;

class Decoder {
 public:
    Decoder(const Scan& obs, const VelodyneDecoding& decoding, VelodyneReturns& out)
        : obs_(obs),
          model_(modelOf(obs)),
          lasers_(calibrationOf(obs, model_)),
          lasersPerBlock_(Scan::SCANS_PER_BLOCK / model_.firingsPerBlock),
          start_(timeOfFirstPacket(obs, decoding.timeReference)),
          out_(out),
          returns_(out),
          directions_(model_, lasers_.size(), out.azimuthCorrections) {
        if (!out_.firings.empty()) return;
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
        const size_t end = obs_.scan_packets.size();
        returns_.makeRoom(firstPacket < end ? (end - firstPacket) * slotsPerPacket : 0);
        for (size_t p = firstPacket; p < end; ++p) decodePacket(p);
        returns_.giveBackRoom();
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
        Appender to = returns_.appender();
        for (size_t l = 0; l < lasersPerBlock_; ++l) {
            if (const uint16_t distance = shots.distance(l)) add(shots, l, distance, to);
        }
        returns_.takeUpTo(to);
    }

    /// The last returns, and of the strongest those that equal them or have none beside them.
    void addFirst(const Shots& lasts, const Shots& strongests) {
        Appender to = returns_.appender();
        for (size_t l = 0; l < lasersPerBlock_; ++l) {
            const uint16_t last = lasts.distance(l), strongest = strongests.distance(l);
            if (last != 0) add(lasts, l, last, to);
            if (strongest != 0 && (last == 0 || last == strongest)) {
                add(strongests, l, strongest, to);
            }
        }
        returns_.takeUpTo(to);
    }

    /// The strongest returns of lasers whose last return is another one.
    void addDifferent(const Shots& lasts, const Shots& strongests) {
        Appender to = returns_.appender();
        for (size_t l = 0; l < lasersPerBlock_; ++l) {
            const uint16_t last = lasts.distance(l), strongest = strongests.distance(l);
            if (last != 0 && strongest != 0 && last != strongest) {
                add(strongests, l, strongest, to);
            }
        }
        returns_.takeUpTo(to);
    }

    void add(const Shots& shots, size_t l, uint16_t distance, Appender& to) const {
        const size_t laser = shots.firstLaser + l;
        const Direction direction = ofBlock_.turned(shots.turns[laser]);
        to.add(pointOf(distance, direction, lasers_[laser]), shots.firstSlot + l, laser);
    }

    uint32_t pointCount() const { return static_cast<uint32_t>(returns_.count()); }

    const Scan& obs_;
    const VelodyneModel& model_;
    LaserCalibrations lasers_;
    size_t lasersPerBlock_;
    mrpt::Clock::time_point start_;
    VelodyneReturns& out_;
    AppendedReturns returns_;     ///< of out_
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
