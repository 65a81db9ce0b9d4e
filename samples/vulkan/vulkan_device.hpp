// SPDX-License-Identifier: MIT
// A Vulkan device, found by its UUID, that can share memory.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>

#include "common/failure.hpp"

/// The drivers cannot share memory.
struct NotShared : Failure {
    using Failure::Failure;
};

/// Throws Failure that names the call unless the result is success.
void check(VkResult result, const char* call);

/// Device with one queue.
class VulkanDevice {
public:
    /// Takes the device of this UUID, 32 hexadecimal digits. Throws Failure if Vulkan has no such device, or
    /// if it cannot share memory by file descriptors.
    explicit VulkanDevice(const std::string& uuid);
    ~VulkanDevice();
    VulkanDevice(const VulkanDevice&) = delete;
    VulkanDevice& operator=(const VulkanDevice&) = delete;

    [[nodiscard]] VkDevice get() const { return device_; }
    [[nodiscard]] const std::string& name() const { return name_; }

    /// Returns a type of memory among `types` with these properties. Throws Failure if there is none.
    [[nodiscard]] std::uint32_t memory_type(std::uint32_t types, VkMemoryPropertyFlags properties) const;

    /// Records commands by record(buffer), runs them and waits for their end.
    template <class Record>
    void run(const Record& record) const {
        const VkCommandBuffer buffer = begin();
        record(buffer);
        finish(buffer);
    }

private:
    [[nodiscard]] VkCommandBuffer begin() const;
    void finish(VkCommandBuffer buffer) const;

    VkInstance instance_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    std::string name_;
};
