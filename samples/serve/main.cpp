// SPDX-License-Identifier: MIT
// nicol-serve: images of polarized light over HTTP, using only the C ABI.
#include <cstdio>
#include <exception>

#include "common/failure.hpp"
#include "options.hpp"
#include "server.hpp"
#include "signature.hpp"
#include "worker.hpp"

namespace {

int run(const Options& options, std::vector<std::string> arguments) {
    switch (options.action) {
        case Options::Action::help:
            std::fputs(usage, stdout);
            return 0;
        case Options::Action::version:
            std::printf("nicol-serve %s\n", nicol_version_string());
            return 0;
        case Options::Action::sign:
            std::printf("%s\n", signed_target(options.target, read_keys(options.keys).front()).c_str());
            return 0;
        case Options::Action::worker:
            return run_worker(options.socket, options);
        default:
            Server(options, std::move(arguments)).run();
            return 0;
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(parse_options(argc, argv), std::vector<std::string>(argv, argv + argc));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nicol-serve: %s\n", one_line(error.what()).c_str());
    } catch (...) {
        std::fputs("nicol-serve: an unknown error\n", stderr);
    }
    return 2;
}
