// SPDX-License-Identifier: BSD-3-Clause
#include "BytesFromChild.h"

#include "Guarded.h"
#include "Handover.h"

#include <span>
#include <stdexcept>
#include <string_view>

namespace offmap::app {

namespace {

enum ChildCode : int { gaveBytes, gaveMessage };

Bytes bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

}  // namespace

Bytes bytesFromChild(
    size_t capacity, const std::function<Bytes(rawlog::GuardedStatus&)>& work,
    const std::function<std::string(const rawlog::GuardedOutcome&)>& messageOfDeath) {
    using Kind = rawlog::GuardedOutcome::Kind;
    Handover handover(capacity);
    const auto outcome = rawlog::runGuarded([&](rawlog::GuardedStatus& status) {
        try {
            handover.put(work(status));
            return gaveBytes;
        } catch (const std::exception& error) {
            handover.put(bytesOf(error.what()));
            return gaveMessage;
        }
    });
    if (outcome.kind == Kind::Interrupted) throw Interrupted(outcome.signal);
    if (outcome.kind == Kind::Died) throw std::runtime_error(messageOfDeath(outcome));
    const std::span<const uint8_t> content = handover.content();
    if (outcome.exitCode == gaveBytes) return {content.begin(), content.end()};
    throw std::runtime_error(std::string(content.begin(), content.end()));
}

}  // namespace offmap::app
