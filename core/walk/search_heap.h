#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace stridegraph {

/// The open list of a best-first search: smallest value first, and among equals the one pushed with the
/// smaller id. The order is total, so that every standard library pops in the same order.
class SearchHeap {
 public:
  bool empty() const { return entries_.empty(); }
  void clear() { entries_.clear(); }

  void push(double value, std::uint32_t id) {
    entries_.push_back({value, id});
    std::push_heap(entries_.begin(), entries_.end(), after);
  }

  /// The best entry's value; must not be empty.
  double least() const { return entries_.front().value; }

  /// Removes the best entry and returns its id; must not be empty.
  std::uint32_t pop() {
    std::pop_heap(entries_.begin(), entries_.end(), after);
    const std::uint32_t id = entries_.back().id;
    entries_.pop_back();
    return id;
  }

  /// Gives every entry another value, by its id.
  template <typename ValueOf>
  void revalue(const ValueOf& valueOf) {
    for (Entry& entry : entries_) entry.value = valueOf(entry.id);
    std::make_heap(entries_.begin(), entries_.end(), after);
  }

 private:
  struct Entry {
    double value;
    std::uint32_t id;
  };
  static bool after(const Entry& a, const Entry& b) {
    return a.value != b.value ? a.value > b.value : a.id > b.id;
  }
  std::vector<Entry> entries_;
};

}  // namespace stridegraph
