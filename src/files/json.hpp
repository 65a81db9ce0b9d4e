// SPDX-License-Identifier: MIT
// JSON values that can be destroyed where memory is short.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace nicol {

/// Allocator of the values themselves: operator new, as std::allocator, which has another meaning for Json.
template <class T>
struct JsonAllocator {
    using value_type = T;
    JsonAllocator() = default;
    template <class U>
    explicit(false) JsonAllocator(const JsonAllocator<U>&) noexcept {}
    [[nodiscard]] T* allocate(std::size_t count) {
        return static_cast<T*>(::operator new(count * sizeof(T)));
    }
    void deallocate(T* block, std::size_t) noexcept { ::operator delete(block); }
    friend bool operator==(const JsonAllocator&, const JsonAllocator&) noexcept { return true; }
};

/// A value is destroyed by moving what it holds into a std::vector, in a destructor that may not throw. The
/// memory of this vector is that of the JsonRoom.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t,
                                  double, JsonAllocator>;

/// Memory for the destruction of all values of a text. It must outlive the values; one exists on a thread.
class JsonRoom {
public:
    explicit JsonRoom(std::string_view text);
    ~JsonRoom();
    JsonRoom(const JsonRoom&) = delete;
    JsonRoom& operator=(const JsonRoom&) = delete;

    [[nodiscard]] static Json* allocate(std::size_t count);
    static void deallocate(Json* block) noexcept;

private:
    [[nodiscard]] static JsonRoom*& current() noexcept;

    std::size_t size_;
    std::unique_ptr<std::byte[]> memory_;
    std::size_t taken_ = 0;   ///< bytes
    std::size_t blocks_ = 0;  ///< that live
};

}  // namespace nicol

/// Allocator of the vectors that nlohmann's destructors make: JsonRoom's memory.
template <>
struct std::allocator<nicol::Json> {
    using value_type = nicol::Json;
    using size_type = std::size_t;
    using difference_type = std::ptrdiff_t;
    using propagate_on_container_move_assignment = std::true_type;
    using is_always_equal = std::true_type;

    allocator() = default;
    [[nodiscard]] value_type* allocate(std::size_t count) { return nicol::JsonRoom::allocate(count); }
    void deallocate(value_type* block, std::size_t) noexcept { nicol::JsonRoom::deallocate(block); }
    friend bool operator==(const allocator&, const allocator&) noexcept { return true; }
};
