// SPDX-License-Identifier: MIT
// Tests of OpenGL contexts: creation, threads and destruction.
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "gl/buffer.hpp"
#include "gl/contexts.hpp"

using namespace nicol;
using namespace nicol::gl;

namespace {

/// Returns the output of gl_context_of with these environment settings ("NAME=value NAME=value") and
/// argument.
std::string program(const std::string& environment, const std::string& argument = "") {
    // Leak checks are off, because LeakSanitizer would report leaks of Mesa at the end of the child.
    const std::string command =
        "env " + environment + " ASAN_OPTIONS=detect_leaks=0 " NICOL_GL_CONTEXT_OF " " + argument;
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 512> part;
    while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr) output += part.data();
    CHECK(pclose(pipe) == 0);
    return output;
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

GL_TEST_CASE("a context describes itself") {
    const ContextInfo& info = context->info();
    CHECK(info.backend != Backend::automatic);
    CHECK(!info.vendor.empty());
    CHECK(!info.renderer.empty());
    CHECK(!info.device.empty());
    CHECK(contains(info.version, "."));
    if (contains(info.renderer, "llvmpipe")) CHECK(info.software);
    const Limits& limits = context->limits();
    CHECK(limits.texture_size >= 16384);
    CHECK(limits.target_size >= 4096);
    CHECK(limits.colour_attachments >= 8);
    CHECK(limits.storage_bindings >= 8);
    CHECK(limits.storage_bytes >= (std::size_t{1} << 24));
    CHECK(limits.groups[0] >= 65535);
}

GL_TEST_CASE("run returns values, passes exceptions on, and nests") {
    CHECK(!context->on_thread());
    CHECK(context->run([&] { return context->on_thread(); }));
    CHECK(context->run([] { return std::make_unique<int>(7); }) != nullptr);
    CHECK(context->run([&] { return context->run([] { return 42; }); }) == 42);
    CHECK_THROWS_AS(context->run([] { throw std::out_of_range("mine"); }), std::out_of_range);
    CHECK_THROWS_WITH(context->run([]() -> int { throw std::runtime_error("kept text"); }), "kept text");
    CHECK(context->run([] { return 1; }) == 1);  // run() works after exceptions
    int changed = 0;
    context->run([&] { changed = 3; });
    CHECK(changed == 3);
}

GL_TEST_CASE("objects refuse to be used outside run") {
    CHECK_THROWS_AS(Buffer(context, BufferUse::vertex, 16, BufferUpdate::fixed), Error);
    CHECK_THROWS_AS(finish(*context), Error);
    CHECK_THROWS_AS(flush(*context), Error);
    CHECK_NOTHROW(context->run([&] { finish(*context); }));
    CHECK_NOTHROW(context->run([&] { flush(*context); }));
    CHECK_THROWS_AS(Buffer(nullptr, BufferUse::vertex, 16, BufferUpdate::fixed), Error);
}

TEST_CASE("contexts and objects may be dropped in any order and anywhere") {
    for (const Backend backend : every_backend()) {
        CAPTURE(name_of(backend));
        const auto make = [](const std::shared_ptr<Context>& context) {
            return context->run([&] {
                return std::make_unique<Buffer>(context, BufferUse::storage, 1024, BufferUpdate::dynamic);
            });
        };
        {  // the object is destroyed first
            auto context = make_context(backend);
            auto buffer = make(context);
            CHECK(context->memory().of(MemoryKind::storage) == 1024);
            buffer.reset();
            CHECK(total_bytes(context->memory()) == 0);
        }
        {  // the context is destroyed first, but the object keeps it alive
            auto context = make_context(backend);
            auto buffer = make(context);
            const std::weak_ptr<Context> watch = context;
            context.reset();
            CHECK(!watch.expired());
            buffer.reset();
            CHECK(watch.expired());
        }
        {  // the last reference is dropped on another thread
            auto context = make_context(backend);
            auto buffer = make(context);
            context.reset();
            std::thread([&] { buffer.reset(); }).join();
        }
        {  // the last reference is dropped on the context's own thread
            auto context = make_context(backend);
            auto buffer = make(context);
            Context& bare = *context;
            bare.run([&] {
                context.reset();
                buffer.reset();
            });
        }
        {  // the last reference of each is dropped on the other's thread
            auto context = make_context(backend);
            auto other = make_context(backend == Backend::egl ? Backend::osmesa : Backend::egl);
            Context& bare = *context;
            bare.run([&] { other.reset(); });
            bare.run([&] { context.reset(); });
        }
        {  // an exception unwinds through objects
            auto context = make_context(backend);
            CHECK_THROWS_AS(context->run([&] {
                const Buffer buffer(context, BufferUse::vertex, 64, BufferUpdate::fixed);
                throw std::runtime_error("unwind");
            }),
                            std::runtime_error);
            CHECK(total_bytes(context->memory()) == 0);
        }
    }
}

GL_TEST_CASE("an object can be moved and assigned") {
    context->run([&] {
        Buffer a(context, BufferUse::vertex, 16, BufferUpdate::fixed);
        Buffer b(context, BufferUse::index, 32, BufferUpdate::fixed);
        b = std::move(a);
        CHECK(context->memory().of(MemoryKind::index) == 0);
        CHECK(context->memory().of(MemoryKind::vertex) == 16);
        CHECK(b.size() == 16);
    });
    CHECK(total_bytes(context->memory()) == 0);
}

GL_TEST_CASE("several threads share one context") {
    int counter = 0;  // unguarded on purpose, because calls of run() do not overlap
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            for (int round = 0; round < 200; ++round) context->run([&] { ++counter; });
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(counter == 800);
}

TEST_CASE("a device is counted from 0 and belongs to EGL") {
    CHECK_THROWS_AS(Context::create({Backend::osmesa, 0}), Error);
    CHECK_THROWS_WITH_AS(Context::create({Backend::automatic, 4711}), doctest::Contains("4711"), Error);
    CHECK_THROWS_AS(Context::create({Backend::egl, -1}), Error);
    const auto first = Context::create({Backend::automatic, 0});
    CHECK(first->info().backend == Backend::egl);
    CHECK(contains(first->info().device, "EGL device 0"));
}

TEST_CASE("NICOL_BACKEND replaces the automatic choice and nothing else") {
    CHECK(program("NICOL_BACKEND=osmesa").starts_with("ok osmesa"));
    CHECK(program("NICOL_BACKEND=egl").starts_with("ok egl"));
    CHECK(program("NICOL_BACKEND=").starts_with("ok egl"));
    CHECK(program("NICOL_BACKEND=osmesa", "egl").starts_with("ok egl"));
    const std::string unknown = program("NICOL_BACKEND=vulkan");
    CHECK(unknown.starts_with("error 1 "));
    CHECK(contains(unknown, "NICOL_BACKEND"));
    CHECK(contains(unknown, "vulkan"));
}

TEST_CASE("without an EGL driver the automatic choice is OSMesa, and the reasons are kept") {
    const std::string no_driver = "-u NICOL_BACKEND __EGL_VENDOR_LIBRARY_DIRS=/nonexistent";
    const std::string fallen_back = program(no_driver);
    CHECK(fallen_back.starts_with("ok osmesa"));
    CHECK(contains(fallen_back, "failed EGL devices"));
    CHECK(contains(fallen_back, "10_nvidia.json"));
    CHECK(contains(fallen_back, "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"));

    const std::string explicit_choice = program(no_driver, "egl");
    CHECK(explicit_choice.starts_with("error 8 "));
    CHECK(contains(explicit_choice, "10_nvidia.json"));
    CHECK(contains(explicit_choice, "EGL surfaceless: "));
}
