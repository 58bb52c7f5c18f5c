#pragma once

#include <cstdint>
#include <vector>

namespace stridegraph {

/// The whole part of a coordinate as a part of a key. Ways may lead out of the room, where coordinates are
/// negative: no unsigned number takes these directly.
inline std::uint64_t keyPart(double coordinate) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(coordinate));
}

/// A set of 64 bit keys, none of them ~0, by open addressing: only insertion, which is all that a closed list
/// needs.
class StateSet {
 public:
  StateSet() : slots_(std::size_t{1} << kInitialBits, kEmpty) {}

  /// Adds a key; false when it was there.
  bool insert(std::uint64_t key) {
    if (count_ * 2 >= slots_.size()) grow();
    if (!place(key)) return false;
    ++count_;
    return true;
  }

  bool contains(std::uint64_t key) const { return slots_[slotOf(key)] == key; }

 private:
  static constexpr std::uint64_t kEmpty = ~0ULL;
  static constexpr unsigned kInitialBits = 14;

  /// The slot that holds the key, or the empty one where it belongs.
  std::size_t slotOf(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    // The highest bits of the product hang on all bits of the key (Fibonacci hashing, Knuth 1973, 6.4).
    auto slot = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ULL) >> shift_);
    while (slots_[slot] != kEmpty && slots_[slot] != key) slot = (slot + 1) & mask;
    return slot;
  }

  bool place(std::uint64_t key) {
    std::uint64_t& slot = slots_[slotOf(key)];
    if (slot == key) return false;
    slot = key;
    return true;
  }

  void grow() {
    --shift_;
    std::vector<std::uint64_t> old(slots_.size() * 2, kEmpty);
    old.swap(slots_);
    for (const std::uint64_t key : old) {
      if (key != kEmpty) place(key);
    }
  }

  std::vector<std::uint64_t> slots_;
  unsigned shift_ = 64 - kInitialBits;  ///< That leaves as many bits of a product as number the slots.
  std::size_t count_ = 0;
};

}  // namespace stridegraph
