// SPDX-License-Identifier: MIT
#include "gl/program_cache.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "files/cache_file.hpp"
#include "files/content_hash.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

constexpr std::string_view kMagic("NICOLPRG", 8);
constexpr std::uint32_t kVersion = 2;
constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 26;

CacheFile file_of(const Context& context, const std::filesystem::path& folder, const ProgramKey& key) {
    const ContextInfo& info = context.info();
    // Mesa's EGL and OSMesa have equal names and versions, and refuse programs of each other.
    const std::string backend = std::to_string(static_cast<int>(info.backend));
    return {folder, kMagic, kVersion,
            info.vendor + '\n' + info.renderer + '\n' + info.version + '\n' + info.driver_uuid + '\n' +
                backend + '\n' + key.text(),
            ".program"};
}

std::vector<GLint> formats_of(Context& context) {
    const GladGLContext& gl = functions(context, "ProgramCache");
    std::vector<GLint> formats(
        static_cast<std::size_t>(std::max(0, context.state().integer(GL_NUM_PROGRAM_BINARY_FORMATS))));
    if (!formats.empty()) gl.GetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
    return formats;
}

}  // namespace

void keep_programs(Context& context, std::filesystem::path folder,
                   std::function<void(const std::string&)> notice) {
    context.state().program_notices.set_receiver(std::move(notice));
    context.state().programs = formats_of(context).empty() ? std::filesystem::path() : std::move(folder);
}

void ProgramKey::add(unsigned stage, const std::string& text) {
    text_ += std::to_string(stage) + ' ' + ContentHash().add(text).text() + '\n';
}

ProgramCache::ProgramCache(Context& context) : context_(context), folder_(context.state().programs) {}

bool ProgramCache::load(const ProgramKey& key, unsigned program) const {
    if (!enabled()) return false;
    const CacheFile file = file_of(context_, folder_, key);
    const auto refused = [&](const std::string& reason) {
        context_.state().program_notices.add(file.path().string() + ": " + reason +
                                             "; the program is compiled anew");
        return false;
    };
    std::vector<unsigned char> content;
    std::uint32_t format = 0;
    const CacheFile::Outcome outcome = file.read(content, kMaxBytes);
    if (outcome.state == CacheFile::State::missing) return false;
    if (outcome.state == CacheFile::State::unfit) return refused(outcome.reason);
    if (content.size() < sizeof format) return refused("has the wrong length");
    std::copy_n(content.begin(), sizeof format, reinterpret_cast<unsigned char*>(&format));
    // Any other format would raise an OpenGL error.
    const std::vector<GLint> formats = formats_of(context_);
    if (std::ranges::find(formats, static_cast<GLint>(format)) == formats.end())
        return refused("has a format that the driver does not know");
    const GladGLContext& gl = functions(context_, "ProgramCache");
    gl.ProgramBinary(program, format, content.data() + sizeof format,
                     static_cast<GLsizei>(content.size() - sizeof format));
    GLint done = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &done);
    if (done == GL_TRUE) return true;
    context_.state().messages.clear();
    return refused("is refused by the driver");
}

void ProgramCache::store(const ProgramKey& key, unsigned program) const {
    if (!enabled()) return;
    const GladGLContext& gl = functions(context_, "ProgramCache");
    GLint length = 0;
    gl.GetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &length);
    if (length <= 0) return;
    std::vector<unsigned char> binary(static_cast<std::size_t>(length));
    GLenum format = 0;
    GLsizei written = 0;
    gl.GetProgramBinary(program, length, &written, &format, binary.data());
    context_.state().check("keeping a program");
    const std::uint32_t number = format;
    static_cast<void>(
        file_of(context_, folder_, key)
            .write(std::array{bytes_of(std::span(&number, 1)), std::span<const unsigned char>(binary).first(
                                                                   static_cast<std::size_t>(written))}));
}

}  // namespace nicol::gl
