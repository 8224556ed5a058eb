// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/VelodyneUdp.h>

#include <fmt/format.h>

#include <arpa/inet.h>
#include <cerrno>
#include <netinet/in.h>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace offmap::live {

using Steady = std::chrono::steady_clock;

namespace {

/// [ms] that a stop may have to wait for.
constexpr int pollPeriod = 50;

sockaddr_in addressOf(uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_ANY);
    address.sin_port = htons(port);
    return address;
}

int listenAt(uint16_t port) {
    const int handle = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    // A second and a half of a VLP-16 while the program is busy (2304 bytes a packet, as the system
    // counts). What it may not force, the system cuts down to net.core.rmem_max.
    const int buffer = 1 << 21;  // doubled by the system for what it adds
    if (::setsockopt(handle, SOL_SOCKET, SO_RCVBUFFORCE, &buffer, sizeof buffer) != 0)
        ::setsockopt(handle, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
    const sockaddr_in address = addressOf(port);
    if (handle < 0 ||
        ::bind(handle, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        const std::string cause = std::generic_category().message(errno);
        if (handle >= 0) ::close(handle);
        throw std::runtime_error(fmt::format(
            "cannot listen at UDP port {}: {}; does another program, or is the port below 1024?",
            port, cause));
    }
    return handle;
}

}  // namespace

VelodyneUdp::VelodyneUdp(uint16_t port, std::string label, std::chrono::milliseconds stallsAfter)
    : stallsAfter_(stallsAfter), socket_(listenAt(port)), turns_(std::move(label)) {
    health_.message = fmt::format("listening at UDP port {}", VelodyneUdp::port());
}

VelodyneUdp::~VelodyneUdp() { ::close(socket_); }

uint16_t VelodyneUdp::port() const {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
}

/// False if none came for a while, or something that is no packet.
bool VelodyneUdp::receive(VelodynePacket& packet) {
    pollfd watched{socket_, POLLIN, 0};
    if (::poll(&watched, 1, pollPeriod) <= 0) return false;
    return ::recv(socket_, &packet, sizeof packet, MSG_TRUNC) ==
           static_cast<ssize_t>(sizeof packet);
}

VelodyneTurn VelodyneUdp::takePacket(const VelodynePacket& packet) {
    VelodyneTurn turn;
    std::string refused;
    try {
        turn = turns_.add(packet, mrpt::Clock::now());
        lastPacket_ = Steady::now();
    } catch (const std::invalid_argument& error) {
        refused = fmt::format("packets that cannot be used: {}", error.what());
    }
    const std::lock_guard lock(mutex_);
    health_.message = refused;
    if (refused.empty()) health_.state = SourceState::Running;
    health_.packetsMissing = turns_.packetsMissing();
    return turn;
}

/// What there is of a turn, once it is clear that nothing more comes.
VelodyneTurn VelodyneUdp::takeSilence() {
    const std::lock_guard lock(mutex_);
    const bool stalls =
        health_.state == SourceState::Running && Steady::now() - lastPacket_ > stallsAfter_;
    if (!stalls) return nullptr;
    health_.state = SourceState::Stalled;
    health_.message = "no packets come";
    ++health_.connectionsLost;
    return turns_.finish();
}

ArrivedTurn VelodyneUdp::delivered(VelodyneTurn turn) {
    const std::lock_guard lock(mutex_);
    return {{std::move(turn)}, health_.received++, lastPacket_};
}

void VelodyneUdp::handOverPiece() {
    const auto piece = turns_.piece(packetsPerPiece);
    if (piece) handOver({received(), piece->firstPacket, piece->packets});
}

/// Turns, so far.
uint64_t VelodyneUdp::received() const {
    const std::lock_guard lock(mutex_);
    return health_.received;
}

std::optional<ArrivedTurn> VelodyneUdp::next(const std::stop_token& stop) {
    VelodynePacket packet{};
    while (!stop.stop_requested()) {
        VelodyneTurn turn = receive(packet) ? takePacket(packet) : takeSilence();
        if (turn) return delivered(std::move(turn));
        if (wantsPieces()) handOverPiece();
    }
    return std::nullopt;
}

SourceHealth VelodyneUdp::health() const {
    const std::lock_guard lock(mutex_);
    return health_;
}

}  // namespace offmap::live
