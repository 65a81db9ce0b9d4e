// SPDX-License-Identifier: MIT
#include "shared_image.hpp"

#include <EGL/egl.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <cstring>
#include <string>

namespace {

/// Returns a function of OpenGL. Throws NotShared if the driver lacks it.
template <class Function>
Function gl(const char* name) {
    auto* const found = reinterpret_cast<Function>(eglGetProcAddress(name));
    if (found == nullptr) throw NotShared(std::string("this OpenGL has no ") + name);
    return found;
}

/// Memory of a device.
struct Allocation {
    VkMemoryRequirements needs;
    VkDeviceMemory memory;
};

Allocation allocate(const VulkanDevice& device, const VkMemoryRequirements& needs,
                    VkMemoryPropertyFlags properties, const void* next) {
    VkMemoryAllocateInfo wanted{};
    wanted.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    wanted.pNext = next;
    wanted.allocationSize = needs.size;
    wanted.memoryTypeIndex = device.memory_type(needs.memoryTypeBits, properties);
    Allocation made{.needs = needs, .memory = VK_NULL_HANDLE};
    check(vkAllocateMemory(device.get(), &wanted, nullptr, &made.memory), "vkAllocateMemory");
    return made;
}

}  // namespace

SharedImage::SharedImage(const VulkanDevice& device, std::uint32_t width, std::uint32_t height)
    : device_(device), width_(width), height_(height) {
    VkExternalMemoryImageCreateInfo external{};
    external.sType = VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_IMAGE_CREATE_INFO;
    external.handleTypes = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
    VkImageCreateInfo image{};
    image.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    image.pNext = &external;
    image.imageType = VK_IMAGE_TYPE_2D;
    image.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    image.extent = {width, height, 1};
    image.mipLevels = 1;
    image.arrayLayers = 1;
    image.samples = VK_SAMPLE_COUNT_1_BIT;
    image.usage =
        VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    check(vkCreateImage(device.get(), &image, nullptr, &image_), "vkCreateImage");

    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device.get(), image_, &needs);
    VkMemoryDedicatedAllocateInfo dedicated{};
    dedicated.sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO;
    dedicated.image = image_;
    VkExportMemoryAllocateInfo exported{};
    exported.sType = VK_STRUCTURE_TYPE_EXPORT_MEMORY_ALLOCATE_INFO;
    exported.pNext = &dedicated;
    exported.handleTypes = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
    memory_ = allocate(device, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, &exported).memory;
    check(vkBindImageMemory(device.get(), image_, memory_, 0), "vkBindImageMemory");

    VkMemoryGetFdInfoKHR wanted{};
    wanted.sType = VK_STRUCTURE_TYPE_MEMORY_GET_FD_INFO_KHR;
    wanted.memory = memory_;
    wanted.handleType = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
    auto* const get_descriptor =
        reinterpret_cast<PFN_vkGetMemoryFdKHR>(vkGetDeviceProcAddr(device.get(), "vkGetMemoryFdKHR"));
    int descriptor = -1;
    check(get_descriptor(device.get(), &wanted, &descriptor), "vkGetMemoryFdKHR");

    // OpenGL owns the descriptor from here on.
    gl<PFNGLCREATEMEMORYOBJECTSEXTPROC>("glCreateMemoryObjectsEXT")(1, &memory_object_);
    const GLint whole = GL_TRUE;
    gl<PFNGLMEMORYOBJECTPARAMETERIVEXTPROC>("glMemoryObjectParameterivEXT")(
        memory_object_, GL_DEDICATED_MEMORY_OBJECT_EXT, &whole);
    gl<PFNGLIMPORTMEMORYFDEXTPROC>("glImportMemoryFdEXT")(memory_object_, needs.size,
                                                          GL_HANDLE_TYPE_OPAQUE_FD_EXT, descriptor);
    gl<PFNGLCREATETEXTURESPROC>("glCreateTextures")(GL_TEXTURE_2D, 1, &texture_);
    gl<PFNGLTEXTURESTORAGEMEM2DEXTPROC>("glTextureStorageMem2DEXT")(
        texture_, 1, GL_RGBA32F, static_cast<GLsizei>(width), static_cast<GLsizei>(height), memory_object_,
        0);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw Failure("OpenGL does not take Vulkan's memory: error " + std::to_string(error));
}

SharedImage::~SharedImage() {
    glDeleteTextures(1, &texture_);
    gl<PFNGLDELETEMEMORYOBJECTSEXTPROC>("glDeleteMemoryObjectsEXT")(1, &memory_object_);
    vkDestroyImage(device_.get(), image_, nullptr);
    vkFreeMemory(device_.get(), memory_, nullptr);
}

std::vector<float> SharedImage::texels() const {
    std::vector<float> out(std::size_t{4} * width_ * height_);
    const VkDeviceSize bytes = out.size() * sizeof(float);
    VkBufferCreateInfo wanted{};
    wanted.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    wanted.size = bytes;
    wanted.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VkBuffer buffer = VK_NULL_HANDLE;
    check(vkCreateBuffer(device_.get(), &wanted, nullptr, &buffer), "vkCreateBuffer");
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device_.get(), buffer, &needs);
    const VkDeviceMemory memory =
        allocate(device_, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                 nullptr)
            .memory;
    check(vkBindBufferMemory(device_.get(), buffer, memory, 0), "vkBindBufferMemory");

    device_.run([&](VkCommandBuffer commands) {
        // Takes the image over from OpenGL, which has left its content in the general layout.
        VkImageMemoryBarrier barrier{};
        barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
        barrier.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
        barrier.oldLayout = VK_IMAGE_LAYOUT_GENERAL;
        barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
        barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_EXTERNAL;
        barrier.dstQueueFamilyIndex = 0;
        barrier.image = image_;
        barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0,
                             0, nullptr, 0, nullptr, 1, &barrier);
        VkBufferImageCopy copy{};
        copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        copy.imageExtent = {width_, height_, 1};
        vkCmdCopyImageToBuffer(commands, image_, VK_IMAGE_LAYOUT_GENERAL, buffer, 1, &copy);
    });
    void* mapped = nullptr;
    check(vkMapMemory(device_.get(), memory, 0, bytes, 0, &mapped), "vkMapMemory");
    std::memcpy(out.data(), mapped, bytes);
    vkDestroyBuffer(device_.get(), buffer, nullptr);
    vkFreeMemory(device_.get(), memory, nullptr);
    return out;
}
