// SPDX-License-Identifier: MIT
// Nicol renders into images of Vulkan without a copy: Vulkan allocates their memory, OpenGL takes it as
// textures, and Nicol's framebuffer is made of these. Ends with 1 if Vulkan sees other texels than Nicol
// rendered, and with 77 if the drivers cannot share memory.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <nicol.h>

#include <cstring>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "shared_image.hpp"
#include "vulkan_device.hpp"

namespace {

constexpr std::uint32_t kSize = 256;
constexpr std::uint32_t kChannels = 3;

void check(nicol_result result) {
    if (result != NICOL_OK) throw Failure(nicol_last_error());
}

/// Makes an OpenGL context without a window current.
void make_current() {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) throw Failure("EGL does not start");
    eglBindAPI(EGL_OPENGL_API);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE)
        throw Failure("EGL has no OpenGL 4.5");
}

/// A plastic sphere under a clear sky.
nicol_scene make_scene(nicol_context context) {
    nicol_sky sky = NICOL_SKY_INIT;
    sky.sun_direction[0] = 1;
    nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
    plastic.alpha = 0.3F;
    nicol_instance instance = NICOL_INSTANCE_INIT;
    nicol_environment environment = nullptr;
    nicol_scene scene = nullptr;
    check(nicol_environment_create_sky(context, &sky, &environment));
    check(nicol_material_create_pplastic(context, &plastic, &instance.material));
    check(nicol_mesh_create_sphere(context, &instance.mesh));
    check(nicol_scene_create(context, &scene));
    check(nicol_scene_add_instance(scene, &instance, nullptr));
    check(nicol_scene_set_environment(scene, environment, nullptr, 1));
    nicol_mesh_release(instance.mesh);
    nicol_material_release(instance.material);
    nicol_environment_release(environment);
    return scene;
}

int run() {
    make_current();
    nicol_host host = NICOL_HOST_INIT;
    host.get_proc_address = [](void*, const char* name) {
        return reinterpret_cast<void*>(eglGetProcAddress(name));
    };
    host.is_current = [](void*) { return eglGetCurrentContext() != EGL_NO_CONTEXT ? 1 : 0; };
    nicol_context context = nullptr;
    check(nicol_context_create_host(&host, nullptr, &context));
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    check(nicol_context_get_info(context, &info));
    if (*info.device_uuid == '\0') throw NotShared("this OpenGL has no GL_EXT_memory_object");

    const VulkanDevice device(info.device_uuid);
    std::vector<std::unique_ptr<SharedImage>> images;
    std::vector<std::uint32_t> textures;
    for (std::uint32_t c = 0; c < kChannels; ++c) {
        images.push_back(std::make_unique<SharedImage>(device, kSize, kSize));
        textures.push_back(images.back()->texture());
    }
    nicol_framebuffer framebuffer = nullptr;
    check(nicol_framebuffer_create_textures(context, textures.data(), kChannels, &framebuffer));

    const nicol_scene scene = make_scene(context);
    nicol_camera camera = NICOL_CAMERA_INIT;
    const double origin[3] = {0, 1, 4}, target[3] = {0, 0, 0}, up[3] = {0, 1, 0};
    check(nicol_camera_look_at(&camera, origin, target, up));
    check(nicol_render(scene, &camera, nullptr, framebuffer));
    // Drivers that have GL_EXT_semaphore_fd let Vulkan wait instead.
    glFinish();

    bool equal = true;
    std::vector<float> rendered(std::size_t{4} * kSize * kSize);
    for (std::uint32_t c = 0; c < kChannels; ++c) {
        check(nicol_framebuffer_read(framebuffer, NICOL_PLANE_STOKES, c, rendered.data(), 0,
                                     rendered.size() * sizeof(float)));
        equal = equal && images[c]->texels() == rendered;
    }
    const float* const middle = rendered.data() + std::size_t{4} * (kSize / 2 * kSize + kSize / 2);
    std::cout << device.name() << ": Vulkan sees " << (equal ? "the Stokes vectors that" : "others than")
              << " Nicol rendered; s0 " << middle[0] << ", s1 " << middle[1] << " in the middle\n";
    nicol_framebuffer_release(framebuffer);
    nicol_scene_release(scene);
    nicol_context_release(context);
    return equal ? 0 : 1;
}

}  // namespace

int main() {
    try {
        return run();
    } catch (const NotShared& reason) {
        std::cerr << "nicol-vulkan: skipped: " << reason.what() << '\n';
        return 77;
    } catch (const Failure& failure) {
        std::cerr << "nicol-vulkan: " << failure.what() << '\n';
        return 2;
    }
}
