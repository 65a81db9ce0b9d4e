// SPDX-License-Identifier: MIT
// Tests of the program cache on disk.
#include "gl/program_cache.hpp"

#include "gl/contexts.hpp"
#include "gl/draw.hpp"
#include "gl/object.hpp"
#include "gl/test_shaders.hpp"
#include "temporary_folder.hpp"

using namespace nicol;
using namespace nicol::gl;

namespace {

namespace fs = std::filesystem;

Program make(const std::shared_ptr<Context>& context, const std::string& wide) {
    const std::array<Define, 2> defines{{{"WIDE", wide}, {"HIGH", "2.0"}}};
    return Program::graphics(context, embedded_shader("fullscreen.vert"), test_shader("lines.frag"), defines);
}

float drawn(const std::shared_ptr<Context>& context, const Program& program) {
    RenderTarget target(context, {1, 1, 1, false});
    draw_fullscreen(target, program);
    std::array<float, 4> pixel{};
    target.read(0, pixel);
    return pixel[2];
}

bool keep(Context& context, const TemporaryFolder& folder) {
    keep_programs(context, folder.path());
    if (ProgramCache(context).enabled()) return true;
    MESSAGE("skipped: the driver has no form to keep programs in");
    return false;
}

}  // namespace

GL_THREAD_TEST_CASE("a program is kept once and serves again") {
    const TemporaryFolder folder;
    CHECK(drawn(context, make(context, "1.5")) == 1.5F);
    CHECK(folder.names().empty());
    if (!keep(*context, folder)) return;
    CHECK(drawn(context, make(context, "1.5")) == 1.5F);
    REQUIRE(folder.names().size() == 1);
    // A second write would replace the file and separate it from its second name.
    const fs::path kept = folder / *folder.names().begin();
    fs::create_hard_link(kept, folder / "second name");
    CHECK(drawn(context, make(context, "1.5")) == 1.5F);
    CHECK(fs::hard_link_count(kept) == 2);
    fs::remove(folder / "second name");
    CHECK(drawn(context, make(context, "3.5")) == 3.5F);
    CHECK(folder.names().size() == 2);
    keep_programs(*context, {});
    CHECK(drawn(context, make(context, "4.5")) == 4.5F);
    CHECK(folder.names().size() == 2);
}

GL_THREAD_TEST_CASE("what is loaded is what was kept, with its uniforms") {
    const TemporaryFolder folder;
    if (!keep(*context, folder)) return;
    const ProgramCache cache(*context);
    ProgramKey key;
    key.add(1, "anything");
    const Object loaded(context, ObjectKind::program);
    CHECK_FALSE(cache.load(key, loaded.id()));
    cache.store(key, make(context, "5.5").id());
    CHECK(cache.load(key, loaded.id()));
    ProgramKey other;
    other.add(2, "anything");
    CHECK_FALSE(cache.load(other, loaded.id()));
    // Uniforms behave equally in compiled and in loaded programs.
    for (int i = 0; i < 2; ++i) {
        Program program = Program::compute(context, test_shader("uniforms.comp"));
        CHECK_THROWS_AS(program.set("no such uniform", 1), Error);
        CHECK(program.is_compute());
        CHECK(program.label() == "uniforms.comp");
    }
}

GL_THREAD_TEST_CASE(
    "stale and damaged programs are made anew, and a folder that cannot be used is no error") {
    const TemporaryFolder folder;
    if (!keep(*context, folder)) return;
    static_cast<void>(make(context, "1.5"));
    REQUIRE(folder.names().size() == 1);
    const fs::path file = folder / *folder.names().begin();
    const std::string good = file_bytes(file);
    for (const std::size_t at : {std::size_t{3}, good.size() / 2, good.size() - 1}) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 1);
        for (const std::string& content : {bad, good.substr(0, at), std::string()}) {
            folder.write(file.filename().string(), content);
            CHECK(drawn(context, make(context, "1.5")) == 1.5F);
            CHECK(file_bytes(file).size() == good.size());
        }
    }
    ProgramKey key;
    key.add(1, "anything");
    const ProgramCache cache(*context);
    fs::remove_all(folder.path());
    std::ofstream(folder.path()) << "a file where the folder should be";
    CHECK(drawn(context, make(context, "2.5")) == 2.5F);
    cache.store(key, make(context, "2.5").id());
    const Object none(context, ObjectKind::program);
    CHECK_FALSE(cache.load(key, none.id()));
}

// Drivers of equal names and version can have different binary forms, as Mesa's EGL and OSMesa do.
TEST_CASE("backends that share a folder refuse no programs of each other") {
    const TemporaryFolder folder;
    std::vector<std::string> notices;
    for (int pass = 0; pass < 2; ++pass)
        for (const Backend backend : every_backend()) {
            CAPTURE(name_of(backend));
            const std::shared_ptr<Context> context = make_context(backend);
            context->run([&] {
                keep_programs(*context, folder.path(),
                              [&](const std::string& notice) { notices.push_back(notice); });
                CHECK(drawn(context, make(context, "1.5")) == 1.5F);
            });
        }
    CAPTURE(notices.size());
    CHECK(notices.empty());
}
