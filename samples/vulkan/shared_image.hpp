// SPDX-License-Identifier: MIT
// An image whose memory Vulkan and OpenGL share.
#pragma once

#include <cstdint>
#include <vector>

#include "vulkan_device.hpp"

/// Image of four 32-bit floats a texel.
class SharedImage {
public:
    /// Needs a current OpenGL context with GL_EXT_memory_object_fd on the device. Throws Failure.
    SharedImage(const VulkanDevice& device, std::uint32_t width, std::uint32_t height);
    ~SharedImage();
    SharedImage(const SharedImage&) = delete;
    SharedImage& operator=(const SharedImage&) = delete;

    /// Returns OpenGL's name of the texture.
    [[nodiscard]] std::uint32_t texture() const { return texture_; }
    /// Returns the texels as Vulkan sees them, row 0 first.
    [[nodiscard]] std::vector<float> texels() const;

private:
    const VulkanDevice& device_;
    std::uint32_t width_;
    std::uint32_t height_;
    VkImage image_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    std::uint32_t memory_object_ = 0;
    std::uint32_t texture_ = 0;
};
