// SPDX-License-Identifier: MIT
// Tests of rules that hold for every function of nicol.h: refusals, and failing calls that write nothing.
// Each argument of each function is made wrong in every way that its type allows.
#include "contract.hpp"

using namespace capi_test;

namespace {

/// Arguments that may be NULL, as "function.parameter".
const std::set<std::string> optional = {
    "nicol_context_create.options",
    "nicol_context_create_host.options",
    "nicol_context_set_log.log",
    "nicol_environment_load.options",
    "nicol_environment_load_memory.options",
    "nicol_environment_create_constant.radiance",
    "nicol_texture_create_image.options",
    "nicol_texture_load.options",
    "nicol_texture_load_memory.options",
    "nicol_texture_create_checkerboard.color0",
    "nicol_texture_create_checkerboard.color1",
    "nicol_texture_create_checkerboard.to_uv",
    "nicol_material_create_diffuse.reflectance",
    "nicol_material_load_measured.options",
    "nicol_material_load_measured_memory.options",
    "nicol_material_load_psh.options",
    "nicol_material_load_psh_memory.options",
    "nicol_material_create_rotated.directions",
    "nicol_scene_load.definitions",
    "nicol_scene_load_memory.definitions",
    "nicol_scene_add_instance.id",
    "nicol_scene_get_instance.mesh",
    "nicol_scene_get_instance.material",
    "nicol_scene_get_instance.to_world",
    "nicol_scene_get_instance_ids.ids",
    "nicol_scene_add_light.id",
    "nicol_scene_get_light.texture",
    "nicol_scene_get_light_ids.ids",
    "nicol_scene_add_polarization_element.id",
    "nicol_scene_get_polarization_element_textures.angle",
    "nicol_scene_get_polarization_element_textures.retardance",
    "nicol_scene_get_polarization_element_ids.ids",
    "nicol_scene_set_emission.emission",
    "nicol_scene_get_emission.texture",
    "nicol_scene_set_environment.environment",
    "nicol_scene_set_environment.to_world",
    "nicol_scene_get_environment.to_world",
    "nicol_scene_get_environment.scale",
    "nicol_render.options",
    "nicol_render_adjoint.options",
    "nicol_render_async.options",
    "nicol_render_views.options",
    "nicol_psh_project_file.channels",
    "nicol_file_describe_light.options",
    "nicol_file_describe_material.options",
    "nicol_file_convert.options",
    "nicol_environment_write.options",
    "nicol_material_write.options",
};

bool is_release(const Function& f) {
    return f.name.ends_with("_release");
}

/// Returns whether the function needs a host's context. Other contexts refuse it before its arguments are
/// read. The tests in tests/host cover such functions.
bool needs_host(const Function& f) {
    return f.name == "nicol_framebuffer_get_texture" || f.name.starts_with("nicol_framebuffer_draw_");
}

/// Returns whether the function sets the defaults of a struct, whose size is an argument.
bool is_initialiser(const Function& f) {
    return f.name.ends_with("_init");
}

/// Calls test(function, position) for every parameter of these kinds.
template <class Test>
void each_parameter(std::initializer_list<Kind> kinds, Test test) {
    int tested = 0;
    for (const Function& f : functions())
        for (std::size_t i = 0; i < f.parameters.size(); ++i) {
            if (std::ranges::find(kinds, f.parameters[i].kind) == kinds.end()) continue;
            CAPTURE(f.name);
            CAPTURE(f.parameters[i].name);
            test(f, i);
            ++tested;
        }
    CHECK(tested >= 10);
}

/// Checks that every function refuses this value in place of a live handle of the type.
void check_no_handle(const Everything& all, std::size_t type, Slot value, const std::string& message) {
    each_parameter({Kind::handle}, [&](const Function& f, std::size_t i) {
        const bool null_allowed = is_release(f) || optional.contains(f.name + "." + f.parameters[i].name);
        if (f.parameters[i].type != type || (value == 0 && null_allowed)) return;
        Arguments arguments(f, all);
        arguments.set(i, value);
        FAILS(arguments.call(), NICOL_ERROR_INVALID_HANDLE, handle_names[type]);
        FAILS(arguments.call(), NICOL_ERROR_INVALID_HANDLE, message);
    });
}

void set_size(std::vector<std::byte>& bytes, std::size_t size) {
    const auto stored = static_cast<std::uint32_t>(size);
    std::memcpy(bytes.data(), &stored, sizeof stored);
}

}  // namespace

CONTEXT_TEST_CASE("every function refuses what is no live handle of the type") {
    const Everything all(retained(context));
    Everything gone(make_context(NICOL_BACKEND_OSMESA));
    for (std::size_t type = 0; type < all.handles.size(); ++type) {
        check_no_handle(all, type, 0, "NULL");
        check_no_handle(all, type, Everything::slot(marker<void*>()), "never created");
        for (std::size_t other = 0; other < all.handles.size(); ++other)
            if (other != type)
                check_no_handle(all, type, all.handles[other], std::string("a ") + handle_names[other]);
    }
    // Nothing else is created from here on, because addresses of released handles may be used again.
    gone.release_all();
    for (std::size_t type = 0; type < all.handles.size(); ++type)
        check_no_handle(all, type, gone.handles[type], "released");
}

CONTEXT_TEST_CASE(
    "a handle lives until each of its references is released, and releasing NULL does nothing") {
    Everything all(retained(context));
    all.released = true;  // released by hand below
    for (std::size_t type = all.handles.size(); type-- > 0;) {
        CAPTURE(handle_names[type]);
        const Slot null = 0;
        OK(function(std::string(handle_names[type]) + "_release").call(&null));
        for (int n = 0; n < 5; ++n) OK(all.retain(type));
        for (int n = 0; n < 5; ++n) OK(all.release(type));
        OK(all.retain(type));  // still alive
        OK(all.release(type));
        OK(all.release(type));
        if (type == 0) continue;  // on_every_backend has another reference
        FAILS(all.retain(type), NICOL_ERROR_INVALID_HANDLE, "released");
        FAILS(all.release(type), NICOL_ERROR_INVALID_HANDLE, "released");
    }
}

TEST_CASE("every function refuses NULL for what it needs, by name") {
    const Everything all(make_context(NICOL_BACKEND_OSMESA));
    each_parameter({Kind::new_handle, Kind::struct_in, Kind::struct_out, Kind::text, Kind::input,
                    Kind::output, Kind::callback},
                   [&](const Function& f, std::size_t i) {
                       if (needs_host(f) || optional.contains(f.name + "." + f.parameters[i].name)) return;
                       Arguments arguments(f, all);
                       arguments.set(i, 0);
                       REFUSES(arguments.call(), std::string(f.parameters[i].name) + " is NULL");
                   });
}

CONTEXT_TEST_CASE(
    "structs of older and newer callers are read, and those without a size or with unknown fields refused") {
    const Everything all(retained(context));
    each_parameter({Kind::struct_in}, [&](const Function& f, std::size_t i) {
        if (needs_host(f)) return;
        const Parameter& parameter = f.parameters[i];
        const std::string name = parameter.name;
        // A size that ends inside a number is that of no version.
        const auto inside = static_cast<std::uint32_t>(parameter.size - 1);
        for (const std::uint32_t size : {0U, 1U, 3U, inside, 65537U, UINT32_MAX}) {
            Arguments arguments(f, all);
            set_size(arguments.memory(i), size);
            REFUSES(arguments.call(), name + "->struct_size");
        }
        const auto outcome = [&](std::vector<std::byte> bytes) {
            set_size(bytes, bytes.size());
            Arguments arguments(f, all);
            arguments.point(i, std::move(bytes));
            const nicol_result result = arguments.call();
            return std::pair(result, std::string(result == NICOL_OK ? "" : nicol_last_error()));
        };
        std::vector<std::byte> newer = parameter.good;
        newer.resize(parameter.size + 24);
        CHECK(outcome(newer) == outcome(parameter.good));
        for (const std::size_t at : {parameter.size, parameter.size + 11, parameter.size + 23}) {
            std::vector<std::byte> unknown = newer;
            unknown[at] = std::byte{1};
            const auto [result, message] = outcome(unknown);
            CHECK(result == NICOL_ERROR_INVALID_ARGUMENT);
            CHECK(message.find(name + " has fields set") != std::string::npos);
        }
        // Fields that an older caller's struct lacks get their defaults.
        for (std::size_t size = 8; size < parameter.size; size += 8) {
            const auto cut = static_cast<std::ptrdiff_t>(size);
            const std::vector<std::byte> older(parameter.good.begin(), parameter.good.begin() + cut);
            std::vector<std::byte> whole = older;
            whole.insert(whole.end(), parameter.initial.begin() + cut, parameter.initial.end());
            CHECK(outcome(older) == outcome(whole));
        }
    });
}

CONTEXT_TEST_CASE(
    "structs are filled as far as the caller has room and say how far, and those without a size stay") {
    const Everything all(retained(context));
    each_parameter({Kind::struct_out}, [&](const Function& f, std::size_t i) {
        if (needs_host(f) || is_initialiser(f)) return;
        constexpr std::array also_read{"nicol_camera_look_at",     "nicol_camera_set_opencv",
                                       "nicol_camera_frame",       "nicol_sensor_load",
                                       "nicol_sensor_load_memory", "nicol_sensor_add_element",
                                       "nicol_sensor_set_preset",  "nicol_render_options_set_quality"};
        if (std::ranges::find(also_read, f.name) != also_read.end()) return;
        const std::size_t whole_size = f.parameters[i].size;
        for (const std::size_t size : {std::size_t{0}, std::size_t{3}, whole_size - 1}) {
            Arguments arguments(f, all);
            std::ranges::fill(arguments.memory(i), std::byte{0x7e});
            set_size(arguments.memory(i), size);
            REFUSES(arguments.call(), std::string(f.parameters[i].name) + "->struct_size");
        }
        const auto filled = [&](std::size_t size) {
            Arguments arguments(f, all);
            std::vector<std::byte> room(size, std::byte{77});
            set_size(room, size);
            arguments.point(i, std::move(room));
            OK(arguments.call());
            std::uint32_t left = 0;
            std::memcpy(&left, arguments.memory(i).data(), sizeof left);
            CHECK(left == std::min(size, whole_size));
            return arguments.memory(i);
        };
        const std::vector<std::byte> whole = filled(whole_size), newer = filled(whole_size + 8);
        const std::vector<std::byte> older = filled(8);
        CHECK(std::equal(older.begin() + 4, older.end(), whole.begin() + 4));
        CHECK(std::equal(whole.begin() + 4, whole.end(), newer.begin() + 4));
        for (std::size_t at = whole_size; at < newer.size(); ++at) CHECK(newer[at] == std::byte{77});
    });
}

TEST_CASE("initialisers set the defaults of the macros, for structs of older and newer callers too") {
    const Everything all(make_context(NICOL_BACKEND_OSMESA));
    each_parameter({Kind::struct_out}, [&](const Function& f, std::size_t i) {
        if (!is_initialiser(f)) return;
        const Parameter& parameter = f.parameters[i];
        for (const std::size_t size : {parameter.size, parameter.size + 8, std::size_t{8}}) {
            std::vector<std::byte> expected = parameter.initial;
            expected.resize(size);
            set_size(expected, size);
            Arguments arguments(f, all);
            arguments.point(i, std::vector<std::byte>(size, std::byte{77}));
            arguments.set(i + 1, size);
            OK(arguments.call());
            CHECK(arguments.memory(i) == expected);
        }
        const auto inside = static_cast<std::uint32_t>(parameter.size - 1);
        for (const std::uint32_t size : {0U, 3U, inside, 65537U, UINT32_MAX}) {
            Arguments arguments(f, all);
            arguments.set(i + 1, size);
            REFUSES(arguments.call(), "struct_size is " + std::to_string(size));
        }
    });
    nicol_spectrum spectrum;
    std::memset(&spectrum, 77, sizeof spectrum);
    OK(nicol_spectrum_init(&spectrum, sizeof spectrum));
    CHECK(spectrum.count == 0);
    CHECK(spectrum.values[NICOL_MAX_CHANNELS - 1] == 0);
    nicol_film film;
    OK(nicol_film_init(&film, sizeof film));
    CHECK(film.thickness == 0);
    CHECK(film.eta == 1.5F);
    nicol_polarization polarization;
    // Doubles are not cut at their half.
    nicol_camera camera = NICOL_CAMERA_INIT;
    REFUSES(nicol_camera_init(&camera, sizeof camera - 4),
            "struct_size is " + std::to_string(sizeof camera - 4));
    OK(nicol_polarization_init(&polarization, sizeof polarization));
    CHECK(polarization.axis[0] == 1);
    REFUSES(nicol_polarization_init(&polarization, 8), "struct_size is 8; it must be sizeof(the struct), 48");
}

TEST_CASE("arrays of doubles must have the length that orders and vectors ask for, and finite values") {
    const Everything all(make_context(NICOL_BACKEND_OSMESA));
    each_parameter({Kind::input, Kind::output}, [&](const Function& f, std::size_t i) {
        const std::size_t length = f.count_of(i);
        const std::string name = f.parameters[i].name;
        const bool other = f.name.ends_with("_ids") || f.name.starts_with("nicol_scene_load");
        if (length == 0 || other || name == "energy" || name == "weight") return;
        REQUIRE(Arguments(f, all).call() == NICOL_OK);
        const Slot good = Arguments(f, all)[length];
        std::vector<Slot> lengths = {0, good - 1, good + 1, 2 * good, UINT64_MAX, UINT64_MAX / 8 + 1};
        // Directions and angles may have any number that memory can hold.
        if (name == "directions") lengths = {good - 1, good + 1, UINT64_MAX};
        if (name == "theta" && f.parameters[i].kind == Kind::input) lengths = {UINT64_MAX};
        for (const Slot wrong : lengths) {
            Arguments arguments(f, all);
            arguments.set(length, wrong);
            REFUSES(arguments.call(), "length of " + name);
        }
        if (f.parameters[i].kind == Kind::output) return;
        for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL})
            for (const Slot at : {Slot{0}, good / 2, good - 1}) {
                Arguments arguments(f, all);
                std::memcpy(arguments.memory(i).data() + at * sizeof wrong, &wrong, sizeof wrong);
                REFUSES(arguments.call(), name + "[" + std::to_string(at) + "]");
            }
    });
}

TEST_CASE("orders have a limit") {
    const Everything all(make_context(NICOL_BACKEND_OSMESA));
    each_parameter({Kind::number}, [&](const Function& f, std::size_t i) {
        const std::string name = f.parameters[i].name;
        if (name.find("order") == std::string::npos) return;
        const bool matrix = f.name.ends_with("_matrix") || f.name == "nicol_psh_nearest_kernel";
        const std::uint32_t highest = !matrix                  ? NICOL_PSH_MAX_ORDER
                                      : name == "scalar_order" ? 2 * NICOL_PSH_MAX_MATRIX_ORDER
                                                               : NICOL_PSH_MAX_MATRIX_ORDER;
        for (const std::uint32_t wrong : {highest + 1, 65535U, 65536U, 0x80000000U, UINT32_MAX}) {
            Arguments arguments(f, all);
            arguments.set(i, wrong);
            REFUSES(arguments.call(), name + " is " + std::to_string(wrong));
        }
    });
}
