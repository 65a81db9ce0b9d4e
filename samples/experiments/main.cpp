// SPDX-License-Identifier: MIT
// nicol-experiments: the paper's numerical experiments, using only the C ABI.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>

#include "experiment.hpp"

namespace {

const char* const usage =
    "usage: nicol-experiments [options] [figure...]\n"
    "Repeats numerical experiments of the paper on polarized spherical harmonics: 7 10 11 13 16 17, all\n"
    "without arguments. Prints tables and writes images.\n"
    "\n"
    "      --out DIR     folder for the images, made when missing; default out/experiments\n"
    "      --light FILE  light of figures 7, 11 and 16, in any format that nicol-render takes;\n"
    "                    default: a sky with three polarized lamps, made here\n"
    "      --polarsh DIR the authors' visibility of a vertex, vis_SHVec_buddha_v17650_256_L9.npz, and their\n"
    "                    matrix of it, vis_TPmat_buddha_v17650_256_L5.npz: compared in figure 13\n"
    "      --quick       figure 16 in order 19 in place of 99\n"
    "      --help        shows this text\n"
    "\n"
    "Exit code 0; 1 where a claim did not hold; 2 and a one-line message on the standard error.\n";

struct Figure {
    const char* name;
    const char* title;
    void (*run)(Experiment&);
};
const Figure figures[] = {
    {"7", "a truncated polarized light, next to a pole of the coordinates", figure_7},
    {"10", "the coefficient matrix of a rotation", figure_10},
    {"11", "truncate, rotate, rotate back", figure_11},
    {"13", "visibility as a matrix", figure_13},
    {"16", "convolution in the angular and in the frequency domain", figure_16},
    {"17", "a pBRDF averaged over rotations becomes a convolution", figure_17},
};

int refuse(const std::string& message) {
    std::fprintf(stderr, "nicol-experiments: %s\n", message.c_str());
    return 2;
}

}  // namespace

void Experiment::claim(bool holds, const std::string& text) {
    std::printf("  [%s] %s\n", holds ? "holds" : "FAILS", text.c_str());
    failed = failed || !holds;
}

std::string Experiment::image(const std::string& name) const {
    std::string path = (out / name).string();
    std::printf("  -> %s\n", path.c_str());
    return path;
}

int main(int argc, char** argv) try {
    Experiment experiment;
    experiment.out = "out/experiments";
    std::vector<const Figure*> wanted;
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        if (name == "--help" || name == "-h") {
            std::fputs(usage, stdout);
            return 0;
        }
        if (name == "--quick") {
            experiment.quick = true;
        } else if (name == "--out" || name == "--light" || name == "--polarsh") {
            if (++i == argc) return refuse(name + ": a value must follow");
            if (name == "--out")
                experiment.out = argv[i];
            else
                (name == "--light" ? experiment.light : experiment.polarsh) = argv[i];
        } else {
            const auto* found =
                std::ranges::find_if(figures, [&](const Figure& f) { return name == f.name; });
            if (found == std::end(figures))
                return refuse("'" + name + "' is neither an option nor one of the figures 7 10 11 13 16 17");
            wanted.push_back(found);
        }
    }
    if (wanted.empty())
        for (const Figure& figure : figures) wanted.push_back(&figure);
    std::filesystem::create_directories(experiment.out);
    for (const Figure* figure : wanted) {
        std::printf("Figure %s: %s\n", figure->name, figure->title);
        figure->run(experiment);
        std::printf("\n");
    }
    return experiment.failed ? 1 : 0;
} catch (const std::exception& error) {
    return refuse(error.what());
}
