// SPDX-License-Identifier: MIT
// The command line of nicol-serve.
#pragma once

#include <nicol.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/failure.hpp"
#include "image_request.hpp"

using Seconds = std::chrono::duration<double>;

struct Endpoint {
    std::string address;
    std::uint16_t port = 0;  ///< 0: any free port
};

struct Options {
    enum class Action { serve, help, version, sign, worker };
    Action action = Action::serve;
    std::string scenes;  ///< folder
    Endpoint listen{.address = "127.0.0.1", .port = 8080};
    std::optional<Endpoint> status_listen;  ///< listener of only /health, /ready and /metrics
    std::uint32_t workers = 0;              ///< 0: one per core
    std::uint32_t threads = 1;              ///< threads per worker
    nicol_backend backend = NICOL_BACKEND_AUTOMATIC;
    std::vector<std::string> allowed_hosts;    ///< in lower case; "*": any
    std::vector<std::string> allowed_origins;  ///< origins of pages that may read answers; "*": any
    std::string cache;                         ///< folder; empty: NICOL_CACHE decides, or none
    std::vector<std::string> readable;         ///< folders besides that of the scenes
    bool sandbox = true;
    bool uploads = false;  ///< whether clients may send scenes
    std::string keys;      ///< file; empty: requests need no signature
    std::string target;    ///< target to sign
    int socket = -1;       ///< socket of a worker

    Limits limits;
    nicol_context_options load_limits = NICOL_CONTEXT_OPTIONS_INIT;  ///< only its limits of loading are used
    std::uint64_t memory_bytes = std::uint64_t{16} << 30;  ///< address space of a worker; 0: unlimited
    std::uint32_t queue = 64;                              ///< requests waiting for a worker
    std::uint32_t connections = 512;
    std::uint32_t connections_per_address = 64;  ///< 0: unlimited
    std::uint32_t header_bytes = 8192;
    std::uint32_t body_bytes = 1024;
    std::uint32_t upload_bytes = 32u << 20u;   ///< largest body of an uploaded scene
    std::uint32_t upload_places = 8;           ///< uploaded scenes that are kept
    std::uint32_t result_bytes = 64u << 20u;   ///< answers kept in the cache
    std::uint32_t answer_bytes = 512u << 20u;  ///< answers under way or not yet sent
    Seconds max_age{0};        ///< time that clients may keep an image without asking; 0: ask each time
    Seconds deadline{15};      ///< time for an answer
    Seconds render_limit{10};  ///< time for one render, after which its worker counts as hung
    Seconds start_limit{600};  ///< time for a worker to start, and for it to load a scene
    Seconds slow_scene{5};     ///< time for a load, after which the spare worker continues it
    Seconds idle_limit{60};    ///< time of a connection between requests
    Seconds read_limit{10};    ///< time for a request to arrive
    Seconds write_limit{60};   ///< time for the client to receive an answer
    Seconds drain_limit{30};   ///< time for open requests at the end
};

/// Text of --help.
extern const char* const usage;

/// Parses the command line. Throws Failure naming the argument and the valid values.
Options parse_options(int argc, const char* const* argv);
