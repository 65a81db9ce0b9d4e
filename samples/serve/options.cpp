// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>
#include <type_traits>

#include "common/user_cache.hpp"

const char* const usage =
    "usage: nicol-serve --scenes DIR [options]\n"
    "Renders the Mitsuba 3 scenes of a folder over HTTP: images, Stokes data and a viewer page.\n"
    "\n"
    "  --scenes DIR            every *.xml, *.gltf and *.glb in it is a scene\n"
    "  --listen ADDRESS:PORT   default 127.0.0.1:8080; port 0 takes one that is free and prints it\n"
    "  --status-listen ADDRESS:PORT\n"
    "                          answers /health, /ready and /metrics there too, with places of its own\n"
    "  --allow-host NAME       answers requests for this host too, beside localhost, the loopback addresses "
    "and\n"
    "                          the address that a request came to; may come several times, '*' for any\n"
    "  --allow-origin ORIGIN   lets pages of this origin, like https://example.org, read the answers "
    "(CORS);\n"
    "                          may come several times, '*' for any\n"
    "  --workers N             processes that render, default one a core\n"
    "  --threads N             of each of them, default 1\n"
    "  --backend NAME          egl or osmesa; without it NICOL_BACKEND decides, else the first that works\n"
    "  --cache DIR             keeps bakes of shadows and tables of materials there; default: NICOL_CACHE,\n"
    "                          where empty none, else the user's cache folder\n"
    "  --read DIR              that workers may read beside that of the scenes; may come several times\n"
    "  --no-sandbox            does not confine workers to these folders and OpenGL's (Landlock)\n"
    "  --allow-upload          lets clients send scenes (POST /v1/scenes), which read no files of this "
    "machine\n"
    "  --keys FILE             keys in hexadecimal, one a line: images then need a signature in their URL\n"
    "  --sign TARGET           prints TARGET (/scenes/...) signed with the first key of --keys, and ends\n"
    "\n"
    "Limits; sizes in bytes, pixels or MiB, times in seconds:\n"
    "  --max-side N            of an image, default 2048\n"
    "  --max-pixels N          of an image, default 2097152\n"
    "  --max-order N           of light, 4 to 64, default 16\n"
    "  --load-bytes-limit N, --vertex-limit N, --triangle-limit N, --load-seconds-limit S\n"
    "                          of each scene with all that it names, each instance counted; default 8 GiB,\n"
    "                          2^26, 2^27 and 600\n"
    "  --memory-limit MIB      of each worker's address space, default 16384, 0 for none\n"
    "  --queue N               length of the queue, default 64; further requests are answered 503\n"
    "  --connections N         open at once, default 512; a further one takes the place of that which waits\n"
    "                          longest for its request, and is answered 503 where none waits\n"
    "  --connections-per-address N\n"
    "                          open at once by one client (IPv6: a /64), default 64, then 429;\n"
    "                          0, as behind a proxy, for any number\n"
    "  --max-header BYTES      of a request, 256 to 1048576, default 8192\n"
    "  --max-body BYTES        of a request, default 1024; bodies are ignored\n"
    "  --max-upload MIB        of an uploaded scene with all its files, 1 to 1024, default 32\n"
    "  --uploads N             uploaded scenes that are kept, 1 to 1000, default 8; a further one takes the "
    "place\n"
    "                          of that which was asked for least recently\n"
    "  --results MIB           of answers kept for equal requests, default 64\n"
    "  --answers MIB           of answers under way or not yet sent; images beyond are refused, default 512\n"
    "  --max-age S             that clients may keep an image without asking, default 0\n"
    "  --deadline S            for an answer, from when the request was read, default 15; then 504\n"
    "  --render-limit S        for one render, default 10; its worker is then replaced\n"
    "  --start-limit S         for a worker to start, and to load and bake a scene, default 600\n"
    "  --slow-scene S          for a scene to be loaded, default 5; a slower one is prepared by a further\n"
    "                          process, while the other scenes are served\n"
    "  --idle-limit S          of a connection without request, default 60\n"
    "  --read-limit S          for a request to arrive, default 10\n"
    "  --write-limit S         for an answer to be taken, default 60\n"
    "  --drain-limit S         for open requests after SIGTERM or SIGINT, default 30\n"
    "\n"
    "  --help                  shows this text\n"
    "  --version               shows the version\n"
    "\n"
    "Exit code 0, or 2 and a one-line message on the standard error.\n";

namespace {

template <class Count = std::uint32_t>
Count parse_count(std::string_view option, std::string_view text, std::type_identity_t<Count> least,
                  std::type_identity_t<Count> most) {
    Count value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < least || value > most)
        throw Failure(std::string(option) + ": '" + std::string(text) + "' is not a whole number from " +
                      std::to_string(least) + " to " + std::to_string(most));
    return value;
}

Seconds parse_seconds(std::string_view option, std::string_view text, double least) {
    constexpr double most = 1e6;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value >= least && value <= most))
        throw Failure(std::string(option) + ": '" + std::string(text) + "' is not a number of seconds from " +
                      (least > 0 ? "0.01" : "0") + " to 1000000");
    return Seconds(value);
}

Endpoint parse_endpoint(std::string_view option, std::string_view text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos || colon == 0)
        throw Failure(std::string(option) + ": '" + std::string(text) +
                      "' is not ADDRESS:PORT, like 127.0.0.1:8080 or [::1]:8080");
    std::string_view address = text.substr(0, colon);
    if (address.starts_with('[') && address.ends_with(']')) address = address.substr(1, address.size() - 2);
    return {.address = std::string(address),
            .port = static_cast<std::uint16_t>(parse_count(option, text.substr(colon + 1), 0, 65535))};
}

std::string parse_folder(std::string_view option, std::string_view text) {
    std::error_code unreadable;
    if (!std::filesystem::is_directory(text, unreadable))
        throw Failure(std::string(option) + ": '" + std::string(text) + "' is no folder");
    return std::string(text);
}

/// Returns a host name without a port, because the port of a request does not matter.
std::string parse_host(std::string_view option, std::string_view text) {
    std::string name(text);
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (name.starts_with('[') && name.ends_with(']')) return name.substr(1, name.size() - 2);
    if (name.find_first_of("/@ ") != std::string::npos || std::ranges::count(name, ':') == 1)
        throw Failure(std::string(option) + ": '" + name +
                      "' is not a host without scheme and port, like images.example.org, or '*'");
    return name;
}

/// Returns an origin as browsers send it: scheme, host, and the port if it is not the scheme's default.
std::string parse_origin(std::string_view option, std::string_view text) {
    const std::size_t scheme = text.find("://");
    const bool good = scheme != std::string_view::npos && scheme > 0 && text.size() > scheme + 3 &&
                      text.find_first_of("/ ", scheme + 3) == std::string_view::npos;
    if (text != "*" && !good)
        throw Failure(std::string(option) + ": '" + std::string(text) +
                      "' is not an origin, like https://example.org or http://localhost:3000, or '*'");
    return std::string(text);
}

nicol_backend parse_backend(std::string_view text) {
    if (text == "egl") return NICOL_BACKEND_EGL;
    if (text == "osmesa") return NICOL_BACKEND_OSMESA;
    throw Failure("--backend: '" + std::string(text) + "' is neither egl nor osmesa");
}

std::uint32_t parse_mib(std::string_view option, std::string_view text) {
    return parse_count(option, text, 0, 4095) << 20u;
}

/// Sets a limit. Returns false if there is no such option.
bool parse_limit(Options& o, std::string_view name, std::string_view text) {
    constexpr std::uint32_t million = 1000000;
    constexpr std::uint64_t whole = std::numeric_limits<std::uint64_t>::max();
    constexpr double shortest = 0.01;
    if (name == "--max-side")
        o.limits.max_side = parse_count(name, text, 1, NICOL_MAX_SIZE);
    else if (name == "--max-pixels")
        o.limits.max_pixels = parse_count(name, text, 1, 1u << 25u);
    else if (name == "--max-order")
        o.limits.max_order = static_cast<std::int32_t>(parse_count(name, text, 4, 64));
    else if (name == "--load-bytes-limit")
        o.load_limits.load_bytes_limit = parse_count<std::uint64_t>(name, text, 1, whole);
    else if (name == "--vertex-limit")
        o.load_limits.vertex_limit = parse_count<std::uint64_t>(name, text, 1, whole);
    else if (name == "--triangle-limit")
        o.load_limits.triangle_limit = parse_count<std::uint64_t>(name, text, 1, whole);
    else if (name == "--load-seconds-limit")
        o.load_limits.load_seconds_limit = parse_seconds(name, text, shortest).count();
    else if (name == "--memory-limit")
        o.memory_bytes = std::uint64_t{parse_count(name, text, 0, 1u << 30u)} << 20u;
    else if (name == "--queue")
        o.queue = parse_count(name, text, 0, million);
    else if (name == "--connections")
        o.connections = parse_count(name, text, 1, million);
    else if (name == "--connections-per-address")
        o.connections_per_address = parse_count(name, text, 0, million);
    else if (name == "--max-header")
        o.header_bytes = parse_count(name, text, 256, 1u << 20u);
    else if (name == "--max-body")
        o.body_bytes = parse_count(name, text, 0, 1u << 20u);
    else if (name == "--max-upload")
        o.upload_bytes = parse_count(name, text, 1, 1024) << 20u;
    else if (name == "--uploads")
        o.upload_places = parse_count(name, text, 1, 1000);
    else if (name == "--results")
        o.result_bytes = parse_mib(name, text);
    else if (name == "--answers")
        o.answer_bytes = parse_mib(name, text);
    else if (name == "--max-age")
        o.max_age = parse_seconds(name, text, 0);
    else if (name == "--deadline")
        o.deadline = parse_seconds(name, text, shortest);
    else if (name == "--render-limit")
        o.render_limit = parse_seconds(name, text, shortest);
    else if (name == "--start-limit")
        o.start_limit = parse_seconds(name, text, shortest);
    else if (name == "--slow-scene")
        o.slow_scene = parse_seconds(name, text, shortest);
    else if (name == "--idle-limit")
        o.idle_limit = parse_seconds(name, text, shortest);
    else if (name == "--read-limit")
        o.read_limit = parse_seconds(name, text, shortest);
    else if (name == "--write-limit")
        o.write_limit = parse_seconds(name, text, shortest);
    else if (name == "--drain-limit")
        o.drain_limit = parse_seconds(name, text, 0);
    else
        return false;
    return true;
}

void parse_option(Options& o, std::string_view name, std::string_view text) {
    constexpr std::uint32_t most_processes = 1024;
    if (name == "--scenes")
        o.scenes = text;
    else if (name == "--listen")
        o.listen = parse_endpoint(name, text);
    else if (name == "--status-listen")
        o.status_listen = parse_endpoint(name, text);
    else if (name == "--read")
        o.readable.push_back(parse_folder(name, text));
    else if (name == "--allow-host")
        o.allowed_hosts.push_back(parse_host(name, text));
    else if (name == "--allow-origin")
        o.allowed_origins.push_back(parse_origin(name, text));
    else if (name == "--workers")
        o.workers = parse_count(name, text, 1, most_processes);
    else if (name == "--threads")
        o.threads = parse_count(name, text, 1, most_processes);
    else if (name == "--backend")
        o.backend = parse_backend(text);
    else if (name == "--cache")
        o.cache = text;
    else if (name == "--keys")
        o.keys = text;
    else if (name == "--sign")
        o.target = text;
    else if (name == "--worker")
        o.socket = static_cast<int>(parse_count(name, text, 0, 1u << 20u));
    else if (!parse_limit(o, name, text))
        throw Failure("unknown option '" + std::string(name) + "'; --help lists them all");
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument == "--help" || argument == "--version") {
            options.action = argument == "--help" ? Options::Action::help : Options::Action::version;
            return options;
        }
        if (argument == "--no-sandbox" || argument == "--allow-upload") {
            (argument == "--no-sandbox" ? options.sandbox : options.uploads) = argument == "--allow-upload";
            continue;
        }
        if (!argument.starts_with("--"))
            throw Failure("unknown argument '" + std::string(argument) + "'; --help lists the options");
        const std::size_t equals = argument.find('=');
        const std::string_view name = argument.substr(0, equals);
        if (equals == std::string_view::npos && i + 1 >= argc)
            throw Failure(std::string(name) + ": a value must follow");
        const std::string_view value =
            equals != std::string_view::npos ? argument.substr(equals + 1) : argv[++i];
        if (value.empty()) throw Failure(std::string(name) + ": the value is empty");
        parse_option(options, name, value);
    }
    if (!options.target.empty()) {
        options.action = Options::Action::sign;
        if (options.keys.empty()) throw Failure("--sign: needs --keys");
        return options;
    }
    if (options.scenes.empty()) throw Failure("no scenes given; usage: nicol-serve --scenes DIR");
    if (options.cache.empty()) options.cache = user_cache_folder();
    if (options.socket >= 0) options.action = Options::Action::worker;
    return options;
}
