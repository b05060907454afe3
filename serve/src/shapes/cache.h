// Things that were costly to make, the last used of them, up to so many bytes.
#pragma once

#include <cstddef>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

namespace rectilin::serve {

/// Thread safe. Values are copied out, so they should be pointers.
template <class Value>
class Cache {
 public:
  explicit Cache(std::size_t bytes) : room_(bytes) {}

  std::optional<Value> get(const std::string& key) {
    const std::lock_guard lock(mutex_);
    const auto found = places_.find(key);
    if (found == places_.end()) return std::nullopt;
    items_.splice(items_.begin(), items_, found->second);
    return found->second->value;
  }

  /// Forgets what was used longest ago to make room; what is larger than all the room is not kept.
  void put(const std::string& key, Value value, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    if (const auto found = places_.find(key); found != places_.end()) drop(found->second);
    if (bytes > room_) return;
    while (used_ + bytes > room_) drop(std::prev(items_.end()));
    items_.push_front({key, std::move(value), bytes});
    places_[key] = items_.begin();
    used_ += bytes;
  }

  std::size_t used() {
    const std::lock_guard lock(mutex_);
    return used_;
  }

 private:
  struct Item {
    std::string key;
    Value value;
    std::size_t bytes;
  };
  void drop(typename std::list<Item>::iterator item) {
    used_ -= item->bytes;
    places_.erase(item->key);
    items_.erase(item);
  }

  std::mutex mutex_;
  std::size_t room_, used_ = 0;
  std::list<Item> items_;  // the last used first
  std::unordered_map<std::string, typename std::list<Item>::iterator> places_;
};

}  // namespace rectilin::serve
