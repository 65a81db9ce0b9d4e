// SPDX-License-Identifier: MIT
// An application with a window and an OpenGL context, in which Nicol renders.
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>
#include <vector>

#include "common/failure.hpp"
#include "gl_state.hpp"
#include "options.hpp"
#include "polarized.hpp"
#include "rings.hpp"
#include "stage.hpp"

namespace {

struct Window {
    SDL_Window* window = nullptr;
    SDL_GLContext context = nullptr;

    Window() {
        if (SDL_Init(SDL_INIT_VIDEO) != 0) throw Failure(std::string("SDL: ") + SDL_GetError());
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 4);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 5);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
        window = SDL_CreateWindow("Nicol", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, Stage::kWidth,
                                  Stage::kHeight, SDL_WINDOW_OPENGL);
        if (window != nullptr) context = SDL_GL_CreateContext(window);
        if (context == nullptr) {
            const std::string reason = SDL_GetError();
            close();
            throw Failure("SDL: no window with OpenGL 4.5: " + reason);
        }
    }
    ~Window() { close(); }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

private:
    void close() {
        if (context != nullptr) SDL_GL_DeleteContext(context);
        if (window != nullptr) SDL_DestroyWindow(window);
        SDL_Quit();
    }
};

/// Calls the library and throws Failure if the application's OpenGL state has changed.
template <class Call>
void untouched(const Gl& gl, Call call) {
    const GlState before = gl_state(gl);
    call();
    const std::string changed = difference(before, gl_state(gl));
    if (!changed.empty()) throw Failure("the application's OpenGL state has changed: " + changed);
}

/// Returns whether to continue.
bool handle_events(double& polarizer, bool& paused) {
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) {
        if (event.type == SDL_QUIT) return false;
        if (event.type != SDL_KEYDOWN) continue;
        if (event.key.keysym.sym == SDLK_ESCAPE) return false;
        if (event.key.keysym.sym == SDLK_LEFT) polarizer += 5;
        if (event.key.keysym.sym == SDLK_RIGHT) polarizer -= 5;
        if (event.key.keysym.sym == SDLK_SPACE) paused = !paused;
    }
    return true;
}

void write(const std::string& path, const std::string& head, const void* data, std::size_t bytes) {
    std::ofstream file(path, std::ios::binary);
    file << head;
    file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
    if (!file.flush()) throw Failure(path + " cannot be written");
}

/// Writes a PPM file, top row first.
void write_screenshot(const Gl& gl, const std::string& path) {
    constexpr std::size_t row = std::size_t{3} * Stage::kWidth;
    std::vector<unsigned char> pixels(row * Stage::kHeight);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int y = 0; y < Stage::kHeight; ++y)
        gl.ReadPixels(0, Stage::kHeight - 1 - y, Stage::kWidth, 1, GL_RGB, GL_UNSIGNED_BYTE,
                      pixels.data() + static_cast<std::size_t>(y) * row);
    write(path, "P6\n" + std::to_string(Stage::kWidth) + " " + std::to_string(Stage::kHeight) + "\n255\n",
          pixels.data(), pixels.size());
}

void run(const Options& options) {
    const Window window;
    const Gl gl;
    const Stage stage(gl);
    std::optional<Polarized> polarized;
    if (options.nicol) untouched(gl, [&] { polarized.emplace(options.time_budget); });
    std::optional<Rings> rings;
    if (options.rings) rings.emplace(gl, stage.image(), Stage::kQuadSize);
    double polarizer = options.polarizer;
    bool paused = false;
    int moment = 0;  // frames that moved
    for (int frame = 0; handle_events(polarizer, paused) && (options.frames == 0 || frame < options.frames);
         ++frame) {
        if (frame > 0 && frame == options.pause) paused = true;
        if (frame > 0 && !paused) ++moment;
        stage.draw_triangles(moment);
        if (polarized) {
            // One ring is there before the ball, which hides what is behind it; the other one comes after,
            // and is hidden by the ball's depth.
            if (rings) {
                rings->clear();
                rings->draw(0, moment);
            }
            untouched(gl, [&] {
                polarized->draw(2.0 * moment, polarizer, stage.image(), rings ? rings->depth() : 0,
                                Rings::kNear);
            });
            if (rings) rings->draw(1, moment);
            stage.draw_quad(3.0 * moment);
        }
        if (frame + 1 == options.frames && !options.screenshot.empty())
            write_screenshot(gl, options.screenshot);
        SDL_GL_SwapWindow(window.window);
    }
    if (!options.planes.empty()) {
        const std::vector<float> planes = polarized->planes();
        write(options.planes, "", planes.data(), planes.size() * sizeof(float));
    }
    if (polarized) untouched(gl, [&] { polarized.reset(); });
}

}  // namespace

int main(int count, char** arguments) try {
    const Options options = parse(count, arguments);
    if (options.help) {
        static_cast<void>(std::fputs(usage, stdout));
        return 0;
    }
    run(options);
    return 0;
} catch (const std::exception& error) {
    static_cast<void>(std::fprintf(stderr, "nicol-host: %s\n", one_line(error.what()).c_str()));
    return 2;
}
