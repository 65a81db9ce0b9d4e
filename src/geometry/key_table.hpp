// SPDX-License-Identifier: MIT
// Table of values by 64-bit keys, in one array.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace nicol {

/// Values by key, faster than std::unordered_map because an entry takes no memory of its own. Only the two
/// highest keys count as the same key.
template <class Value>
class KeyTable {
public:
    KeyTable() = default;
    KeyTable(const KeyTable&) = default;
    /// Leaves the other table empty.
    KeyTable(KeyTable&& other) noexcept
        : slots_(std::exchange(other.slots_, {})), size_(std::exchange(other.size_, 0)) {}
    KeyTable& operator=(const KeyTable&) = default;
    KeyTable& operator=(KeyTable&& other) noexcept {
        slots_ = std::exchange(other.slots_, {});
        size_ = std::exchange(other.size_, 0);
        return *this;
    }
    ~KeyTable() = default;

    /// Makes room for some entries.
    void reserve(std::size_t entries) {
        while (slots_.size() < 2 * entries) grow();
    }
    /// Returns the value of a key, which is `value` if the key is new, and whether it is.
    std::pair<Value*, bool> try_emplace(std::uint64_t key, const Value& value) {
        if (slots_.size() < 2 * (size_ + 1)) grow();
        Slot& slot = slots_[place_of(key)];
        const bool fresh = slot.key == kEmpty;
        if (fresh) {
            slot = {.key = kept(key), .value = value};
            ++size_;
        }
        return {&slot.value, fresh};
    }
    /// Returns the value of a key; null if there is none.
    [[nodiscard]] const Value* find(std::uint64_t key) const {
        if (slots_.empty()) return nullptr;
        const Slot& slot = slots_[place_of(key)];
        return slot.key == kEmpty ? nullptr : &slot.value;
    }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] std::size_t bytes() const noexcept { return slots_.capacity() * sizeof(Slot); }
    /// Calls visit(key, value) for each entry, in no order.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (const Slot& slot : slots_)
            if (slot.key != kEmpty) visit(slot.key, slot.value);
    }

private:
    static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};
    static constexpr std::size_t kFewest = 64;
    struct Slot {
        std::uint64_t key = kEmpty;
        Value value{};
    };

    [[nodiscard]] static std::uint64_t kept(std::uint64_t key) { return key == kEmpty ? key - 1 : key; }
    // Returns the place of a key, or of the empty slot where it would be.
    [[nodiscard]] std::size_t place_of(std::uint64_t key) const {
        const std::size_t mask = slots_.size() - 1;
        std::uint64_t hash = kept(key) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 32U;
        std::size_t place = static_cast<std::size_t>(hash) & mask;
        while (slots_[place].key != kEmpty && slots_[place].key != kept(key)) place = (place + 1) & mask;
        return place;
    }
    void grow() {
        const std::vector<Slot> before =
            std::exchange(slots_, std::vector<Slot>(slots_.empty() ? kFewest : 2 * slots_.size()));
        for (const Slot& slot : before)
            if (slot.key != kEmpty) slots_[place_of(slot.key)] = slot;
    }

    std::vector<Slot> slots_;  // a power of two of them, at least twice as many as entries
    std::size_t size_ = 0;
};

}  // namespace nicol
