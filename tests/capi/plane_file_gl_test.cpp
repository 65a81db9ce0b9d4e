// SPDX-License-Identifier: MIT
// Tests of surface planes in OpenEXR files.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include "image/stokes_image.hpp"
#include "planes.hpp"

using namespace capi_test;

namespace {

template <class Number>
std::vector<Number> channel(const std::string& path, const char* name) {
    Imf::InputFile file(path.c_str());
    const Imf::Channel* found = file.header().channels().findChannel(name);
    REQUIRE(found != nullptr);
    constexpr Imf::PixelType type = std::is_same_v<Number, float> ? Imf::FLOAT : Imf::UINT;
    CHECK(found->type == type);
    const Imath::Box2i window = file.header().dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x + 1);
    std::vector<Number> pixels(width * static_cast<std::size_t>(window.max.y + 1));
    Imf::FrameBuffer buffer;
    buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(pixels.data()), sizeof(Number),
                                   width * sizeof(Number)));
    file.setFrameBuffer(buffer);
    file.readPixels(0, window.max.y);
    return pixels;
}

}  // namespace

STAGE_TEST_CASE("planes of surfaces in an image are those that are read, and leave the others as they are") {
    const TemporaryFolder folder;
    const std::string bare = folder.file("bare.exr"), full = folder.file("full.exr");
    stage.render();
    OK(nicol_framebuffer_write_exr(stage.framebuffer, bare.c_str()));
    nicol_render_options options = plain_options();
    options.aovs = NICOL_AOV_ALL;
    OK(stage.try_render(options));
    OK(nicol_framebuffer_write_exr(stage.framebuffer, full.c_str()));
    const Surfaces seen(stage.framebuffer);
    CHECK(channel<float>(full, "Z") == seen.depth);
    CHECK(channel<float>(full, "A") == seen.alpha);
    CHECK(channel<std::uint32_t>(full, "id") == seen.instance);
    const char* axes[] = {"X", "Y", "Z"};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<float> normal = channel<float>(full, (std::string("N.") + axes[k]).c_str());
        const std::vector<float> position = channel<float>(full, (std::string("P.") + axes[k]).c_str());
        for (std::size_t i = 0; i < normal.size(); ++i) {
            CHECK(normal[i] == seen.normal[3 * i + k]);
            CHECK(position[i] == seen.position[3 * i + k]);
        }
    }
    CHECK(nicol::read_exr(full).data == nicol::read_exr(bare).data);
}

STAGE_TEST_CASE("the variance is in an image by channel and component, and leaves the others as they are") {
    const TemporaryFolder folder;
    const std::string file = folder.file("variance.exr");
    const Owned grey(framebuffer_of(stage.context, 24, 16, 1));
    const nicol_render_options options = with_variance();
    OK(stage.try_render(options));
    OK(nicol_render(stage.scene, &stage.camera, &options, grey));
    for (const auto& [framebuffer, colours] :
         {std::pair<nicol_framebuffer, std::string>(stage.framebuffer, "RGB"), {grey, "Y"}}) {
        OK(nicol_framebuffer_write_exr(framebuffer, file.c_str()));
        for (std::uint32_t c = 0; c < colours.size(); ++c) {
            const std::vector<float> variance = read_plane(framebuffer, NICOL_PLANE_VARIANCE, c);
            for (std::size_t p = 0; p < 4; ++p) {
                const std::string name = "variance.S" + std::to_string(p) + "." + colours[c];
                const std::vector<float> stored = channel<float>(file, name.c_str());
                for (std::size_t i = 0; i < stored.size(); ++i) CHECK(stored[i] == variance[4 * i + p]);
            }
        }
        CHECK(nicol::read_exr(file).channels == static_cast<int>(colours.size()));
        CHECK(channel<float>(file, ("S0." + colours.substr(0, 1)).c_str()) ==
              read_plane(framebuffer, NICOL_PLANE_S0, 0));
    }
}
