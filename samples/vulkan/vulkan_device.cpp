// SPDX-License-Identifier: MIT
#include "vulkan_device.hpp"

#include <array>
#include <vector>

namespace {

std::string hexadecimal(const std::uint8_t (&bytes)[VK_UUID_SIZE]) {
    static constexpr const char* digits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

}  // namespace

void check(VkResult result, const char* call) {
    if (result != VK_SUCCESS) throw Failure(std::string(call) + " returned " + std::to_string(result));
}

VulkanDevice::VulkanDevice(const std::string& uuid) {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo wanted{};
    wanted.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    wanted.pApplicationInfo = &application;
    if (vkCreateInstance(&wanted, nullptr, &instance_) != VK_SUCCESS) throw NotShared("Vulkan has no driver");

    std::uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance_, &count, nullptr), "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> devices(count);
    check(vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "vkEnumeratePhysicalDevices");
    std::string others;
    for (const VkPhysicalDevice candidate : devices) {
        VkPhysicalDeviceIDProperties ids{};
        ids.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES;
        VkPhysicalDeviceProperties2 properties{};
        properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
        properties.pNext = &ids;
        vkGetPhysicalDeviceProperties2(candidate, &properties);
        if (hexadecimal(ids.deviceUUID) == uuid) {
            physical_ = candidate;
            name_ = properties.properties.deviceName;
            break;
        }
        others += std::string(" ") + properties.properties.deviceName;
    }
    if (physical_ == VK_NULL_HANDLE)
        throw NotShared("Vulkan has no device " + uuid + " (OpenGL's) among" +
                        (others.empty() ? " none" : others));

    const float priority = 1;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const std::array extensions{VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME};
    VkDeviceCreateInfo device{};
    device.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    device.queueCreateInfoCount = 1;
    device.pQueueCreateInfos = &queue;
    device.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    device.ppEnabledExtensionNames = extensions.data();
    if (vkCreateDevice(physical_, &device, nullptr, &device_) != VK_SUCCESS)
        throw NotShared(name_ + " has no VK_KHR_external_memory_fd");
    vkGetDeviceQueue(device_, 0, 0, &queue_);
    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    check(vkCreateCommandPool(device_, &pool, nullptr, &pool_), "vkCreateCommandPool");
}

VulkanDevice::~VulkanDevice() {
    vkDestroyCommandPool(device_, pool_, nullptr);
    vkDestroyDevice(device_, nullptr);
    vkDestroyInstance(instance_, nullptr);
}

std::uint32_t VulkanDevice::memory_type(std::uint32_t types, VkMemoryPropertyFlags properties) const {
    VkPhysicalDeviceMemoryProperties memory{};
    vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
        if ((types >> i & 1) != 0 && (memory.memoryTypes[i].propertyFlags & properties) == properties)
            return i;
    throw Failure("the Vulkan device has no memory of the type that is wanted");
}

VkCommandBuffer VulkanDevice::begin() const {
    VkCommandBufferAllocateInfo wanted{};
    wanted.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    wanted.commandPool = pool_;
    wanted.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    wanted.commandBufferCount = 1;
    VkCommandBuffer buffer = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device_, &wanted, &buffer), "vkAllocateCommandBuffers");
    VkCommandBufferBeginInfo once{};
    once.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    once.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(buffer, &once), "vkBeginCommandBuffer");
    return buffer;
}

void VulkanDevice::finish(VkCommandBuffer buffer) const {
    check(vkEndCommandBuffer(buffer), "vkEndCommandBuffer");
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &buffer;
    check(vkQueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(queue_), "vkQueueWaitIdle");
    vkFreeCommandBuffers(device_, pool_, 1, &buffer);
}
