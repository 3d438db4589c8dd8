// Values that several threads share and that are computed once each.
#pragma once

#include <map>
#include <mutex>
#include <optional>

namespace carom {

/// Any number of threads may call `get`. Values stay where they are until the map is destroyed.
template <class Key, class Value>
class MemoTable {
  public:
    /// The value of `key`. The first thread that asks calls `make`, and others wait for it. If it
    /// throws, so does `get`, and the next thread that asks tries again.
    template <class Make>
    const Value& get(const Key& key, const Make& make) {
        Entry& entry = entry_of(key);
        std::call_once(entry.once, [&] { entry.value.emplace(make()); });
        return *entry.value;
    }

  private:
    struct Entry {
        std::once_flag once;
        std::optional<Value> value;
    };

    Entry& entry_of(const Key& key) {
        const std::lock_guard lock(mutex_);
        return entries_[key];
    }

    std::mutex mutex_;
    std::map<Key, Entry> entries_;
};

}  // namespace carom
