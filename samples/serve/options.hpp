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
    std::uint16_t port = 0;  ///< 0: any that is free
};

struct Options {
    enum class Action { serve, help, version, sign, worker };
    Action action = Action::serve;
    std::string scenes;  ///< folder
    Endpoint listen{.address = "127.0.0.1", .port = 8080};
    std::optional<Endpoint> status_listen;  ///< of /health, /ready and /metrics alone
    std::uint32_t workers = 0;              ///< 0: one a core
    std::uint32_t threads = 1;              ///< of each worker
    nicol_backend backend = NICOL_BACKEND_AUTOMATIC;
    std::vector<std::string> allowed_hosts;    ///< in lower case; "*": any
    std::vector<std::string> allowed_origins;  ///< of pages that may read answers; "*": any
    std::string cache;                         ///< folder, empty: what NICOL_CACHE says
    std::vector<std::string> readable;         ///< folders beside that of the scenes
    bool sandbox = true;
    std::string keys;    ///< file, empty: requests need no signature
    std::string target;  ///< to sign
    int socket = -1;     ///< of a worker

    Limits limits;
    nicol_context_options load_limits = NICOL_CONTEXT_OPTIONS_INIT;  ///< no more than its limits of a load
    std::uint64_t memory_bytes = std::uint64_t{16} << 30;            ///< of a worker's address space; 0: any
    std::uint32_t queue = 64;                                        ///< requests that wait for a worker
    std::uint32_t connections = 512;
    std::uint32_t connections_per_address = 64;  ///< 0: any
    std::uint32_t header_bytes = 8192;
    std::uint32_t body_bytes = 1024;
    std::uint32_t result_bytes = 64u << 20u;   ///< of answers kept
    std::uint32_t answer_bytes = 512u << 20u;  ///< of answers under way or not sent yet
    Seconds max_age{0};        ///< that a client may keep an image without asking; 0: asks each time
    Seconds deadline{15};      ///< for an answer
    Seconds render_limit{10};  ///< for one render, after which its worker counts as hung
    Seconds start_limit{600};  ///< for a worker to start, and for it to load a scene
    Seconds slow_scene{5};     ///< for a load, after which the spare worker goes on with it
    Seconds idle_limit{60};    ///< of a connection between requests
    Seconds read_limit{10};    ///< for a request to arrive
    Seconds write_limit{60};   ///< for an answer to be taken
    Seconds drain_limit{30};   ///< for open requests, once told to end
};

/// The text of --help.
extern const char* const usage;

/// Throws Failure naming the argument and what would be right.
Options parse_options(int argc, const char* const* argv);
