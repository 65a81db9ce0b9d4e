// SPDX-License-Identifier: MIT
// Tests of files in the caller's memory: what is read and written there equals what is read and written on
// disk, and the file system is left alone.
#include <map>
#include <string_view>

#include "capi.hpp"
#include "files/bomb.hpp"

using namespace capi_test;

namespace {

using Strings = std::vector<std::string>;

/// Files in memory by their names, and the names that were asked for.
struct Bundle {
    std::map<std::string, std::string> files;
    Strings asked{};

    /// Returns the file with this content, and the bundle as its resolver.
    nicol_memory_file of(const std::string& content, const char* name = nullptr) {
        nicol_memory_file file = NICOL_MEMORY_FILE_INIT;
        file.name = name;
        file.bytes = content.data();
        file.byte_size = content.size();
        file.resolve_user = this;
        file.resolve = [](void* user, const char* wanted, nicol_file_content* found) -> std::int32_t {
            auto& self = *static_cast<Bundle*>(user);
            self.asked.emplace_back(wanted);
            const auto entry = self.files.find(wanted);
            if (entry == self.files.end()) return 0;
            CHECK(found->struct_size == sizeof *found);
            found->bytes = entry->second.data();
            found->byte_size = entry->second.size();
            return 1;
        };
        return file;
    }
};

std::string asset(const std::string& name) {
    std::ifstream in(NICOL_TEST_ASSETS "/" + name, std::ios::binary);
    REQUIRE(in);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Returns the scene's image at a small size.
std::vector<float> image_of(nicol_context context, nicol_scene scene) {
    nicol_camera camera = NICOL_CAMERA_INIT;
    OK(nicol_scene_get_camera(scene, &camera));
    std::uint32_t channels = 0;
    OK(nicol_scene_get_channels(scene, &channels));
    const Owned framebuffer(framebuffer_of(context, 24, 16, channels));
    nicol_render_options options = plain_options();
    options.shade_at = NICOL_SHADE_AT_AUTOMATIC;
    OK(nicol_render(scene, &camera, &options, framebuffer));
    return read_all(framebuffer);
}

std::array<std::uint32_t, 2> size_of(nicol_mesh mesh) {
    std::array<std::uint32_t, 2> size{};
    OK(nicol_mesh_get_size(mesh, &size[0], &size[1]));
    return size;
}

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string scene_with(const std::string& shapes) {
    return "<scene version='3.0.0'><sensor type='perspective'><float name='fov' value='50'/></sensor>" +
           shapes + "</scene>";
}

std::string obj_shape(const std::string& file) {
    return "<shape type='obj'><string name='filename' value='" + file + "'/></shape>";
}

/// A binary STL file of one triangle, whose comment looks like that of a text.
std::string binary_stl() {
    std::string bytes(84 + 50, '\0');
    bytes.replace(0, 5, "solid");
    bytes[80] = 1;
    const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::memcpy(&bytes[84 + 12], corners, sizeof corners);
    return bytes;
}

}  // namespace

TEST_CASE("scenes in memory give the image of the files, and ask for each name once") {
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    struct Case {
        const char* scene;
        Strings names;
    };
    for (const Case& c :
         {Case{"solids.gltf", {}},
          Case{"textured.gltf",
               {"textured.bin", "tiles_color.png", "tiles_normals.png", "tiles_roughness.png"}},
          Case{"snail_textured.xml", {"forest_blurred.exr", "snail.ply", "plinth.ply", "tiles_color.png"}}}) {
        CAPTURE(std::string(c.scene));
        const std::string path = NICOL_TEST_ASSETS "/" + std::string(c.scene);
        const Owned on_disk(make(nicol_scene_load, context, path.c_str(), nullptr, 0U));
        Bundle bundle;
        for (const char* const name :
             {"textured.bin", "tiles_color.png", "tiles_normals.png", "tiles_roughness.png",
              "bands_color.png", "bands_surface.png", "forest_blurred.exr", "plinth.ply", "snail.ply"})
            bundle.files[std::string("far/") + name] = asset(name);
        const std::string content = asset(c.scene), name = "far/" + std::string(c.scene);
        const nicol_memory_file file = bundle.of(content, name.c_str());
        const Owned in_memory(make(nicol_scene_load_memory, context, &file, nullptr, 0U));
        CHECK(image_of(context, in_memory) == image_of(context, on_disk));
        Strings asked = bundle.asked;
        std::ranges::sort(asked);
        CHECK(std::ranges::adjacent_find(asked) == asked.end());
        for (const std::string& wanted : c.names)
            CHECK(std::ranges::find(asked, "far/" + wanted) != asked.end());
        std::uint32_t files = 0, files_on_disk = 0;
        OK(nicol_scene_get_file_count(in_memory, &files));
        OK(nicol_scene_get_file_count(on_disk, &files_on_disk));
        CHECK(files == files_on_disk);
        nicol_scene_file first = NICOL_SCENE_FILE_INIT, first_on_disk = NICOL_SCENE_FILE_INIT;
        OK(nicol_scene_get_file(in_memory, 0, &first));
        OK(nicol_scene_get_file(on_disk, 0, &first_on_disk));
        CHECK(std::string(first.path) == name);
        CHECK(std::string(first.digest) == first_on_disk.digest);
    }
}

TEST_CASE("the suffix of the name says a file's format, and the content if there is no suffix") {
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    struct Case {
        const char* name;
        std::string content;
        std::array<std::uint32_t, 2> size;
    };
    const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    const std::string ply = asset("plinth.ply");
    const std::string text_stl =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\n"
        "endsolid\n";
    const Owned plinth(make(nicol_mesh_load, context, NICOL_TEST_ASSETS "/plinth.ply"));
    for (const Case& c :
         {Case{nullptr, kObj, {3, 1}}, Case{"", kObj, {3, 1}}, Case{"models/tri", kObj, {3, 1}},
          Case{"a.OBJ", kObj, {3, 1}}, Case{nullptr, off, {3, 1}}, Case{nullptr, binary_stl(), {3, 1}},
          Case{nullptr, "o part" + binary_stl().substr(6), {3, 1}}, Case{nullptr, text_stl, {3, 1}},
          Case{nullptr, ply, size_of(plinth)}, Case{"b.ply", ply, size_of(plinth)}}) {
        const nicol_memory_file file = Bundle().of(c.content, c.name);
        const Owned mesh(make(nicol_mesh_load_memory, context, &file));
        CHECK(size_of(mesh) == c.size);
    }
    nicol_mesh mesh = nullptr;
    const nicol_memory_file wrong = Bundle().of(kObj, "models/a.ply");
    FAILS(nicol_mesh_load_memory(context, &wrong, &mesh), NICOL_ERROR_INVALID_FILE, "models/a.ply");
    const nicol_memory_file unknown = Bundle().of(std::string(8, '\1'), "blob");
    FAILS(nicol_mesh_load_memory(context, &unknown, &mesh), NICOL_ERROR_UNSUPPORTED, "blob");
    const nicol_memory_file nothing = Bundle().of("");
    FAILS(nicol_mesh_load_memory(context, &nothing, &mesh), NICOL_ERROR_UNSUPPORTED, "memory");
    for (const char* name : {"bands_color.png", "forest_blurred.exr"}) {
        const std::string content = asset(name);
        const nicol_memory_file file = Bundle().of(content);
        const Owned texture(make(nicol_texture_load_memory, context, &file, nullptr));
        const Owned light(make(nicol_environment_load_memory, context, &file, nullptr));
    }
    const nicol_memory_file image = Bundle().of(ply);
    nicol_texture texture = nullptr;
    FAILS(nicol_texture_load_memory(context, &image, nullptr, &texture), NICOL_ERROR_UNSUPPORTED,
          "memory.ply");
}

TEST_CASE("light and materials in memory equal those of the files") {
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    const TemporaryFolder folder;
    const Owned sky(clear_sky(context));
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.edge = 8;
    OK(nicol_environment_write(sky, &options, folder.file("sky_s0.exr").c_str()));
    Bundle bundle;
    for (const char* part : {"0", "1", "2", "3"})
        bundle.files["sky_s" + std::string(part) + ".exr"] =
            file_bytes(folder.file("sky_s" + std::string(part) + ".exr"));
    const nicol_memory_file cross = bundle.of(bundle.files["sky_s0.exr"], "sky_s0.exr");
    const Owned light(make(nicol_environment_load_memory, context, &cross, nullptr));
    nicol_environment_info info = NICOL_ENVIRONMENT_INFO_INIT;
    OK(nicol_environment_get_info(light, &info));
    CHECK(info.polarized == 1);
    CHECK(bundle.asked == Strings{"sky_s1.exr", "sky_s2.exr", "sky_s3.exr"});
    bundle.files.erase("sky_s2.exr");
    nicol_environment none = nullptr;
    FAILS(nicol_environment_load_memory(context, &cross, nullptr, &none), NICOL_ERROR_FILE_NOT_FOUND,
          "sky_s2.exr");

    const Owned grey(diffuse(context, {0.25F}));
    nicol_file_options order = NICOL_FILE_OPTIONS_INIT;
    order.order = 3;
    const std::string written = folder.file("grey.npz"), again = folder.file("again.npz");
    OK(nicol_material_write(grey, &order, written.c_str()));
    const std::string bytes = file_bytes(written);
    const nicol_memory_file file = Bundle().of(bytes);
    const Owned from_memory(make(nicol_material_load_psh_memory, context, &file, nullptr));
    const Owned from_disk(make(nicol_material_load_psh, context, written.c_str(), nullptr));
    OK(nicol_material_write(from_disk, &order, written.c_str()));
    OK(nicol_material_write(from_memory, &order, again.c_str()));
    CHECK(file_bytes(again) == file_bytes(written));
    nicol_material material = nullptr;
    FAILS(nicol_material_load_measured_memory(context, &file, nullptr, &material), NICOL_ERROR_INVALID_FILE,
          "memory.npz");
}

TEST_CASE("nothing is read from the file system, and what is missing is named with its place") {
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    const TemporaryFolder folder;
    folder.write("there.obj", kObj);
    folder.write("there.xml", scene_with(obj_shape("there.obj")));
    const std::string name = folder.file("scene.xml");
    nicol_scene scene = nullptr;
    const auto refuses = [&](const std::string& content, const std::string& text) {
        Bundle bundle;
        const nicol_memory_file file = bundle.of(content, name.c_str());
        FAILS(nicol_scene_load_memory(context, &file, nullptr, 0, &scene), NICOL_ERROR_FILE_NOT_FOUND, text);
        nicol_memory_file alone = file;
        alone.resolve = nullptr;
        FAILS(nicol_scene_load_memory(context, &alone, nullptr, 0, &scene), NICOL_ERROR_FILE_NOT_FOUND, text);
    };
    refuses(scene_with(obj_shape("there.obj")), folder.file("there.obj") + ": no such file");
    refuses(scene_with(obj_shape(folder.file("there.obj"))), folder.file("there.obj") + ": no such file");
    refuses(scene_with("\n<include filename='there.xml'/>"), name + ":2: <include>");
    refuses(
        scene_with("<emitter type='envmap'><string name='filename' value='/etc/hostname.exr'/></emitter>" +
                   obj_shape("there.obj")),
        "/etc/hostname.exr");
    const std::string textured = asset("textured.gltf");
    Bundle nothing;
    const nicol_memory_file gltf = nothing.of(textured, NICOL_TEST_ASSETS "/textured.gltf");
    FAILS(nicol_scene_load_memory(context, &gltf, nullptr, 0, &scene), NICOL_ERROR_FILE_NOT_FOUND,
          "textured.bin");
    CHECK(scene == nullptr);
}

TEST_CASE("names reach the resolver without dots, and includes may not go in a circle") {
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    Bundle bundle{{{"models/a.obj", kObj},
                   {"rooms/parts/b.xml", scene_with(obj_shape("../../models/a.obj"))},
                   {"rooms/circle.xml", scene_with("<include filename='circle.xml'/>")}}};
    const std::string hall =
        scene_with("<path value='./parts'/><include filename='b.xml'/>" + obj_shape("../models/./a.obj"));
    const nicol_memory_file file = bundle.of(hall, "rooms/hall.xml");
    const Owned scene(make(nicol_scene_load_memory, context, &file, nullptr, 0U));
    for (const std::string& name : bundle.asked) {
        CAPTURE(name);
        CHECK(std::filesystem::path(name).lexically_normal() == name);
    }
    CHECK(std::ranges::find(bundle.asked, "rooms/parts/b.xml") != bundle.asked.end());
    CHECK(std::ranges::find(bundle.asked, "models/a.obj") != bundle.asked.end());
    std::uint32_t instances = 0;
    OK(nicol_scene_get_instance_count(scene, &instances));
    CHECK(instances == 2);
    const std::string circle = scene_with("<include filename='circle.xml'/>");
    const nicol_memory_file round = bundle.of(circle, "rooms/circle.xml");
    nicol_scene none = nullptr;
    FAILS(nicol_scene_load_memory(context, &round, nullptr, 0, &none), NICOL_ERROR_INVALID_FILE, "circle");
}

TEST_CASE("the limits of a context hold for files in memory") {
    nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
    options.load_bytes_limit = 1 << 20;
    const Owned context(make(nicol_context_create, &options));
    Bundle bundle{{{"bomb.png", black_png(16384, 8192, 1, 8192 * 2049ULL)},
                   {"long.obj", kObj + std::string((1 << 20) - 100, '\n')}}};
    const nicol_memory_file image = bundle.of(bundle.files["bomb.png"]);
    nicol_texture texture = nullptr;
    FAILS(nicol_texture_load_memory(context, &image, nullptr, &texture), NICOL_ERROR_UNSUPPORTED,
          "load_bytes_limit");
    // Files that the resolver gives count as well.
    const std::string twice = scene_with(obj_shape("long.obj") + obj_shape("long.obj"));
    const nicol_memory_file once = bundle.of(twice, "a.xml");
    const Owned scene(make(nicol_scene_load_memory, context, &once, nullptr, 0U));
    bundle.files["longer.obj"] = bundle.files["long.obj"];
    const std::string both = scene_with(obj_shape("long.obj") + obj_shape("longer.obj"));
    const nicol_memory_file too_much = bundle.of(both, "a.xml");
    nicol_scene none = nullptr;
    FAILS(nicol_scene_load_memory(context, &too_much, nullptr, 0, &none), NICOL_ERROR_UNSUPPORTED,
          "load_bytes_limit");
}

TEST_CASE("what a resolver sets is checked") {
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    const std::string content = scene_with(obj_shape("a.obj"));
    nicol_memory_file file = Bundle().of(content, "a.xml");
    nicol_scene scene = nullptr;
    file.resolve = [](void*, const char*, nicol_file_content* found) -> std::int32_t {
        found->byte_size = 10;
        return 1;
    };
    REFUSES(nicol_scene_load_memory(context, &file, nullptr, 0, &scene), "content->bytes is NULL");
    file.resolve = [](void*, const char*, nicol_file_content* found) -> std::int32_t {
        found->struct_size = 3;
        return 1;
    };
    REFUSES(nicol_scene_load_memory(context, &file, nullptr, 0, &scene), "content->struct_size is 3");
    file.resolve = [](void*, const char*, nicol_file_content*) -> std::int32_t { return 1; };
    FAILS(nicol_scene_load_memory(context, &file, nullptr, 0, &scene), NICOL_ERROR_INVALID_FILE, "a.obj");
    file.reserved = 1;
    REFUSES(nicol_scene_load_memory(context, &file, nullptr, 0, &scene), "file->reserved");
    nicol_memory_file none = NICOL_MEMORY_FILE_INIT;
    none.byte_size = 5;
    REFUSES(nicol_scene_load_memory(context, &none, nullptr, 0, &scene), "file->bytes is NULL");
}

CONTEXT_TEST_CASE("images in memory have the bytes of the files") {
    const TemporaryFolder folder;
    const Owned light(clear_sky(context));
    const Owned mesh(sphere(context));
    const Owned material(plastic_of(context));
    const Owned scene(simple_scene(context, light, mesh, material));
    const Owned framebuffer(framebuffer_of(context, 640, 480, 3));
    const nicol_camera camera = front_camera();
    nicol_render_options options = plain_options();
    options.aovs = NICOL_AOV_DEPTH | NICOL_AOV_INSTANCE;
    OK(nicol_render(scene, &camera, &options, framebuffer));
    struct Sink {
        std::string bytes;
        int calls = 0, most = 1 << 30;

        static std::int32_t take(void* user, const void* bytes, std::uint64_t size) {
            auto& self = *static_cast<Sink*>(user);
            self.bytes.append(static_cast<const char*>(bytes), size);
            return ++self.calls < self.most ? 1 : 0;
        }
    };
    const auto bytes_of = [&](const auto& encode) {
        Sink sink;
        OK(encode(Sink::take, &sink));
        Sink short_sink{.most = 1};
        FAILS(encode(Sink::take, &short_sink), NICOL_ERROR_WRITE_FAILED, "sink");
        CHECK(short_sink.calls == 1);
        CHECK(sink.bytes.starts_with(short_sink.bytes));
        REFUSES(encode(static_cast<nicol_sink_callback>(nullptr), nullptr), "sink is NULL");
        return sink;
    };
    const std::string exr = folder.file("a.exr"), png = folder.file("a.png");
    OK(nicol_framebuffer_write_exr(framebuffer, exr.c_str()));
    const Sink encoded = bytes_of([&](nicol_sink_callback sink, void* user) {
        return nicol_framebuffer_encode_exr(framebuffer, sink, user);
    });
    CHECK(encoded.bytes == file_bytes(exr));
    CHECK(encoded.calls > 1);
    for (const nicol_observation_kind kind :
         {NICOL_OBSERVATION_S0, NICOL_OBSERVATION_S1, NICOL_OBSERVATION_AOLP}) {
        nicol_observation observation = NICOL_OBSERVATION_INIT;
        observation.kind = kind;
        OK(nicol_framebuffer_write_png(framebuffer, &observation, png.c_str()));
        CHECK(bytes_of([&](nicol_sink_callback sink, void* user) {
                  return nicol_framebuffer_encode_png(framebuffer, &observation, sink, user);
              }).bytes == file_bytes(png));
    }
}
