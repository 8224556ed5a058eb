// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/ScanSource.h>
#include <offmap/live/VelodyneTurns.h>

#include <mutex>

namespace offmap::live {

/// The turns of a Velodyne that sends its packets to this machine.
class VelodyneUdp : public ScanSource {
 public:
    static constexpr uint16_t defaultPort = 2368;

    /// \param stallsAfter without a packet, what there is of a turn is delivered, and the source
    /// counts as stalled until the next one comes
    /// \throw std::runtime_error naming port and cause if it cannot be listened at
    VelodyneUdp(uint16_t port, std::string label,
                std::chrono::milliseconds stallsAfter = std::chrono::milliseconds(500));
    ~VelodyneUdp() override;
    VelodyneUdp(const VelodyneUdp&) = delete;
    VelodyneUdp& operator=(const VelodyneUdp&) = delete;

    std::optional<ArrivedTurn> next(const std::stop_token& stop) override;
    SourceHealth health() const override;

    /// That it listens at: if it was asked for 0, one that was free.
    uint16_t port() const;

 private:
    bool receive(VelodynePacket& packet);
    VelodyneTurn takePacket(const VelodynePacket& packet);
    VelodyneTurn takeSilence();
    ArrivedTurn delivered(VelodyneTurn turn);
    void handOverPiece();
    uint64_t received() const;

    const std::chrono::milliseconds stallsAfter_;
    int socket_;
    VelodyneTurns turns_;
    SteadyTime lastPacket_;

    mutable std::mutex mutex_;
    SourceHealth health_;
};

}  // namespace offmap::live
