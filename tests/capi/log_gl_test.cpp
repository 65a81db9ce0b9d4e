// SPDX-License-Identifier: MIT
// Tests of the log: messages, severities and completeness.
#include <atomic>
#include <mutex>
#include <thread>

#include "capi.hpp"
#include "image/stokes_image.hpp"

using namespace capi_test;

namespace {

struct Entry {
    std::uint32_t severity;
    nicol_result code;
    std::string message;
};

class Log {
public:
    static void callback(void* user, std::uint32_t severity, nicol_result code, const char* message) {
        auto& log = *static_cast<Log*>(user);
        const std::lock_guard lock(log.mutex_);
        log.entries_.push_back({severity, code, message});
    }
    /// Removes and returns the entries since the last call.
    std::vector<Entry> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(entries_, {});
    }

private:
    std::mutex mutex_;
    std::vector<Entry> entries_;
};

nicol_context logging_context(nicol_backend backend, Log& log, const std::string& cache) {
    nicol_context_options options = two_threads(backend);
    options.log = Log::callback;
    options.log_user = &log;
    options.cache_folder = cache.c_str();
    return make(nicol_context_create, &options);
}

std::size_t count_of(const std::vector<Entry>& entries, const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        entries, [&](const Entry& entry) { return entry.message.find(text) != std::string::npos; }));
}

}  // namespace

TEST_CASE("a new context tells what it opened") {
    for (const nicol_backend backend : every_backend()) {
        Log log;
        const nicol_context context = logging_context(backend, log, "");
        nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
        OK(nicol_context_get_info(context, &info));
        const std::vector<Entry> entries = log.take();
        REQUIRE_FALSE(entries.empty());
        CHECK(entries[0].severity == NICOL_LOG_INFO);
        CHECK(entries[0].code == NICOL_OK);
        CHECK(entries[0].message.find(info.renderer) != std::string::npos);
        for (std::size_t i = 1; i < entries.size(); ++i) CHECK(entries[i].severity == NICOL_LOG_WARNING);
        OK(nicol_context_release(context));
        CHECK(log.take().empty());
    }
}

TEST_CASE("every notice of a scene file arrives, once, in one line") {
    for (const nicol_backend backend : every_backend()) {
        Log log;
        const Owned context(logging_context(backend, log, ""));
        static_cast<void>(log.take());
        const TemporaryFolder folder;
        const std::string path = folder.write("a\n\x1b[31m.xml", R"(<scene version="3.0.0">
            <integrator type="path"><integer name="max_depth" value="7"/></integrator>
            <sensor type="perspective"><float name="fov" value="50"/>
                <film type="hdrfilm"><string name="pixel_format" value="rgba"/>
                    <string name="component_format" value="float16"/></film></sensor>
            <shape type="cube"/></scene>)");
        const Owned scene(make(nicol_scene_load, context, path.c_str(), nullptr, 0U));
        const std::vector<Entry> entries = log.take();
        for (const char* about : {"path", "alpha", "float32"}) CHECK(count_of(entries, about) >= 1);
        std::set<std::string> messages;
        for (const Entry& entry : entries) {
            CHECK(entry.severity == NICOL_LOG_NOTICE);
            CHECK(entry.code == NICOL_OK);
            CHECK(std::ranges::none_of(entry.message, [](unsigned char c) { return c < ' '; }));
            messages.insert(entry.message);
        }
        CHECK(messages.size() == entries.size());
    }
}

namespace {

// Causes one notice of a context: light with negative radiance, which is set to 0.
void cause_notice(nicol_context context) {
    const float stokes[24] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -0.1F};
    nicol_image pixels = NICOL_IMAGE_INIT;
    pixels.width = 2, pixels.height = 3, pixels.channels = 1, pixels.components = 4;
    pixels.pixels = stokes;
    pixels.byte_size = sizeof stokes;
    const Owned made(make(nicol_environment_create_image, context, &pixels));
}

}  // namespace

TEST_CASE("the log is replaced and silenced, but not from its own callback") {
    Log first;
    Log second;
    const Owned context(logging_context(NICOL_BACKEND_OSMESA, first, ""));
    static_cast<void>(first.take());
    OK(nicol_context_set_log(context, Log::callback, &second));
    cause_notice(context);
    CHECK(first.take().empty());
    CHECK(second.take().size() == 1);
    OK(nicol_context_set_log(context, nullptr, nullptr));
    cause_notice(context);
    CHECK(second.take().empty());

    struct Caller {
        nicol_context context;
        nicol_result result = NICOL_OK;
    } caller{context};
    OK(nicol_context_set_log(
        context,
        [](void* user, std::uint32_t, nicol_result, const char*) {
            auto& from = *static_cast<Caller*>(user);
            from.result = nicol_context_set_log(from.context, nullptr, nullptr);
        },
        &caller));
    cause_notice(context);
    CHECK(caller.result == NICOL_ERROR_INVALID_ARGUMENT);
}

TEST_CASE("no thread is in a log callback that was replaced") {
    Log none;
    const Owned context(logging_context(NICOL_BACKEND_OSMESA, none, ""));
    struct State {
        std::atomic<bool> inside = false, replacing = false;
    } state;
    OK(nicol_context_set_log(
        context,
        [](void* user, std::uint32_t, nicol_result, const char*) {
            auto& shared = *static_cast<State*>(user);
            shared.inside = true;
            while (!shared.replacing) std::this_thread::yield();
            for (int i = 0; i < 1000; ++i) std::this_thread::yield();
            shared.inside = false;
        },
        &state));
    const std::jthread other([&] { cause_notice(context); });
    while (!state.inside) std::this_thread::yield();
    state.replacing = true;
    OK(nicol_context_set_log(context, nullptr, nullptr));
    CHECK_FALSE(state.inside);
}

TEST_CASE("negative radiance that is set to 0 is one notice, however the light comes") {
    Log log;
    const Owned context(logging_context(NICOL_BACKEND_OSMESA, log, ""));
    static_cast<void>(log.take());
    const TemporaryFolder folder;
    nicol::StokesImage image(4, 5, 1);
    for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = 1;
    image.at(0, 2, 1)[0] = -0.5F;
    const std::string file = folder.file("ringing.exr");
    nicol::write_exr(file, image);
    const std::string scene_file = folder.write("scene.xml", R"(<scene version="3.0.0">
        <sensor type="perspective"/><shape type="cube"/>
        <emitter type="envmap"><string name="filename" value="ringing.exr"/></emitter></scene>)");
    nicol_image pixels = NICOL_IMAGE_INIT;
    pixels.width = 4, pixels.height = 5, pixels.channels = 1, pixels.components = 4;
    pixels.pixels = image.data.data();
    pixels.byte_size = 4 * image.data.size();

    const auto only_notice = [&] {
        const std::vector<Entry> entries = log.take();
        CHECK(entries.size() == 1);
        return entries.empty() ? "" : entries[0].message;
    };
    const Owned loaded(make(nicol_environment_load, context, file.c_str(), nullptr));
    CHECK(only_notice().find("ringing.exr: has negative radiance, up to ") != std::string::npos);
    const Owned scene(make(nicol_scene_load, context, scene_file.c_str(), nullptr, 0U));
    CHECK(only_notice().find("ringing.exr: has negative radiance, up to ") != std::string::npos);
    const Owned made(make(nicol_environment_create_image, context, &pixels));
    CHECK(only_notice().find("image: has negative radiance, up to ") != std::string::npos);
}

TEST_CASE("caches that are damaged or cannot be kept are notices, from jobs too") {
    for_all({NICOL_BACKEND_EGL, NICOL_BACKEND_OSMESA}, {false, true}, [](nicol_backend backend, bool as_job) {
        Log log;
        const TemporaryFolder folder;
        const auto notices = [&](const std::string& cache) {
            const Owned context(logging_context(backend, log, cache));
            const Stage stage(context);
            if (as_job) {
                const Owned job(
                    make(nicol_render_async, stage.scene, &stage.camera, nullptr, stage.framebuffer));
                OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));
            } else {
                stage.render();
            }
            std::vector<Entry> entries = log.take();
            std::erase_if(entries, [](const Entry& entry) { return entry.severity == NICOL_LOG_INFO; });
            for (const Entry& entry : entries) CHECK(entry.severity == NICOL_LOG_NOTICE);
            return entries;
        };
        const std::string cache = folder.file("cache");
        CHECK(notices(cache).empty());
        std::vector<std::string> files;  // tables, visibility and linked programs
        for (const std::filesystem::path& file : files_in(cache)) {
            std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
            files.push_back(file.filename().string());
        }
        REQUIRE(files.size() >= 2);
        const std::vector<Entry> damaged = notices(cache);
        CHECK(damaged.size() == files.size());
        for (const std::string& file : files) CHECK(count_of(damaged, file) == 1);
        CHECK(notices(cache).empty());
        CHECK_FALSE(notices(folder.write("file", "not a folder")).empty());
    });
}

TEST_CASE("the noise of light samples is predicted, and told once where it exceeds the tolerance") {
    for (const nicol_backend backend : every_backend()) {
        Log log;
        const Owned context(logging_context(backend, log, ""));
        const TemporaryFolder folder;
        const std::string path = folder.write("square.xml", R"(<scene version="3.0.0">
            <sensor type="perspective"><float name="fov" value="40"/>
                <transform name="to_world"><lookat origin="0,3,4" target="0,0,0" up="0,1,0"/></transform>
                <film type="hdrfilm"><integer name="width" value="24"/>
                    <integer name="height" value="16"/></film></sensor>
            <shape type="rectangle"><transform name="to_world"><rotate x="1" angle="-90"/>
                <scale value="5"/></transform></shape>
            <shape type="rectangle"><transform name="to_world"><rotate x="1" angle="90"/>
                <translate y="0.5"/></transform><emitter type="area"/></shape></scene>)");
        const LoadedScene loaded(context, path);
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        options.tolerance = 1;
        std::vector<double> predicted;
        for (const std::uint32_t samples : {4U, 64U, 1024U}) {
            options.light_samples = samples;
            OK(nicol_render(loaded.scene, &loaded.camera, &options, loaded.framebuffer));
            predicted.push_back(statistics_of(loaded.framebuffer).predicted_error);
            OK(nicol_render(loaded.scene, &loaded.camera, &options,
                            loaded.framebuffer));  // what is kept has the same error
            CHECK(statistics_of(loaded.framebuffer).predicted_error == predicted.back());
        }
        CHECK(predicted[0] < 1);
        CHECK(predicted[1] < 0.5 * predicted[0]);
        CHECK(predicted[2] < 0.5 * predicted[1]);
        CHECK(predicted[2] > 0);

        static_cast<void>(log.take());
        for (const double tolerance : {2 * predicted[2], 0.5 * predicted[2], 0.4 * predicted[2]}) {
            options.tolerance = tolerance;
            OK(nicol_render(loaded.scene, &loaded.camera, &options, loaded.framebuffer));
            const std::vector<Entry> entries = log.take();
            CAPTURE(tolerance);
            CHECK(count_of(entries, "light_samples") == (tolerance == 0.5 * predicted[2] ? 1 : 0));
            for (const Entry& entry : entries) CHECK(entry.message.find("square.xml") != std::string::npos);
        }
    }
}
