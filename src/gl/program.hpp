// SPDX-License-Identifier: MIT
// Linked shader stages and their uniforms.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "gl/object.hpp"
#include "gl/shader_source.hpp"

namespace nicol::gl {

/// A linked program. All members must be called inside run(). Compiling throws Error(opengl), whose text
/// names file and line of each message.
class Program {
public:
    /// Compiles embedded files, such as ("surface.vert", "surface.frag").
    [[nodiscard]] static Program graphics(std::shared_ptr<Context> context, std::string_view vertex_file,
                                          std::string_view fragment_file,
                                          std::span<const Define> defines = {});
    [[nodiscard]] static Program compute(std::shared_ptr<Context> context, std::string_view file,
                                         std::span<const Define> defines = {});
    /// Compiles source texts.
    [[nodiscard]] static Program graphics(std::shared_ptr<Context> context, const ShaderSource& vertex,
                                          const ShaderSource& fragment, std::span<const Define> defines = {});
    [[nodiscard]] static Program compute(std::shared_ptr<Context> context, const ShaderSource& source,
                                         std::span<const Define> defines = {});

    /// Sets a uniform of exactly the value's type; int also sets bool and samplers. A value that the uniform
    /// has already costs no command. Throws Error(invalid_argument) for a name that the linked program does
    /// not use, listing the names that it uses, and for another type.
    void set(std::string_view name, int value);
    void set(std::string_view name, unsigned value);
    void set(std::string_view name, float value);
    void set(std::string_view name, const glm::vec2& value);
    void set(std::string_view name, const glm::vec3& value);
    void set(std::string_view name, const glm::ivec2& value);
    void set(std::string_view name, const glm::ivec3& value);
    void set(std::string_view name, const glm::vec4& value);
    void set(std::string_view name, const glm::mat3& value);
    void set(std::string_view name, const glm::mat4& value);
    /// Returns whether the linked program uses that uniform. The compiler removes uniforms that a define
    /// leaves unused.
    [[nodiscard]] bool uses(std::string_view name) const { return uniforms_.find(name) != uniforms_.end(); }

    [[nodiscard]] bool is_compute() const noexcept { return compute_; }
    [[nodiscard]] const std::string& label() const noexcept { return label_; }  ///< file names, for messages
    [[nodiscard]] unsigned id() const noexcept { return object_.id(); }
    [[nodiscard]] const std::shared_ptr<Context>& context() const noexcept { return object_.context(); }

private:
    struct Uniform {
        int location;
        unsigned type;
        std::array<std::byte, sizeof(glm::mat4)> last{};  // bytes of the last value
        bool known = false;                               // whether there is a last value
    };
    struct Stage {
        unsigned type;
        ShaderSource source;
    };
    Program(std::shared_ptr<Context> context, std::span<const Stage> stages, std::span<const Define> defines);
    void find_uniforms();
    [[nodiscard]] Uniform& find(std::string_view name, unsigned type);
    // Calls set(functions, location) unless the uniform has the value already.
    template <class Value, class Set>
    void update(std::string_view name, unsigned type, const Value& value, Set set);

    Object object_;
    std::string label_;
    bool compute_;
    std::map<std::string, Uniform, std::less<>> uniforms_;
};

}  // namespace nicol::gl
