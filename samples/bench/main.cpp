// SPDX-License-Identifier: MIT
// nicol-bench: run times and errors of Nicol, as ratios within one run.
#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

#include "commands.hpp"
#include "options.hpp"
#include "report.hpp"

namespace {

struct Command {
    const char* name;
    Report (*run)(const Options&);
    std::vector<const char*> options;
    const char* summary;
};

const Command commands[] = {
    {"error",
     bench_error,
     {"SCENE.xml", "-D", "--light", "--backend", "--cache", "--size", "--samples", "--orders", "--memory",
      "--converged", "--csv", "--json"},
     "distance from the reference method by order, dense and factored, with and without\n"
     "              shadows, and with each form of the high orders"},
    {"materials",
     bench_materials,
     {"--light", "--backend", "--cache", "--size", "--samples", "--orders", "--csv", "--json"},
     "distance of each form of the high orders from the reference method on spheres of\n"
     "              smooth and rough plastic, gold and, where NICOL_TEST_DATA has it, measured gold"},
    {"coarse",
     bench_coarse,
     {"--light", "--backend", "--cache", "--size", "--samples", "--orders", "--csv", "--json"},
     "errors of a mesh of few triangles at vertices and at pixels, beside each triangle split in\n"
     "              sixteen, under lamps and in the forest"},
    {"lights",
     bench_lights,
     {"--backend", "--cache", "--size", "--samples", "--seconds", "--csv", "--json"},
     "errors of local lights and of lights extracted from their environment, and what they\n"
     "              add to a frame"},
    {"textures",
     bench_textures,
     {"--light", "--backend", "--cache", "--size", "--samples", "--orders", "--csv", "--json"},
     "errors of a plastic whose albedo, roughness and normals vary by textures, on a sphere and\n"
     "              on a floor under it"},
    {"places",
     bench_places,
     {"--backend", "--cache", "--size", "--samples", "--csv", "--json"},
     "errors far from the origin, on large floors and of close depths"},
    {"bounces",
     bench_bounces,
     {"--backend", "--cache", "--size", "--samples", "--csv", "--json"},
     "light that surfaces reflect to each other: what is missing without it, by rays and by\n"
     "              default"},
    {"glass",
     bench_glass,
     {"--backend", "--cache", "--size", "--samples", "--seconds", "--csv", "--json"},
     "spheres of glass and mirrors and a pane in the forest, against rays, and their frames beside\n"
     "              one of plastic"},
    {"extremes",
     bench_extremes,
     {"--backend", "--cache", "--size", "--samples", "--only", "--csv", "--json"},
     "errors of brushed and nearly smooth surfaces, narrow openings, close lights and a fine\n"
     "              checkerboard"},
    {"frame",
     bench_frame,
     {"SCENE.xml", "-D", "--light", "--backend", "--cache", "--size", "--orders", "--memory", "--seconds",
      "--csv", "--json"},
     "frames after a move of the camera, a rotation of the light and no change, beside\n"
     "              drawing the triangles in one colour"},
    {"edit",
     bench_edit,
     {"--backend", "--cache", "--size", "--only", "--csv", "--json"},
     "what a moved, added or removed object, a new material and a new light cost a frame"},
    {"motion",
     bench_motion,
     {"--backend", "--cache", "--size", "--only", "--csv", "--json"},
     "frames in which objects move, within a bake_budget_ms of 8: time, error, frames to the end"},
    {"views",
     bench_views,
     {"--backend", "--cache", "--size", "--csv", "--json"},
     "the six faces of a cube in one call, beside one face and six calls"},
    {"budget",
     bench_budget,
     {"--backend", "--cache", "--size", "--only", "--csv", "--json"},
     "frames within a time_budget_ms of 16, 33 and 100, and what they give up"},
    {"pareto",
     bench_pareto,
     {"SCENE.xml", "-D", "--light", "--backend", "--cache", "--size", "--samples", "--orders", "--memory",
      "--seconds", "--plot", "--peer", "--csv", "--json"},
     "run time against error, over orders"},
    {"price",
     bench_price,
     {"SCENE.xml", "-D", "--backend", "--cache", "--size", "--orders", "--seconds", "--csv", "--json"},
     "what polarization costs beside scalar spherical harmonics for s0 alone: time, memory, by order"},
    {"adjoint",
     bench_adjoint,
     {"SCENE.xml", "-D", "--light", "--backend", "--cache", "--size", "--csv", "--json"},
     "gradients by the environment beside pictures whose light rotates, by order"},
    {"bake",
     bench_bake,
     {"SCENE.xml", "-D", "--light", "--backend", "--csv", "--json"},
     "visibility at the vertices: rays a second, time, memory, cache"},
    {"calls",
     bench_calls,
     {"SCENE.xml", "--cache", "--size", "--csv", "--json"},
     "OpenGL calls of a frame inside a host's context, queries and glGetError among them"},
    {"dataset",
     bench_dataset,
     {"SCENE.xml", "-D", "--light", "--backend", "--cache", "--size", "--csv", "--json"},
     "pictures a minute, from rendering alone to both files of each, and with new objects"},
    {"scale",
     bench_scale,
     {"--backend", "--cache", "--size", "--orders", "--seconds", "--large", "--csv", "--json"},
     "cost against the number of vertices and against the order"},
    {"tolerance",
     bench_tolerance,
     {"SCENE.xml", "-D", "--light", "--backend", "--cache", "--size", "--samples", "--csv", "--json"},
     "requested, predicted and measured errors"},
    {"skip",
     bench_skip,
     {"--backend", "--cache", "--size", "--seconds", "--csv", "--json"},
     "what each optimisation saves in a scene that allows it"},
    {"start",
     bench_start,
     {"SCENE.xml", "-D", "--light", "--backend", "--size", "--only", "--csv", "--json"},
     "time to the first image, with an empty and a warm cache"},
    {"engine",
     bench_engine,
     {"--size", "--samples", "--csv", "--json"},
     "frames of a host's OpenGL (10,000, or --samples) in which an object moves, the window changes\n"
     "              its size and a job runs: times, memory, OpenGL names"},
    {"waits",
     bench_waits,
     {"SCENE.xml", "--backend", "--size", "--csv", "--json"},
     "longest time of each function, alone and while a job runs"},
    {"harmonics",
     [](const Options& options) { return bench_harmonics(options.seconds); },
     {"--seconds", "--csv", "--json"},
     "transforms, rotation and projection of polarized spherical harmonics"},
};

struct Help {
    const char* name;
    const char* text;
};
const Help option_help[] = {
    {"SCENE.xml", "SCENE.xml       a scene for nicol-render; default the snail of samples/assets"},
    {"-D", "-D NAME=VALUE   replaces a default of the scene; may be repeated"},
    {"--light", "--light FILE    replaces the scene's light"},
    {"--backend", "--backend NAME  egl or osmesa; default as the library chooses"},
    {"--cache", "--cache DIR     keeps tables there; default a folder that is removed at the end"},
    {"--size", "--size N        images of N x N, 8 to 4096"},
    {"--samples", "--samples N     of each of the two reference images, a pixel; default 256"},
    {"--orders",
     "--orders A-B    from order A to B, 0 to 32 (frame: low order A, high order B;\n                  "
     "materials, textures: the same; without it 4 and 64, 9 and 64)"},
    {"--only", "--only TEXT     measures the rows whose names contain it"},
    {"--converged",
     "--converged N   errors against the factored method to order N too, 1 to 32: truncation alone"},
    {"--memory", "--memory GB     most that matrices of the dense method may take; default 4"},
    {"--seconds", "--seconds S     of measurement for each line of the table; default 1"},
    {"--large", "--large         2,000,000 vertices too"},
    {"--plot", "--plot FILE     writes the curves as SVG"},
    {"--peer",
     "--peer FILE     one panel, with the curve of another program: its name, then lines of\n                "
     "  "
     "label,ms,s0,s1,s2"},
    {"--csv", "--csv FILE      writes the table as CSV"},
    {"--json", "--json FILE     writes the table as JSON"},
};

void print_usage(std::ostream& out) {
    out << "usage: nicol-bench SUB-COMMAND [options]\n";
    for (const Command& command : commands)
        out << "  " << command.name << std::string(12 - std::string(command.name).size(), ' ')
            << command.summary << '\n';
    out << "nicol-bench SUB-COMMAND --help lists its options.\n";
}

void print_help(std::ostream& out, const Command& command) {
    out << "usage: nicol-bench " << command.name << " [options]\n  " << command.summary << "\noptions:\n";
    for (const Help& help : option_help) {
        if (std::ranges::any_of(command.options,
                                [&](const char* name) { return std::string(name) == help.name; }))
            out << "  " << help.text << '\n';
    }
}

// A file that a table goes to. It is opened before the measurement, so that a path that cannot be written
// costs none.
class TableFile {
public:
    explicit TableFile(std::string path) : path_(std::move(path)) {
        if (path_.empty()) return;
        out_.open(path_);
        check();
    }

    template <class Write>
    void write(Write write) {
        if (path_.empty()) return;
        write(out_);
        out_.close();
        check();
    }

private:
    void check() const {
        if (!out_) throw std::runtime_error(path_ + ": cannot be written");
    }

    std::string path_;
    std::ofstream out_;
};

void run(const Command& command, std::span<char* const> arguments) {
    const Options options = parse_options(arguments, command.options);
    TableFile csv(options.csv), json(options.json);
    const Report report = command.run(options);
    report.print(std::cout);
    csv.write([&](std::ostream& out) { report.write_csv(out); });
    json.write([&](std::ostream& out) { report.write_json(out); });
}

}  // namespace

int main(int count, char** arguments) {
    const std::string name = count > 1 ? arguments[1] : "";
    const auto* command = std::ranges::find_if(commands, [&](const Command& c) { return name == c.name; });
    if (command == std::end(commands)) {
        const bool requested = name == "--help";
        print_usage(requested ? std::cout : std::cerr);
        return requested ? 0 : 2;
    }
    const std::span<char* const> rest(arguments + 2, static_cast<std::size_t>(count - 2));
    if (std::ranges::any_of(rest, [](const char* a) { return std::string(a) == "--help"; })) {
        print_help(std::cout, *command);
        return 0;
    }
    try {
        run(*command, rest);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "nicol-bench " << name << ": " << error.what() << '\n';
        return 2;
    }
}
