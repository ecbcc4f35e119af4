// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>

namespace bedmix {

/// Values that are made when they are first asked for, each once, from any thread.
template <class Key, class Value>
class LazyMap {
 public:
  const Value& get(const Key& key, const std::function<Value()>& make) {
    Entry* entry = nullptr;
    {
      const std::lock_guard lock(mutex_);
      entry = &entries_[key];
    }
    std::call_once(entry->made, [&] { entry->value.emplace(make()); });
    return *entry->value;
  }

 private:
  struct Entry {
    std::once_flag made;
    std::optional<Value> value;
  };
  std::mutex mutex_;
  std::map<Key, Entry> entries_;
};

}  // namespace bedmix
