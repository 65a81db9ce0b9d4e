// SPDX-License-Identifier: MIT
// A uniform table of every function of nicol.h with good arguments, so that tests can make them wrong one at
// a time.
#pragma once

#include <bit>
#include <map>

#include "capi.hpp"

namespace capi_test {

/// Bits of one argument.
using Slot = std::uint64_t;

enum class Kind : std::uint8_t {
    handle,
    new_handle,
    handles,
    struct_in,
    struct_out,
    input,
    text,
    output,
    callback,
    user,
    number
};

inline constexpr std::array handle_names = {"nicol_context",     "nicol_environment", "nicol_texture",
                                            "nicol_material",    "nicol_mesh",        "nicol_scene",
                                            "nicol_framebuffer", "nicol_job",         "nicol_psh_transform"};
using HandleTypes = std::tuple<nicol_context, nicol_environment, nicol_texture, nicol_material, nicol_mesh,
                               nicol_scene, nicol_framebuffer, nicol_job, nicol_psh_transform>;

/// Position of T in HandleTypes, or the number of types if T is not a handle.
template <class T, std::size_t i = 0>
constexpr std::size_t handle_type() {
    if constexpr (i == std::tuple_size_v<HandleTypes>) {
        return i;
    } else {
        return std::is_same_v<T, std::tuple_element_t<i, HandleTypes>> ? i : handle_type<T, i + 1>();
    }
}
template <class T>
concept IsHandle = handle_type<T>()
< std::tuple_size_v<HandleTypes>;
template <class T>
concept Sized = requires(T t) {
    t.struct_size;
};

#include "defaults.inc"

/// Fills in a struct that a call accepts, in the bytes of its argument.
template <class T>
void make_good(T&) {}
inline void make_good(nicol_image& image) {
    static const std::vector<float> pixels(4, 1.0F);
    image = image_of(pixels, 2, 2, 1, 1);
}
inline void make_good(nicol_mesh_data& data) {
    static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const std::uint32_t indices[] = {0, 1, 2};
    data.vertex_count = 3;
    data.triangle_count = 1;
    data.positions = positions;
    data.indices = indices;
}
inline void make_good(nicol_memory_file& file) {
    static const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    file.bytes = triangle.data();
    file.byte_size = triangle.size();
}
inline void make_good(nicol_deformation& deformation) {
    static const float positions[12] = {};
    deformation.vertex_count = 4;
    deformation.positions = positions;
}
inline void make_good(nicol_texture_image& image) {
    static const std::uint8_t pixels[] = {0, 255};
    image.width = 2;
    image.height = image.channels = 1;
    image.pixels = pixels;
    image.byte_size = 2;
}
inline void make_good(nicol_callback_material& material) {
    material = grey_function();
}
inline void make_good(nicol_psh_mueller_field& field) {
    field.order_out = field.order_in = 3;
    field.callback = [](void*, const double*, const double*, double*) { return std::int32_t{1}; };
}
inline void make_good(nicol_gradient& gradient) {
    static double instance = 0;
    gradient.instances = &instance;
    gradient.instances_count = 1;
}
inline void make_good(nicol_stokes_image& image) {
    static std::vector<float> pixels(64);
    image.width = image.height = 4;
    image.channels = 1;
    image.pixels = pixels.data();
    image.byte_size = 256;
}
inline void make_good(nicol_raw_image& image) {
    static std::vector<std::uint16_t> pixels(16);
    image.width = image.height = 4;
    image.pixels = pixels.data();
    image.byte_size = 32;
}
inline void make_good(nicol_psh_sampling& sampling) {
    sampling.order = 3;
}

struct Parameter {
    Kind kind = Kind::number;
    std::size_t type = 0;              ///< handle type, an index into handle_names
    std::size_t size = 0;              ///< bytes of the struct pointed to; 0: no struct
    std::vector<std::byte> initial{};  ///< bytes of the struct with its defaults
    std::vector<std::byte> good{};     ///< bytes of a struct that the call accepts
    Slot agreeing = 0;                 ///< function of the callback's own type, which returns 1
    const char* name = "";
};

/// Returns a function of this type that does nothing and returns 1.
template <class R, class... A>
Slot agreeing(R (*)(A...)) {
    R (*const agrees)(A...) = [](A...) { return static_cast<R>(1); };
    return static_cast<Slot>(reinterpret_cast<std::uintptr_t>(agrees));
}

template <class T>
Parameter parameter_of() {
    if constexpr (IsHandle<T>) {
        return {.kind = Kind::handle, .type = handle_type<T>()};
    } else if constexpr (!std::is_pointer_v<T>) {
        return {};
    } else {
        using Target = std::remove_pointer_t<T>;
        using Plain = std::remove_const_t<Target>;
        if constexpr (std::is_function_v<Target>) {
            return {.kind = Kind::callback, .agreeing = agreeing(T{})};
        } else if constexpr (std::is_void_v<Target>) {
            return {.kind = Kind::user};
        } else if constexpr (IsHandle<Plain>) {
            return {.kind = std::is_const_v<Target> ? Kind::handles : Kind::new_handle,
                    .type = handle_type<Plain>()};
        } else if constexpr (Sized<Plain>) {
            const auto bytes_of = [](const Plain& made) {
                std::vector<std::byte> bytes(sizeof made);
                std::memcpy(bytes.data(), &made, sizeof made);
                return bytes;
            };
            Plain initial;
            initialise(initial);
            Plain good = initial;
            make_good(good);
            return {.kind = std::is_const_v<Target> ? Kind::struct_in : Kind::struct_out,
                    .size = sizeof good,
                    .initial = bytes_of(initial),
                    .good = bytes_of(good)};
        } else if constexpr (std::is_same_v<Plain, char>) {
            return {.kind = Kind::text};
        } else {
            return {.kind = std::is_const_v<Target> ? Kind::input : Kind::output};
        }
    }
}

template <class T>
T argument(Slot slot) {
    if constexpr (std::is_floating_point_v<T>) {
        return static_cast<T>(std::bit_cast<double>(slot));
    } else if constexpr (std::is_pointer_v<T>) {
        return reinterpret_cast<T>(static_cast<std::uintptr_t>(slot));
    } else {
        return static_cast<T>(slot);
    }
}

struct Bound {
    std::vector<Parameter> parameters;
    std::function<nicol_result(const Slot*)> call;
};

template <class... A>
Bound bind(nicol_result (*function)(A...)) {
    return {{parameter_of<A>()...}, [function](const Slot* slots) {
                return [&]<std::size_t... i>(std::index_sequence<i...>) {
                    return function(argument<A>(slots[i])...);
                }
                (std::index_sequence_for<A...>());
            }};
}

struct Function {
    std::string name;
    std::vector<Parameter> parameters;
    std::function<nicol_result(const Slot*)> call;

    Function(const char* name_, const std::vector<const char*>& names, Bound bound)
        : name(name_), parameters(std::move(bound.parameters)), call(std::move(bound.call)) {
        for (std::size_t i = 0; i < names.size(); ++i) parameters[i].name = names[i];
    }
    /// Returns the position of the parameter that counts the doubles of this pointer, or 0 if there is none.
    [[nodiscard]] std::size_t count_of(std::size_t pointer) const {
        const Kind kind = parameters[pointer].kind;
        if (kind != Kind::input && kind != Kind::output) return 0;
        const std::size_t next = pointer + 1;
        return next < parameters.size() && std::string(parameters[next].name).ends_with("count") ? next : 0;
    }
};

/// Returns every function that returns a result.
inline const std::vector<Function>& functions() {
    static const std::vector<Function> all{
#include "functions.inc"
    };
    return all;
}

inline const Function& function(const std::string& name) {
    for (const Function& found : functions())
        if (found.name == name) return found;
    FAIL("nicol.h has no function " << name);
    std::abort();
}

/// A live handle of each type, and names of files.
struct Everything {
    std::array<Slot, handle_names.size()> handles{};

    /// Takes over the reference to the context.
    explicit Everything(nicol_context context) {
        light = folder.file("light.npz");
        OK(nicol_psh_write_file(light.c_str(), 0, 1, std::array{1.0, 0.0, 0.0, 0.0}.data(), 4));
        const nicol_material material = make(nicol_material_create_diffuse, context, nullptr);
        nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
        options.order = 3;
        reflectance = folder.file("material.npz");
        OK(nicol_material_write(material, &options, reflectance.c_str()));
        const std::string file =
            folder.write("scene.xml",
                         "<scene version='3.0.0'><sensor type='perspective'>"
                         "<float name='fov' value='50'/></sensor><shape type='rectangle'/></scene>");
        const nicol_scene scene = make(nicol_scene_load, context, file.c_str(), nullptr, 0U);
        const nicol_light lamp = NICOL_LIGHT_INIT;
        OK(nicol_scene_add_light(scene, &lamp, nullptr));
        const nicol_polarization_element element = NICOL_POLARIZATION_ELEMENT_INIT;
        OK(nicol_scene_add_polarization_element(scene, &element, nullptr));
        const nicol_framebuffer framebuffer = framebuffer_of(context, 4, 4, 1);
        const nicol_camera camera = front_camera();
        const nicol_job job = make(nicol_render_async, scene, &camera, nullptr, framebuffer);
        OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));
        nicol_psh_sampling sampling = NICOL_PSH_SAMPLING_INIT;
        sampling.order = 3;
        handles = {slot(context),
                   slot(make(nicol_environment_load, context, light.c_str(), nullptr)),
                   slot(make(nicol_texture_create_vertex_colors, context)),
                   slot(material),
                   slot(rectangle(context)),
                   slot(scene),
                   slot(framebuffer),
                   slot(job),
                   slot(make(nicol_psh_transform_create, &sampling))};
    }
    ~Everything() { release_all(); }
    Everything(const Everything&) = delete;
    Everything& operator=(const Everything&) = delete;
    /// Releases every handle, on the first call only. The addresses stay.
    void release_all() {
        if (std::exchange(released, true)) return;
        for (std::size_t type = handles.size(); type-- > 0;) CHECK(release(type) == NICOL_OK);
    }
    template <class T>
    static Slot slot(T* pointer) {
        return static_cast<Slot>(reinterpret_cast<std::uintptr_t>(pointer));
    }
    [[nodiscard]] nicol_result retain(std::size_t type) const {
        return function(std::string(handle_names[type]) + "_retain").call(&handles[type]);
    }
    [[nodiscard]] nicol_result release(std::size_t type) const {
        return function(std::string(handle_names[type]) + "_release").call(&handles[type]);
    }
    [[nodiscard]] const char* text(const std::string& function, const std::string& parameter) const {
        if (function == "nicol_file_describe_material") return reflectance.c_str();
        return function.ends_with("_write") || function.find("_write_") != std::string::npos ||
                       parameter == "out"
                   ? written.c_str()
                   : light.c_str();
    }

    TemporaryFolder folder;
    std::string light, reflectance, written = folder.file("written.npz");
    bool released = false;
};

/// Arguments of a function, with the memory that they point to.
class Arguments {
public:
    Arguments(const Function& function, const Everything& all)
        : function_(&function), slots_(function.parameters.size()), memory_(slots_.size()) {
        for (std::size_t i = 0; i < slots_.size(); ++i) {
            const Parameter& parameter = function.parameters[i];
            switch (parameter.kind) {
                case Kind::handle:
                    slots_[i] = all.handles[parameter.type];
                    break;
                case Kind::new_handle:
                    point(i, std::vector<std::byte>(sizeof(Slot), unwritten));
                    break;
                case Kind::handles:
                    point(i, std::vector<std::byte>(sizeof(Slot)));
                    std::memcpy(memory_[i].data(), &all.handles[parameter.type], sizeof(Slot));
                    break;
                case Kind::struct_in:
                case Kind::struct_out:
                    point(i, parameter.good);
                    break;
                case Kind::text:
                    set(i, Everything::slot(all.text(function.name, parameter.name)));
                    break;
                case Kind::input:
                    point(i, std::vector<std::byte>(std::size_t{1} << 16));
                    if (const std::string name = parameter.name; name == "rotation" || name == "directions") {
                        static constexpr double identity[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
                        std::memcpy(memory_[i].data(), identity, sizeof identity);
                    }
                    break;
                case Kind::output:
                    point(i, std::vector<std::byte>(std::size_t{1} << 16, unwritten));
                    break;
                case Kind::callback:
                    slots_[i] = parameter.agreeing;
                    break;
                case Kind::user:
                    break;
                case Kind::number:
                    slots_[i] = parameter.name == std::string("struct_size")
                                    ? function.parameters[0].size
                                    : good_number(function.name, parameter.name);
            }
        }
    }
    void set(std::size_t i, Slot value) { slots_[i] = value; }
    /// Points argument i to a block of exactly these bytes, so that a sanitizer detects reads beyond them.
    void point(std::size_t i, std::vector<std::byte> bytes) {
        memory_[i] = std::move(bytes);
        slots_[i] = Everything::slot(memory_[i].data());
    }
    [[nodiscard]] Slot operator[](std::size_t i) const { return slots_[i]; }
    [[nodiscard]] std::vector<std::byte>& memory(std::size_t i) { return memory_[i]; }

    /// Calls the function and checks that a failing call wrote nothing. Releases a handle that the call made.
    nicol_result call() {
        const std::vector<std::vector<std::byte>> before = memory_;
        const nicol_result result = function_->call(slots_.data());
        for (std::size_t i = 0; i < slots_.size(); ++i) {
            const Parameter& parameter = function_->parameters[i];
            if (result != NICOL_OK) {
                CHECK_MESSAGE(memory_[i] == before[i], function_->name, " failed and wrote ", parameter.name);
            } else if (parameter.kind == Kind::new_handle && slots_[i] != 0) {
                Slot made = 0;
                std::memcpy(&made, memory_[i].data(), sizeof made);
                OK(::capi_test::function(std::string(handle_names[parameter.type]) + "_release").call(&made));
                memory_[i] = before[i];
            }
        }
        return result;
    }

private:
    static constexpr std::byte unwritten{0x5a};

    /// Returns good numbers: order 3, two vectors, and the lengths that follow from them.
    static Slot good_number(const std::string& function, const std::string& name) {
        static const std::map<std::string, Slot> numbers = {
            {"nicol_scene_load.definition_count", 0},
            {"nicol_scene_load_memory.definition_count", 0},
            {"nicol_scene_get_instance_ids.count", 0},
            {"nicol_scene_get_light_ids.count", 0},
            {"nicol_scene_get_polarization_element_ids.count", 0},
            {"nicol_render_views.count", 1},
            {"nicol_environment_create_psh.channels", 2},
            {"nicol_psh_project_image.count", 64},
            {"nicol_psh_project_environment.count", 64},
            {"nicol_psh_project_file.count", 64},
            {"nicol_psh_transform_get_rows.count", 7},
            {"nicol_file_describe_light.count", 4},
            {"nicol_file_describe_material.count", 4},
            {"byte_size", 64},
            {"width", 4},
            {"height", 4},
            {"channels", 1},
            {"device", 1},
            {"segments", 4},
            {"vectors", 2},
            {"count", 128},
            {"coefficient_count", 128},
            {"in_count", 128},
            {"out_count", 128},
            {"sample_count", 392},
            {"direction_count", 6},
            {"stokes_count", 16},
            {"scalar_count", 16},
            {"matrix_count", 4096},
            {"first_count", 4096},
            {"second_count", 4096},
            {"band_count", 64},
            {"theta_count", 3},
            {"mueller_count", 48},
        };
        for (const std::string& key : {function + "." + name, name})
            if (const auto found = numbers.find(key); found != numbers.end()) return found->second;
        return name.find("order") != std::string::npos ? 3 : 0;
    }

    const Function* function_;
    std::vector<Slot> slots_;
    std::vector<std::vector<std::byte>> memory_;
};

}  // namespace capi_test
