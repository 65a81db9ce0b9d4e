// SPDX-License-Identifier: MIT
// A polarization camera's frame in shared memory: its layout, and the sequence lock that guards it.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

/// Beginning of the shared memory, 64 bytes; the frame's pixels follow, uint16_t [row][column], first row at
/// the top.
struct MosaicHeader {
    char magic[8];            ///< "NICOLRAW"
    std::uint32_t layout;     ///< version of this layout: 1
    std::uint32_t width;      ///< pixels
    std::uint32_t height;     ///< pixels
    std::uint32_t mosaic;     ///< NICOL_MOSAIC_...
    std::uint32_t bits;       ///< bits per number
    std::uint32_t reserved;   ///< 0
    std::uint64_t sequence;   ///< odd while the writer changes the frame
    std::uint64_t frame;      ///< number of the frame, from 0
    std::uint64_t time;       ///< nanoseconds of CLOCK_MONOTONIC when the frame was exposed
    std::uint64_t reserved2;  ///< 0
};
static_assert(sizeof(MosaicHeader) == 64);

inline constexpr char kMosaicMagic[] = "NICOLRAW";

/// Number and time of a frame that was read.
struct FrameStamp {
    std::uint64_t frame = 0;
    std::uint64_t time = 0;
};

/// View of shared memory with one writer and any number of readers. The writer never waits. A reader that the
/// writer overtakes notices, and copies again.
class MosaicFrame {
public:
    /// memory: a MosaicHeader and its pixels, a multiple of 8 bytes at an address that is one.
    explicit MosaicFrame(std::span<std::byte> memory) noexcept
        : header_(reinterpret_cast<MosaicHeader*>(memory.data())),
          words_(reinterpret_cast<std::uint64_t*>(memory.data() + sizeof(MosaicHeader))),
          count_((memory.size() - sizeof(MosaicHeader)) / sizeof(std::uint64_t)) {}

    /// Returns the bytes that a frame of this size takes.
    static std::size_t bytes(std::size_t width, std::size_t height) noexcept {
        return sizeof(MosaicHeader) + (width * height * sizeof(std::uint16_t) + 7) / 8 * 8;
    }

    /// Replaces the frame. words: its pixels, as many as fit into the memory.
    void write(const FrameStamp& stamp, std::span<const std::uint64_t> words) noexcept {
        const std::uint64_t before = atomic(header_->sequence).load(std::memory_order_relaxed);
        atomic(header_->sequence).store(before + 1, std::memory_order_relaxed);
        std::atomic_thread_fence(std::memory_order_release);
        atomic(header_->frame).store(stamp.frame, std::memory_order_relaxed);
        atomic(header_->time).store(stamp.time, std::memory_order_relaxed);
        for (std::size_t i = 0; i < count_; ++i) atomic(words_[i]).store(words[i], std::memory_order_relaxed);
        atomic(header_->sequence).store(before + 2, std::memory_order_release);
    }

    /// Copies the frame once. Returns nothing if there is no frame yet, or if the writer changed it
    /// meanwhile: the copy is then useless.
    std::optional<FrameStamp> read(std::span<std::uint64_t> words) const noexcept {
        const std::uint64_t before = atomic(header_->sequence).load(std::memory_order_acquire);
        if (before == 0 || before % 2 != 0) return std::nullopt;
        const FrameStamp stamp{.frame = atomic(header_->frame).load(std::memory_order_relaxed),
                               .time = atomic(header_->time).load(std::memory_order_relaxed)};
        for (std::size_t i = 0; i < count_; ++i) words[i] = atomic(words_[i]).load(std::memory_order_relaxed);
        std::atomic_thread_fence(std::memory_order_acquire);
        if (atomic(header_->sequence).load(std::memory_order_relaxed) != before) return std::nullopt;
        return stamp;
    }

    /// Number of 64-bit words of the pixels.
    [[nodiscard]] std::size_t words() const noexcept { return count_; }

private:
    // Relaxed atomic words cost what plain ones do, and make the race of writer and reader a defined one.
    static std::atomic_ref<std::uint64_t> atomic(std::uint64_t& word) noexcept {
        static_assert(std::atomic_ref<std::uint64_t>::is_always_lock_free);
        return std::atomic_ref<std::uint64_t>(word);
    }

    MosaicHeader* header_;
    std::uint64_t* words_;
    std::size_t count_;
};
