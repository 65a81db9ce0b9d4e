// SPDX-License-Identifier: MIT
// Fuzzer of the C interface. The input's bytes choose functions, handles (alive, released and of other
// types), and values of numbers and struct fields. Pointers and the lengths of their targets are always
// valid, because the contract requires valid ones.
#define DOCTEST_CONFIG_IMPLEMENT
#include <set>
#include <string_view>

#include "capi/contract.hpp"

namespace {

using namespace capi_test;

constexpr int kMaxCalls = 24;
constexpr Slot kMaxVertices = 2000;  // finer meshes are slow to bake
constexpr std::size_t kMemoryDoubles = (std::size_t{1} << 16) / sizeof(double);

/// A reader of the input, which returns zeros beyond its end.
class Bytes {
public:
    Bytes(const std::uint8_t* bytes, std::size_t size) : at_(bytes), end_(bytes + size) {}
    [[nodiscard]] bool empty() const { return at_ == end_; }
    std::size_t next() { return empty() ? 0 : *at_++; }
    std::size_t below(std::size_t count) { return next() % count; }
    /// Returns the bytes that are left.
    [[nodiscard]] std::span<const std::uint8_t> rest() const { return {at_, end_}; }

private:
    const std::uint8_t* at_;
    const std::uint8_t* end_;
};

struct Field {
    std::string name;
    std::size_t offset, size, count;
    bool floating;
};
const std::vector<Field>& fields_of(const std::string& parameter) {
    static const std::map<std::string, std::vector<Field>> all = {
#include "fields.inc"
    };
    static const std::vector<Field> none;
    const auto found = all.find(parameter);
    return found == all.end() ? none : found->second;
}

/// Returns whether the function is excluded: it takes seconds with some arguments, reads or writes files, or
/// makes contexts.
bool is_left_out(const std::string& name) {
    return name.starts_with("nicol_context_create") || name.starts_with("nicol_file_") ||
           name.ends_with("_load") || name.find("_write") != std::string::npos ||
           (name.find("_load_") != std::string::npos && !name.ends_with("_memory")) ||
           name == "nicol_mesh_create_sphere" || name == "nicol_psh_project_file" ||
           name == "nicol_scene_load_memory";  // fuzz_scene and fuzz_gltf read scenes from memory
}
/// Returns whether objects of this maker render quickly. Other objects are released as soon as they are made.
bool is_quick(const std::string& maker) {
    return maker != "nicol_mesh_create_divided_sphere" && maker != "nicol_mesh_create_rectangle" &&
           maker != "nicol_mesh_create_cube" && maker != "nicol_material_create_pplastic" &&
           maker != "nicol_material_create_plastic" && maker != "nicol_material_create_conductor" &&
           maker != "nicol_material_create_callback" && maker != "nicol_environment_create_sky";
}

/// Chooses a number that is small or beyond every limit. Numbers in between are slow and test nothing new.
Slot whole_number(const std::string& name, Bytes& bytes) {
    static constexpr std::array<Slot, 22> values = {
        0,  1,  2,   3,   4,     5,     6,         7,          8,          16,         32,
        33, 64, 128, 255, 20000, 65537, INT32_MAX, 0x80000000, UINT32_MAX, UINT64_MAX, UINT64_MAX / 8 + 1};
    const Slot value = values.at(bytes.below(values.size()));
    // A length beyond the caller's own memory is the caller's fault, not a defect of the library.
    if (name.ends_with("count") && value > kMemoryDoubles) return UINT64_MAX;
    if (name == "executor" && value == NICOL_EXECUTOR_COMPUTE) return NICOL_EXECUTOR_CPU;
    if (name == "segments" && value > 4 && value <= 512) return 4;
    if (name == "samples" && value > 64 && value <= 65537) return 1;
    if (name == "max_vertices" && (value == 0 || value > kMaxVertices)) return kMaxVertices;
    return value;
}
double real_number(const std::string& name, Bytes& bytes) {
    static constexpr std::array<double, 20> values = {
        0,   -0.0, 1,    -1,    0.5,    0.25,   2,     10,     45,       90,
        180, -180, 1e-3, 1e-30, 1e-310, 1.5e30, 1e300, -1e300, HUGE_VAL, -HUGE_VAL};
    const std::size_t choice = bytes.below(values.size() + 1);
    if (choice == values.size()) return std::nan("");
    // Fine meshes are slow to bake, and such a job delays later inputs.
    if (name == "refine_tolerance" && values.at(choice) > 0 && values.at(choice) < 0.25) return 1;
    if (name == "turbidity" && values.at(choice) >= 1.7 && values.at(choice) <= 10) return 1;
    return values.at(choice);
}

void change_field(std::vector<std::byte>& memory, const std::vector<Field>& fields,
                  const std::string& function, Bytes& bytes) {
    const Field& field = fields[bytes.below(fields.size())];
    const std::size_t at = field.offset + field.size * bytes.below(field.count);
    if (field.floating) {
        const double value = real_number(field.name, bytes);
        const auto single = static_cast<float>(std::clamp(value, -3e38, 3e38));
        const auto* source =
            field.size == 4 ? static_cast<const void*>(&single) : static_cast<const void*>(&value);
        std::memcpy(&memory[at], source, field.size);
        return;
    }
    Slot value = whole_number(field.name, bytes);
    Slot held = 0;
    std::memcpy(&held, &memory[at], field.size);
    const bool is_length =
        field.name == "vertex_count" || field.name == "triangle_count" || field.name == "byte_size";
    if (is_length && value > held) return;
    // Sizes are multiples of 8, because no version's struct ends within a pointer and half a pointer could
    // point anywhere.
    if (field.name == "struct_size") value = value > memory.size() ? UINT32_MAX : value - value % 8;
    if (function.starts_with("nicol_psh") && value < 20000) value %= 8;
    std::memcpy(&memory[at], &value, field.size);
}

/// The handles that a program of calls may use.
class Handles {
public:
    explicit Handles(const Everything& base) : base_(base) {
        for (std::size_t type = 0; type < handle_names.size(); ++type) alive_[type] = {base.handles[type]};
    }
    ~Handles() {
        end_jobs();
        for (const Addition& added : additions_) {
            const std::array<Slot, 2> slots{added.scene, added.id};
            added.remove->call(slots.data());  // fails if the program removed it, or released the scene
        }
        for (std::size_t type = alive_.size(); type-- > 0;)
            for (const Slot handle : alive_[type])
                for (; references_[handle] > 0; --references_[handle]) release(type, handle);
    }
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;

    /// Chooses a handle, usually a live one of the type.
    Slot choose(std::size_t type, Bytes& bytes) {
        const std::size_t how = bytes.next();
        if (how == 255) return 0;
        if (how == 254) return Everything::slot(marker<void*>());
        if (how == 253 && !released_.empty()) return released_[bytes.below(released_.size())];
        const auto& pool = alive_[how == 252 ? bytes.below(alive_.size()) : type];
        return pool[how % pool.size()];
    }
    void add(std::size_t type, Slot handle) {
        if (handle == 0) return;
        if (std::ranges::find(alive_[type], handle) == alive_[type].end()) alive_[type].push_back(handle);
        if (type == handle_type<nicol_job>() && references_[handle] == 0) hold(argument<nicol_job>(handle));
        ++references_[handle];
    }
    /// Notes what a nicol_scene_add_... added to a scene: kept, it would slow down all later inputs.
    void add_to_scene(const std::string& adder, Slot scene, Slot id) {
        constexpr std::string_view prefix = "nicol_scene_add_";
        const std::string remover = "nicol_scene_remove_" + adder.substr(prefix.size());
        additions_.push_back({.remove = &::function(remover), .scene = scene, .id = id});
    }
    [[nodiscard]] bool may_release(Slot handle) {
        const bool is_base = std::ranges::find(base_.handles, handle) != base_.handles.end();
        return !is_base || references_[handle] > 0;
    }
    void take(std::size_t type, Slot handle) {
        if (handle == 0 || --references_[handle] > 0 || handle == base_.handles[type]) return;
        std::erase(alive_[type], handle);
        released_.push_back(handle);
    }
    static void release(std::size_t type, Slot handle) {
        OK(::function(std::string(handle_names[type]) + "_release").call(&handle));
    }

private:
    /// Retains a job, because jobs that the program releases keep running and must be ended.
    void hold(nicol_job job) {
        OK(nicol_job_retain(job));
        jobs_.push_back(job);
    }
    /// Ends all jobs, so that they do not take time from later inputs.
    void end_jobs() {
        for (const nicol_job job : jobs_) OK(nicol_job_cancel(job));
        for (const nicol_job job : jobs_) {
            const nicol_result result = nicol_job_wait(job, NICOL_WAIT_FOREVER);
            CHECK_MESSAGE(result != NICOL_ERROR_INTERNAL, nicol_last_error());
            OK(nicol_job_release(job));
        }
    }

    struct Addition {
        const Function* remove;
        Slot scene, id;
    };

    const Everything& base_;
    std::vector<nicol_job> jobs_;
    std::vector<Addition> additions_;
    std::array<std::vector<Slot>, handle_names.size()> alive_;
    std::map<Slot, int> references_;
    std::vector<Slot> released_;
};

/// Returns whether the function takes arrays of handles. The caller's arrays hold one element.
bool takes_handles(const Function& function) {
    return std::ranges::any_of(function.parameters,
                               [](const Parameter& parameter) { return parameter.kind == Kind::handles; });
}

void call(const Function& function, const Everything& all, Handles& handles, Bytes& bytes) {
    Arguments arguments(function, all);
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const Parameter& parameter = function.parameters[i];
        if (parameter.kind == Kind::handle) {
            arguments.set(i, handles.choose(parameter.type, bytes));
        } else if (parameter.kind == Kind::struct_in ||
                   (parameter.kind == Kind::input && parameter.size > 0)) {
            if (function.name == "nicol_scene_add_instance") {
                const Slot parts[] = {handles.choose(handle_type<nicol_mesh>(), bytes),
                                      handles.choose(handle_type<nicol_material>(), bytes)};
                std::memcpy(arguments.memory(i).data() + offsetof(nicol_instance, mesh), parts, sizeof parts);
            }
            if (function.name.starts_with("nicol_render") && parameter.name == std::string_view("options"))
                std::memcpy(arguments.memory(i).data() + offsetof(nicol_render_options, max_vertices),
                            &kMaxVertices, sizeof kMaxVertices);
            if (function.name.ends_with("_memory") && parameter.name == std::string_view("file")) {
                nicol_memory_file file = NICOL_MEMORY_FILE_INIT;
                file.bytes = bytes.rest().data();
                file.byte_size = bytes.rest().size();
                std::memcpy(arguments.memory(i).data(), &file, sizeof file);
            }
            const std::string name = function.name + "." + parameter.name;
            const std::vector<Field>& fields = fields_of(name);
            for (std::size_t changes = bytes.below(4); changes > 0 && !fields.empty(); --changes)
                change_field(arguments.memory(i), fields, function.name, bytes);
        } else if (parameter.kind == Kind::input) {
            for (std::size_t changes = bytes.below(4); changes > 0; --changes) {
                const double value = real_number(parameter.name, bytes);
                std::memcpy(arguments.memory(i).data() + sizeof value * bytes.next(), &value, sizeof value);
            }
        } else if (parameter.kind == Kind::number && bytes.below(4) == 0) {
            Slot number = whole_number(parameter.name, bytes);
            // Whether the caller's memory is smaller than what it says cannot be seen from inside.
            if (parameter.name == std::string_view("struct_size"))
                number = std::min<Slot>(number, function.parameters[0].size);
            if (parameter.name == std::string_view("count") && takes_handles(function))
                number = std::min<Slot>(number, 1);
            arguments.set(i, number);
        }
        // A pointer may also become NULL.
        if (parameter.kind != Kind::handle && parameter.kind != Kind::number && bytes.next() == 255)
            arguments.set(i, 0);
    }
    const bool is_release = function.name.ends_with("_release"),
               is_retain = function.name.ends_with("_retain");
    if (is_release && !handles.may_release(arguments[0])) return;

    std::vector<Slot> slots;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) slots.push_back(arguments[i]);
    const nicol_result result = function.call(slots.data());
    CHECK_MESSAGE(result != NICOL_ERROR_INTERNAL, function.name, ": ", nicol_last_error());
    if (result != NICOL_OK) {
        CHECK_MESSAGE(*nicol_last_error() != '\0', function.name, " failed without a message");
        return;
    }
    if (is_release) handles.take(function.parameters[0].type, slots[0]);
    if (is_retain) handles.add(function.parameters[0].type, slots[0]);
    if (function.name.starts_with("nicol_scene_add_") && slots.back() != 0) {
        std::uint32_t id = 0;
        std::memcpy(&id, arguments.memory(slots.size() - 1).data(), sizeof id);
        handles.add_to_scene(function.name, slots[0], id);
    }
    for (std::size_t i = 0; i < slots.size(); ++i) {
        if (function.parameters[i].kind != Kind::new_handle || slots[i] == 0) continue;
        const std::size_t type = function.parameters[i].type;
        Slot made = 0;
        std::memcpy(&made, arguments.memory(i).data(), sizeof made);
        if (is_quick(function.name))
            handles.add(type, made);
        else
            Handles::release(type, made);
    }
}

/// One object of each type, with a scene of a single triangle.
const Everything& everything() {
    static_cast<void>(functions());  // made first, so that it outlives `all`
    static Everything all(make_context(NICOL_BACKEND_OSMESA));
    all.folder.write("a.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
    const std::string file =
        all.folder.write("small.xml",
                         "<scene version='3.0.0'><sensor type='perspective'/><shape type='obj'>"
                         "<string name='filename' value='a.obj'/></shape></scene>");
    const auto replace = [&]<class Handle>(Handle made) {
        constexpr std::size_t type = handle_type<Handle>();
        OK(all.release(type));
        all.handles[type] = Everything::slot(made);
    };
    const auto context = argument<nicol_context>(all.handles[handle_type<nicol_context>()]);
    replace(make(nicol_scene_load, context, file.c_str(), nullptr, 0U));
    replace(make(nicol_mesh_load, context, all.folder.file("a.obj").c_str()));
    return all;
}

/// Reports a failed check outside a test case as a finding.
void abort_at(const doctest::AssertData& data) {
    if (!data.m_failed) return;
    std::fprintf(stderr, "finding: %s:%d: %s %s\n", data.m_file, data.m_line, data.m_expr,
                 nicol_last_error());
    std::abort();
}

struct Prepared {
    const Everything& all;
    std::vector<Function> usable;
};

const Prepared& prepared() {
    static const Prepared one = [] {
        static auto& checks = *new doctest::Context;  // never destroyed, but reachable and thus no leak
        checks.setAsDefaultForAssertsOutOfTestCases();
        checks.setAssertHandler(abort_at);
        Prepared made{.all = everything(), .usable = {}};
        std::ranges::copy_if(functions(), std::back_inserter(made.usable),
                             [](const Function& f) { return !is_left_out(f.name); });
        return made;
    }();
    return one;
}

}  // namespace

/// Prepares the objects. libFuzzer calls it before the time of the first input begins.
extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*arguments*/) {
    static_cast<void>(prepared());
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto& [all, usable] = prepared();
    Bytes bytes(data, size);
    Handles handles(all);
    for (int calls = 0; calls < kMaxCalls && !bytes.empty(); ++calls)
        call(usable[bytes.below(usable.size())], all, handles, bytes);
    return 0;
}
