// SPDX-License-Identifier: MIT
// What each URL means: requests become answers, or images to be rendered.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "answer_rooms.hpp"
#include "metrics.hpp"
#include "pool.hpp"
#include "problem.hpp"
#include "result_cache.hpp"

/// The parts of a request that the service uses.
struct Request {
    std::string method, target, if_none_match, accept_encoding;
    std::string host;           ///< header; empty if there is none
    std::string authority;      ///< the host that the target names, if it names one
    std::string origin;         ///< header, of requests by pages
    std::string local;          ///< numeric address that the connection came to
    bool status_alone = false;  ///< of a listener that has nothing else
};

struct Response {
    int status = 200;
    std::string type = "application/json";
    std::vector<std::pair<std::string, std::string>> headers = {};
    std::shared_ptr<const void> owner = {};  ///< of the content
    std::string_view content = {};
};

/// An image that has to be made.
struct Render {
    ImageRequest request;
    std::string tag = {};                   ///< its entity tag, quotes included; the same for equal requests
    std::shared_ptr<AnswerRoom> room = {};  ///< in memory, for the answer
};

class Service {
public:
    Service(const Options& options, Pool& pool, Metrics& metrics);

    /// Never throws: what goes wrong is an answer too.
    std::variant<Response, Render> handle(const Request& request);
    /// The answer to an image's request, once there is one.
    Response respond(const Render& render, const AnswerPtr& answer);
    Response respond(const Problem& problem) const;
    /// When to come again, in seconds: about when the queue of now is done.
    [[nodiscard]] int retry_after() const;

    bool draining = false;
    std::function<std::size_t()> connections;  ///< for the metrics

private:
    std::variant<Response, Render> route(const Request& request);
    std::variant<Response, Render> image(const Request& request, const Target& target);
    [[nodiscard]] static Response tagged(int status, const Render& render);
    [[nodiscard]] Response text(std::string type, std::string content) const;
    [[nodiscard]] Response scenes() const;
    [[nodiscard]] Response state(bool must_be_ready) const;
    [[nodiscard]] Response page(const Request& request, const Target& target) const;
    [[nodiscard]] std::string metrics_text() const;
    [[nodiscard]] const std::vector<SceneLoads::Scene>& scenes_known() const;

    const Options& options_;
    Pool& pool_;
    Metrics& metrics_;
    ResultCache cache_;
    std::vector<std::string> keys_;
    std::string build_;  ///< of the library, part of every entity tag
    std::string openapi_;
    AnswerRooms rooms_;
};
