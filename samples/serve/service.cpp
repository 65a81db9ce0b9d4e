// SPDX-License-Identifier: MIT
#include "service.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "assets.hpp"
#include "byte_range.hpp"
#include "coding.hpp"
#include "common/failure.hpp"
#include "digest.hpp"
#include "events.hpp"
#include "json.hpp"
#include "openapi.hpp"
#include "query.hpp"
#include "signature.hpp"
#include "visitors.hpp"

namespace {

constexpr int kNotReadySeconds = 2;
constexpr int kBrokenSceneSeconds = 60;
/// Largest number of uploads whose bodies are in memory.
constexpr int kUploadRooms = 4;

[[noreturn]] void refuse(int status, const std::string& detail, int retry_after = 0) {
    throw Refusal({.status = status, .detail = detail, .retry_after = retry_after});
}

std::string build_text() {
    std::string text = nicol_version_string();
    for (std::uint32_t i = 0; const char* fact = nicol_build_info(i); ++i) text.append(" ").append(fact);
    return text;
}

const char* name_of(SceneLoads::Condition condition) {
    switch (condition) {
        case SceneLoads::Condition::ready:
            return "ready";
        case SceneLoads::Condition::broken:
            return "broken";
        default:
            return "preparing";
    }
}

std::string scene_json(const SceneInfo& scene) {
    const std::string path = "/v1/scenes/" + scene.id + "/";
    const double side = std::max(scene.width, scene.height);
    const auto fit = [&](std::uint32_t length) {
        constexpr double preview_side = 256;
        return std::to_string(std::max(1L, std::lround(length * std::min(1.0, preview_side / side))));
    };
    const bool colour = scene.channels == 1 || scene.channels == 3;
    std::string text = "{\"id\":" + json_string(scene.id);
    text += ",\"channels\":" + std::to_string(scene.channels);
    text += ",\"size\":[" + std::to_string(scene.width) + "," + std::to_string(scene.height) + "]";
    text += std::string(",\"up\":\"") + "xyz"[scene.up] + "\",\"fov\":" + json_number(scene.fov);
    text += ",\"azimuth\":" + json_number(scene.orbit.azimuth);
    text += ",\"elevation\":" + json_number(scene.orbit.elevation);
    text += ",\"distance\":" + json_number(scene.orbit.distance) + ",\"target\":[";
    for (std::size_t i = 0; i < 3; ++i) text += (i == 0 ? "" : ",") + json_number(scene.orbit.target[i]);
    text += "],\"preview\":" + json_string(path + "image.png?size=" + fit(scene.width) + "x" +
                                           fit(scene.height) + (colour ? "" : "&observer=dolp"));
    for (const Resource& resource : resources)
        text += "," + json_string(resource.name) + ":" + json_string(path + std::string(resource.name));
    return text + "}";
}

}  // namespace

Service::Service(const Options& options, Pool& pool, Metrics& metrics)
    : options_(options),
      pool_(pool),
      metrics_(metrics),
      cache_(options.result_bytes),
      build_(build_text()),
      openapi_(openapi(options)),
      rooms_(options.answer_bytes) {
    if (!options.keys.empty()) keys_ = read_keys(options.keys);
    pool.scenes_changed = [this] { cache_.clear(); };
}

std::variant<Response, Render> Service::handle(const Request& request) {
    try {
        return route(request);
    } catch (const Refusal& refusal) {
        return respond(refusal.problem);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nicol-serve: %s\n", one_line(error.what()).c_str());
        return respond(Problem{.status = 500, .detail = "The service failed."});
    }
}

std::variant<Response, Render> Service::route(const Request& request) {
    for (const std::string& host : {request.host, request.authority})
        if (!host.empty() && !answers_for(host, request.local, options_.allowed_hosts))
            refuse(421,
                   "This service does not answer for the host '" + host + "'; --allow-host allows hosts.");
    const bool takes_scenes = options_.uploads && !request.status_alone && is_path_of_scenes(request.target);
    if (takes_scenes && request.method == "POST") return upload(request);
    if (request.method != "GET" && request.method != "HEAD") {
        const bool asks = request.method == "OPTIONS";
        const std::string methods = takes_scenes ? "GET, HEAD, POST, OPTIONS" : "GET, HEAD, OPTIONS";
        Response response =
            asks ? Response{.status = 204, .type = ""}
                 : respond(Problem{.status = 405, .detail = "The methods here are " + methods + "."});
        response.headers.emplace_back("Allow", methods);
        if (asks)
            for (auto& header : preflight_headers(request.origin, options_.allowed_origins))
                response.headers.push_back(std::move(header));
        return response;
    }
    Target target = parse_target(request.target);
    // Without a version the paths are those of the first one.
    if (target.segments.size() > 1 && target.segments.front() == "v1")
        target.segments.erase(target.segments.begin());
    const std::vector<std::string>& path = target.segments;
    const std::string& name = path.front();
    const bool alone = path.size() == 1;
    if (alone && name == "health") return state(false);
    if (alone && name == "ready") return state(true);
    if (alone && name == "metrics") return text("text/plain; version=0.0.4", metrics_text());
    if (request.status_alone) refuse(404, "Here are /health, /ready and /metrics alone.");
    if (path.size() == 2 && name == "scenes") return scene(path[1]);
    if (!alone && name == "scenes") return image(request, target);
    if (alone && name == "scenes") return scenes();
    if (alone && name == "openapi.json") return text("application/json", openapi_);
    return page(request, target);
}

std::variant<Response, Render> Service::image(const Request& request, const Target& target) {
    const std::vector<std::string>& path = target.segments;
    const auto* const resource =
        path.size() == 3 ? std::ranges::find(resources, path[2], &Resource::name) : resources.end();
    if (resource == resources.end())
        refuse(404,
               "A scene has image.png, image.exr, stokes.exr, stokes.planes, stokes.f16 and stokes.f32.");
    if (!keys_.empty()) check_signature(request.target, keys_, std::time(nullptr));
    const std::size_t index = scene_index(path[1]);
    pool_.touch(index);
    const SceneLoads::Condition condition = pool_.loads().condition(index);
    if (condition == SceneLoads::Condition::broken)
        refuse(503, "This scene cannot be loaded; the service's log says why.", kBrokenSceneSeconds);
    if (condition == SceneLoads::Condition::preparing)
        refuse(503, "This scene is still being prepared.", kNotReadySeconds);
    const SceneInfo* const scene = &scenes_known()[index].info;
    Render render{.request = parse_image(target, resource->format, static_cast<std::uint32_t>(index), *scene,
                                         options_.limits)};
    render.range = request.range;
    render.if_range = request.if_range;
    render.request.deflate =
        resource->format == Format::stokes_planes && accepts_coding(request.accept_encoding, "deflate");
    render.tag = entity_tag(build_ + '\n' + pool_.renderer() + '\n' + scene->digest + '\n' +
                            canonical(render.request, *scene));
    if (accepts_events(request.accept) && request.method == "GET") {
        render.events_url = request.target;
        render.range.clear();
    } else if (matches(request.if_none_match, render.tag)) {
        ++metrics_.hits_tag;
        return tagged(304, render);
    }
    if (request.method == "HEAD") return tagged(200, render);
    render.room = rooms_.reserve(render.tag, most_bytes(render.request, *scene));
    if (!render.room) refuse(503, "Too many answers are unread.", retry_after());
    if (const AnswerPtr kept = render.room->answer() ? render.room->answer() : cache_.find(render.tag)) {
        ++metrics_.hits_result;
        Response response = respond(render, kept);
        if (render.events_url.empty()) return response;
        Response events = text("text/event-stream", done_event(render.events_url));
        events.is_last = true;
        return events;
    }
    if (draining) refuse(503, "The service is about to end.", kNotReadySeconds);
    return render;
}

std::size_t Service::scene_index(const std::string& id) const {
    const std::vector<SceneLoads::Scene>& known = scenes_known();
    const auto found = std::ranges::find(known, id, [](const auto& one) { return one.info.id; });
    if (id.empty() || found == known.end())
        refuse(404, "There is no scene of this name; /scenes lists those of the folder.");
    return static_cast<std::size_t>(found - known.begin());
}

Response Service::scene(const std::string& id) const {
    const std::size_t index = scene_index(id);
    const SceneLoads::Scene& known = scenes_known()[index];
    const SceneLoads::Condition condition = pool_.loads().condition(index);
    std::string json = "{\"id\":" + json_string(id) + ",\"state\":" + json_string(name_of(condition));
    if (condition == SceneLoads::Condition::ready) json += ",\"scene\":" + scene_json(known.info);
    // Paths of the folder's files go only to the log.
    if (condition == SceneLoads::Condition::broken && pool_.is_upload(index))
        json += ",\"reason\":" + json_string(known.reason);
    return text("application/json", json + "}\n");
}

std::shared_ptr<void> Service::upload_room() {
    if (*upload_rooms_ >= kUploadRooms) return nullptr;
    ++*upload_rooms_;
    return {upload_rooms_.get(), [count = upload_rooms_](int*) { --*count; }};
}

/// Throws Refusal unless an upload may be made. Reads no body.
void Service::check_upload(const Request& request) const {
    if (!keys_.empty()) check_signature(request.target, keys_, std::time(nullptr));
    // Pages elsewhere must not fill the service of the user who visits them.
    if (!may_send(request.origin, request.host, options_.allowed_origins))
        refuse(403, "Pages of this origin may not send scenes; --allow-origin allows origins.");
    require_upload_type(request.content_type);
    if (draining) refuse(503, "The service is about to end.", kNotReadySeconds);
    if (!pool_.ready()) refuse(503, "The service is not ready yet.", kNotReadySeconds);
    if (!request.has_upload_room) refuse(429, "Too many scenes are being sent.", kNotReadySeconds);
}

std::optional<Response> Service::refused_upload(const Request& request) {
    try {
        check_upload(request);
        return {};
    } catch (const Refusal& refusal) {
        return respond(refusal.problem);
    }
}

Response Service::upload(const Request& request) {
    check_upload(request);
    const Upload upload = parse_upload(request.content_type, request.body);
    if (!pool_.keep_upload(upload)) refuse(429, "Too many scenes are being prepared.", kNotReadySeconds);
    Response response = scene(upload.id);
    response.status = 202;
    response.headers.emplace_back("Location", "/v1/scenes/" + upload.id);
    return response;
}

/// Returns an answer without content, from what is known before the image exists.
Response Service::tagged(int status, const Render& render) {
    const Resource& resource = resource_of(render.request.format);
    Response response{.status = status, .type = status == 304 ? "" : std::string(resource.type)};
    response.headers.emplace_back("ETag", render.tag);
    if (resource.format == Format::stokes_planes) response.headers.emplace_back("Vary", "Accept-Encoding");
    if (render.request.deflate && status != 304) response.headers.emplace_back("Content-Encoding", "deflate");
    return response;
}

Response Service::respond(const Render& render, const AnswerPtr& answer) {
    const ResultHead& head = answer->head;
    if (head.status != 200) {
        // Details of internal failures go only to the log.
        const bool telling = head.status == 400 || head.status == 503;
        return respond(Problem{.status = head.status,
                               .detail = telling ? answer->content : "The image could not be rendered.",
                               .retry_after = head.status == 503 ? retry_after() : 0});
    }
    cache_.keep(render.tag, answer);
    render.room->settle(answer);
    Response response = tagged(200, render);
    response.owner = render.room;
    response.content = answer->content;
    const std::string age = std::to_string(static_cast<long>(options_.max_age.count()));
    response.headers.emplace_back("Cache-Control",
                                  options_.max_age.count() >= 1 ? "max-age=" + age : "no-cache");
    response.headers.emplace_back("Nicol-Size", std::to_string(render.request.view.width) + "x" +
                                                    std::to_string(render.request.view.height));
    if (head.scale > 0)
        response.headers.emplace_back("Nicol-Scale", json_number(static_cast<double>(head.scale)));
    if (head.components > 0)
        response.headers.emplace_back("Nicol-Components", std::to_string(head.components));
    cut(render, response);
    return response;
}

void Service::cut(const Render& render, Response& response) {
    // Planes are coded in two ways under one tag, so that parts of them could not be told apart.
    if (render.request.format == Format::stokes_planes) return;
    response.headers.emplace_back("Accept-Ranges", "bytes");
    const std::size_t size = response.content.size();
    const WantedBytes wanted = wanted_bytes(render.range, render.if_range, render.tag, size);
    if (const auto* const part = std::get_if<ByteRange>(&wanted)) {
        response.status = 206;
        response.headers.emplace_back("Content-Range", content_range(*part, size));
        response.content = response.content.substr(part->first, part->count);
    } else if (std::holds_alternative<NothingThere>(wanted)) {
        response.status = 416;
        response.headers.emplace_back("Content-Range", "bytes */" + std::to_string(size));
        response.content = {};
    }
}

Response Service::respond(const Problem& problem) const {
    Response response = text("application/problem+json", problem_json(problem));
    response.status = problem.status;
    if (problem.retry_after > 0)
        response.headers.emplace_back("Retry-After", std::to_string(problem.retry_after));
    return response;
}

int Service::retry_after() const {
    const Dispatcher& dispatcher = pool_.dispatcher();
    const auto waiting = static_cast<double>(dispatcher.queued() + dispatcher.running());
    const auto workers = static_cast<double>(std::max<std::size_t>(1, pool_.warm_workers()));
    constexpr double longest = 60;
    return static_cast<int>(
        std::clamp(std::ceil(waiting / workers * metrics_.render_seconds.mean()), 1.0, longest));
}

Response Service::text(std::string type, std::string content) const {
    const auto owner = std::make_shared<const std::string>(std::move(content));
    Response response{.status = 200, .type = std::move(type), .owner = owner, .content = *owner};
    response.headers.emplace_back("Cache-Control", "no-store");
    return response;
}

Response Service::scenes() const {
    std::string ready, preparing, broken;
    const std::vector<SceneLoads::Scene>& known = scenes_known();
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (pool_.is_upload(i)) continue;  // only the client who sent a scene knows its id
        const SceneLoads::Condition condition = pool_.loads().condition(i);
        const bool is_ready = condition == SceneLoads::Condition::ready;
        std::string& to = is_ready ? ready : condition == SceneLoads::Condition::broken ? broken : preparing;
        to +=
            (to.empty() ? "" : ",") + (is_ready ? scene_json(known[i].info) : json_string(known[i].info.id));
    }
    return text("application/json",
                "{\"scenes\":[" + ready + "],\"preparing\":[" + preparing + "],\"broken\":[" + broken +
                    "],\"signed\":" + (keys_.empty() ? "false" : "true") +
                    ",\"max_side\":" + std::to_string(options_.limits.max_side) +
                    ",\"max_pixels\":" + std::to_string(options_.limits.max_pixels) + "}\n");
}

Response Service::state(bool must_be_ready) const {
    const bool ready = pool_.ready() && !draining;
    std::string scenes;
    for (std::size_t i = 0; i < pool_.loads().scenes().size(); ++i)
        if (!pool_.is_upload(i))
            scenes += (scenes.empty() ? "" : ",") + json_string(pool_.loads().scenes()[i].info.id) + ":\"" +
                      name_of(pool_.loads().condition(i)) + "\"";
    Response response =
        text("application/json", std::string("{\"alive\":true,\"ready\":") + (ready ? "true" : "false") +
                                     ",\"draining\":" + (draining ? "true" : "false") + ",\"scenes\":{" +
                                     scenes + "}}\n");
    if (must_be_ready && !ready) {
        response.status = 503;
        response.headers.emplace_back("Retry-After", std::to_string(kNotReadySeconds));
    }
    return response;
}

Response Service::page(const Request& request, const Target& target) const {
    const std::span<const Asset> all = assets();
    const auto asset = std::ranges::find(all, "/" + target.segments.front(), &Asset::path);
    if (target.segments.size() != 1 || asset == all.end())
        refuse(404, "There is nothing here; /openapi.json says what there is.");
    Response response{.status = 200, .type = std::string(asset->type), .content = asset->content};
    const std::string tag = entity_tag(asset->content);
    response.headers.emplace_back("ETag", tag);
    response.headers.emplace_back("Cache-Control", "no-cache");
    response.headers.emplace_back("Content-Security-Policy", "default-src 'self'");
    if (!matches(request.if_none_match, tag)) return response;
    response.status = 304;
    response.content = {};
    return response;
}

std::string Service::metrics_text() const {
    const Dispatcher& dispatcher = pool_.dispatcher();
    return metrics_.text({.queued = dispatcher.queued(),
                          .running = dispatcher.running(),
                          .connections = connections ? connections() : 0,
                          .cached_bytes = cache_.bytes(),
                          .answer_bytes = rooms_.bytes(),
                          .ready = pool_.ready() && !draining,
                          .workers = pool_.states()});
}

const std::vector<SceneLoads::Scene>& Service::scenes_known() const {
    if (pool_.loads().scenes().empty()) refuse(503, "The scenes are still being prepared.", kNotReadySeconds);
    return pool_.loads().scenes();
}
