// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/VelodynePcap.h>

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <pcap/pcap.h>
#include <stdexcept>

namespace offmap::live {

using Steady = std::chrono::steady_clock;

namespace {

mrpt::Clock::time_point timeOf(const timeval& time) {
    return mrpt::Clock::fromDouble(static_cast<double>(time.tv_sec) +
                                   1e-6 * static_cast<double>(time.tv_usec));
}

}  // namespace

/// The packets of the sensor's size in a capture, whoever sent them to whatever port.
class VelodynePcap::Capture {
 public:
    explicit Capture(const std::filesystem::path& file)
        : name_(file.string()), capture_(nullptr, pcap_close) {
        char error[PCAP_ERRBUF_SIZE] = "";
        capture_.reset(pcap_open_offline(name_.c_str(), error));
        if (!capture_) {
            throw std::runtime_error(
                fmt::format("{}: no network capture: {}; a PCAP file is needed", name_, error));
        }
    }

    /// None at the end. \throw std::runtime_error if it is damaged
    std::optional<std::pair<VelodynePacket, mrpt::Clock::time_point>> next() {
        pcap_pkthdr* header = nullptr;
        const u_char* bytes = nullptr;
        for (;;) {
            const int got = pcap_next_ex(capture_.get(), &header, &bytes);
            if (got == PCAP_ERROR_BREAK) return std::nullopt;
            if (got != 1) {
                throw std::runtime_error(
                    fmt::format("{}: damaged: {}", name_, pcap_geterr(capture_.get())));
            }
            // A UDP datagram's content ends with the frame, whatever link it came by.
            constexpr bpf_u_int32 headers = 8 + 20, size = sizeof(VelodynePacket);
            constexpr bpf_u_int32 longestLink = 24;
            if (header->caplen != header->len || header->caplen < headers + size ||
                header->caplen > headers + size + longestLink)
                continue;
            std::pair<VelodynePacket, mrpt::Clock::time_point> packet;
            std::memcpy(&packet.first, bytes + header->caplen - size, size);
            packet.second = timeOf(header->ts);
            return packet;
        }
    }

 private:
    std::string name_;
    std::unique_ptr<pcap_t, void (*)(pcap_t*)> capture_;
};

VelodynePcap::VelodynePcap(const std::filesystem::path& file, std::string label, double speed)
    : capture_(std::make_unique<Capture>(file)),
      waits_(std::isinf(speed)),
      turns_(std::move(label)),
      clock_(speed) {}

VelodynePcap::~VelodynePcap() = default;

/// Null at the end of the capture. `lastPacket_` tells when it was complete.
VelodyneTurn VelodynePcap::readTurn(const std::stop_token& stop) {
    while (const auto packet = capture_->next()) {
        try {
            auto turn = turns_.add(packet->first, packet->second);
            lastPacket_ = packet->second;
            if (turn) return turn;
        } catch (const std::invalid_argument& error) {
            const std::lock_guard lock(mutex_);
            health_.message = fmt::format("packets that cannot be used: {}", error.what());
        }
        if (wantsPieces() && !waits_ && !handOverPiece(stop)) return nullptr;
    }
    return turns_.finish();
}

/// False if it was stopped while it waited.
bool VelodynePcap::handOverPiece(const std::stop_token& stop) {
    const auto piece = turns_.piece(packetsPerPiece);
    if (!piece) return true;
    uint64_t turn = 0;
    {
        std::unique_lock lock(mutex_);
        if (!waitUntilDue(lock, stop)) return false;
        turn = health_.received;
    }
    handOver({turn, piece->firstPacket, piece->packets});
    return true;
}

/// Until it is time for the last packet. False if it was stopped before.
bool VelodynePcap::waitUntilDue(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const auto due = clock_.due(lastPacket_, Steady::now());
    never_.wait_until(lock, stop, *due, [] { return false; });
    return !stop.stop_requested();
}

void VelodynePcap::end(SourceState state, const std::string& message) {
    const std::lock_guard lock(mutex_);
    health_.state = state;
    if (!message.empty()) health_.message = message;
    if (state == SourceState::Ended && health_.received == 0 && health_.message.empty()) {
        health_.state = SourceState::Failed;
        health_.message = "the capture holds no packets of a Velodyne";
    }
}

std::optional<ArrivedTurn> VelodynePcap::next(const std::stop_token& stop) {
    VelodyneTurn turn;
    try {
        turn = readTurn(stop);
    } catch (const std::runtime_error& error) {
        end(SourceState::Failed, error.what());
        return std::nullopt;
    }
    if (!turn && stop.stop_requested()) return std::nullopt;
    if (!turn) {
        end(SourceState::Ended, {});
        return std::nullopt;
    }
    std::unique_lock lock(mutex_);
    if (!waitUntilDue(lock, stop)) return std::nullopt;
    health_.state = SourceState::Running;
    health_.packetsMissing = turns_.packetsMissing();
    return ArrivedTurn{{std::move(turn)}, health_.received++, Steady::now()};
}

SourceHealth VelodynePcap::health() const {
    const std::lock_guard lock(mutex_);
    return health_;
}

}  // namespace offmap::live
