// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <utility>

namespace offmap::live {

/// A queue between two threads that never grows beyond its capacity. Where the reader is too slow,
/// the oldest item is dropped and counted, so that what it reads is never older than the queue is
/// long.
template <class Item>
class FreshestQueue {
 public:
    /// \throw std::invalid_argument for no capacity
    explicit FreshestQueue(size_t capacity) : capacity_(capacity) {
        if (capacity == 0) throw std::invalid_argument("FreshestQueue: a capacity of 0");
    }

    /// Never waits.
    void push(Item item) {
        {
            const std::lock_guard lock(mutex_);
            if (items_.size() == capacity_) {
                items_.pop_front();
                ++dropped_;
            }
            items_.push_back(std::move(item));
        }
        changed_.notify_all();
    }

    /// Waits for room instead of dropping. False if it was stopped before.
    bool pushAll(Item item, const std::stop_token& stop) {
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [&] { return items_.size() < capacity_; })) return false;
            items_.push_back(std::move(item));
        }
        changed_.notify_all();
        return true;
    }

    /// Waits for an item; none if it was stopped, nudged, or closed and empty.
    std::optional<Item> pop(const std::stop_token& stop) {
        std::optional<Item> item;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, stop, [&] { return !items_.empty() || closed_ || nudged_; });
            if (std::exchange(nudged_, false) || items_.empty() || stop.stop_requested())
                return std::nullopt;
            item = std::move(items_.front());
            items_.pop_front();
        }
        changed_.notify_all();
        return item;
    }

    /// What is in it may still be read; nothing more comes.
    void close() {
        {
            const std::lock_guard lock(mutex_);
            closed_ = true;
        }
        changed_.notify_all();
    }

    /// Makes one pop() return without an item.
    void nudge() {
        {
            const std::lock_guard lock(mutex_);
            nudged_ = true;
        }
        changed_.notify_all();
    }

    /// Whether nothing is in it and nothing more comes.
    bool ended() const {
        const std::lock_guard lock(mutex_);
        return closed_ && items_.empty();
    }
    uint64_t dropped() const {
        const std::lock_guard lock(mutex_);
        return dropped_;
    }
    size_t size() const {
        const std::lock_guard lock(mutex_);
        return items_.size();
    }

 private:
    const size_t capacity_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Item> items_;
    uint64_t dropped_ = 0;
    bool closed_ = false, nudged_ = false;
};

}  // namespace offmap::live
