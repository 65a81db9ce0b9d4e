// SPDX-License-Identifier: MIT
#include "files/json.hpp"

#include <algorithm>

namespace nicol {
namespace {

/// No fewer than the values of a text: each but the first of an array or object follows a comma.
std::size_t most_values(std::string_view text) {
    return 1 + static_cast<std::size_t>(
                   std::ranges::count_if(text, [](char c) { return c == ',' || c == '[' || c == '{'; }));
}

}  // namespace

// A vector that grows to hold all values has had rooms for a half, a quarter and so on before, and may end
// with room for twice as many.
JsonRoom::JsonRoom(std::string_view text)
    : size_(4 * sizeof(Json) * most_values(text)),
      memory_(std::make_unique_for_overwrite<std::byte[]>(size_)) {
    current() = this;
}

JsonRoom::~JsonRoom() {
    current() = nullptr;
}

JsonRoom*& JsonRoom::current() noexcept {
    thread_local JsonRoom* room = nullptr;
    return room;
}

Json* JsonRoom::allocate(std::size_t count) {
    JsonRoom* const room = current();
    if (room == nullptr || count > (room->size_ - room->taken_) / sizeof(Json)) throw std::bad_alloc();
    std::byte* const block = room->memory_.get() + room->taken_;
    room->taken_ += count * sizeof(Json);
    ++room->blocks_;
    return reinterpret_cast<Json*>(block);
}

void JsonRoom::deallocate(Json*) noexcept {
    JsonRoom* const room = current();
    if (--room->blocks_ == 0) room->taken_ = 0;
}

}  // namespace nicol
