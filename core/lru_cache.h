// Results that take long to make and are asked for again and again with the same keys.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>

namespace carom {

/// Keeps the values that were used last, up to `most`. May be used from any thread.
template <typename Key, typename Value>
class LruCache {
  public:
    explicit LruCache(std::size_t most) : most_(most) {}

    /// The value of a key, as make() returned it. Two threads that ask for the same new key at once
    /// may both make it.
    template <typename Make>
    [[nodiscard]] std::shared_ptr<const Value> get(const Key& key, const Make& make) {
        {
            const std::lock_guard lock(mutex_);
            const auto found = std::ranges::find(entries_, key, &Entry::first);
            if (found != entries_.end()) {
                std::rotate(found, found + 1, entries_.end());
                return entries_.back().second;
            }
        }
        auto value = std::make_shared<const Value>(make());
        const std::lock_guard lock(mutex_);
        entries_.emplace_back(key, value);
        if (entries_.size() > most_) {
            entries_.pop_front();
        }
        return value;
    }

  private:
    using Entry = std::pair<Key, std::shared_ptr<const Value>>;
    std::size_t most_;
    std::mutex mutex_;
    std::deque<Entry> entries_;  // the last used ones at the end
};

}  // namespace carom
