// SPDX-License-Identifier: MIT
// The meaning of URLs: requests become answers or images to be rendered.
#pragma once

#include <functional>
#include <memory>
#include <optional>
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
    std::string method, target, if_none_match, range, if_range, accept_encoding;
    std::string host;       ///< Host header; empty if there is none
    std::string authority;  ///< host in the target, if any
    std::string origin;     ///< Origin header, sent by pages
    std::string local;      ///< numeric address of the connection's local end
    std::string accept = {}, content_type = {};
    std::string_view body = {};
    bool has_upload_room = false;  ///< holds a room of upload_room()
    bool status_alone = false;     ///< from a listener that serves only the status
};

struct Response {
    int status = 200;
    std::string type = "application/json";
    std::vector<std::pair<std::string, std::string>> headers = {};
    std::shared_ptr<const void> owner = {};  ///< owner of the content
    std::string_view content = {};
    bool is_last = false;  ///< the connection closes after it
};

/// An image to be rendered.
struct Render {
    ImageRequest request;
    std::string tag = {};                   ///< entity tag, quotes included; equal for equal requests
    std::string range = {}, if_range = {};  ///< headers that ask for a part of the answer
    std::shared_ptr<AnswerRoom> room = {};  ///< memory reserved for the answer
    std::string events_url = {};            ///< address of the image if events of its render are wanted
};

class Service {
public:
    Service(const Options& options, Pool& pool, Metrics& metrics);

    /// Answers a request. Never throws: failures are answers, too.
    std::variant<Response, Render> handle(const Request& request);
    /// Returns the answer to an image's request.
    Response respond(const Render& render, const AnswerPtr& answer);
    Response respond(const Problem& problem) const;
    /// Returns the answer to a request whose body would be an uploaded scene but is refused without it.
    std::optional<Response> refused_upload(const Request& request);
    /// Returns room for one body of an upload, which lasts as long as the pointer; null if there is none.
    std::shared_ptr<void> upload_room();
    /// Returns when to retry, in seconds: about when the present queue is finished.
    [[nodiscard]] int retry_after() const;

    bool draining = false;
    std::function<std::size_t()> connections;  ///< number for the metrics

private:
    /// Reduces an image's answer to the bytes that the request asks for.
    static void cut(const Render& render, Response& response);

    std::variant<Response, Render> route(const Request& request);
    std::variant<Response, Render> image(const Request& request, const Target& target);
    void check_upload(const Request& request) const;
    Response upload(const Request& request);
    [[nodiscard]] Response scene(const std::string& id) const;
    [[nodiscard]] std::size_t scene_index(const std::string& id) const;
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
    std::string build_;  ///< build of the library, part of every entity tag
    std::string openapi_;
    AnswerRooms rooms_;
    std::shared_ptr<int> upload_rooms_ = std::make_shared<int>(0);  ///< number in use
};
