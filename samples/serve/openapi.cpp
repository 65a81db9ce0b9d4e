// SPDX-License-Identifier: MIT
#include "openapi.hpp"

#include <algorithm>
#include <initializer_list>

#include "json.hpp"
#include "parameters.hpp"

namespace {

std::string schema(const Parameter& parameter) {
    using Kind = Parameter::Kind;
    const std::string bounds =
        ",\"minimum\":" + json_number(parameter.least) + ",\"maximum\":" + json_number(parameter.most);
    if (parameter.kind == Kind::number) return "{\"type\":\"number\"" + bounds + "}";
    if (parameter.kind == Kind::whole) return "{\"type\":\"integer\"" + bounds + "}";
    if (parameter.kind == Kind::size) return R"({"type":"string","pattern":"^[0-9]+x[0-9]+$"})";
    if (parameter.kind == Kind::numbers) {
        const std::string count = std::to_string(parameter.count);
        return "{\"type\":\"array\",\"items\":{\"type\":\"number\"" + bounds + "},\"minItems\":" + count +
               ",\"maxItems\":" + count + "}";
    }
    std::string choices;
    for (const std::string& choice : parameter.choices)
        choices += (choices.empty() ? "" : ",") + json_string(choice);
    return "{\"type\":\"string\",\"enum\":[" + choices + "]}";
}

std::string query_parameter(const std::string& name, const std::string& description,
                            const std::string& schema_text, bool list) {
    return ",{\"name\":" + json_string(name) +
           ",\"in\":\"query\",\"description\":" + json_string(description) +
           (list ? R"(,"style":"form","explode":false)" : "") + ",\"schema\":" + schema_text + "}";
}

std::string image_parameters(const Options& options, Format format) {
    std::string text = R"({"name":"id","in":"path","required":true,"schema":{"type":"string"}})";
    for (const Parameter& parameter : parameters(options.limits))
        if (parameter.applies_to(format))
            text +=
                query_parameter(parameter.name, parameter.description + " Range: " + parameter.range() + ".",
                                schema(parameter), parameter.kind == Parameter::Kind::numbers);
    if (!options.keys.empty()) {
        text += query_parameter("expires", "Seconds since 1970 until which the URL holds.",
                                R"({"type":"integer"})", false);
        text +=
            query_parameter("sig", "HMAC-SHA-256 of all that precedes it in the target; the last parameter.",
                            R"({"type":"string","pattern":"^[0-9a-f]{64}$"})", false);
    }
    return text;
}

// The texts below are JSON as it is sent.

constexpr const char* kSchemas = R"("schemas":{
"Problem":{"type":"object","description":"Problem details (RFC 9457).","required":["type","title","status","detail"],"properties":{
"type":{"type":"string"},"title":{"type":"string"},"status":{"type":"integer"},"detail":{"type":"string"},
"parameter":{"type":"string","description":"The parameter that is wrong."},
"range":{"type":"string","description":"Its range."}}},
"Scene":{"type":"object","required":["id","channels","size","up","fov","azimuth","elevation","distance","target","preview",
"image.png","image.exr","stokes.exr","stokes.planes","stokes.f16","stokes.f32"],"properties":{
"id":{"type":"string"},"channels":{"type":"integer","description":"Colour channels."},
"size":{"type":"array","description":"Width and height of the scene's film, in pixels.","items":{"type":"integer"},"minItems":2,"maxItems":2},
"up":{"type":"string","enum":["x","y","z"],"description":"Axis of the orbit."},
"fov":{"type":"number","description":"Horizontal field of view of the scene's camera, degrees."},
"azimuth":{"type":"number"},"elevation":{"type":"number"},"distance":{"type":"number"},
"target":{"type":"array","items":{"type":"number"},"minItems":3,"maxItems":3},
"preview":{"type":"string","description":"Target of a small image."},
"image.png":{"type":"string"},"image.exr":{"type":"string"},"stokes.exr":{"type":"string"},
"stokes.planes":{"type":"string"},"stokes.f16":{"type":"string"},"stokes.f32":{"type":"string"}}},
"Scenes":{"type":"object","required":["scenes","preparing","broken","signed","max_side","max_pixels"],"properties":{
"scenes":{"type":"array","items":{"$ref":"#/components/schemas/Scene"}},
"preparing":{"type":"array","items":{"type":"string"},"description":"Scenes that are not ready yet."},
"broken":{"type":"array","items":{"type":"string"},"description":"Scenes that cannot be loaded."},
"signed":{"type":"boolean","description":"Whether targets of images need a signature."},
"max_side":{"type":"integer"},"max_pixels":{"type":"integer"}}},
"SceneState":{"type":"object","required":["id","state"],"properties":{
"id":{"type":"string"},"state":{"type":"string","enum":["ready","preparing","broken"]},
"scene":{"$ref":"#/components/schemas/Scene"},
"reason":{"type":"string","description":"Why an uploaded scene cannot be loaded."}}},
"State":{"type":"object","required":["alive","ready","draining","scenes"],"properties":{
"alive":{"type":"boolean"},"ready":{"type":"boolean"},"draining":{"type":"boolean"},
"scenes":{"type":"object","additionalProperties":{"type":"string","enum":["ready","preparing","broken"]}}}}})";

constexpr const char* kHeaders = R"("headers":{
"ETag":{"description":"Strong tag of the image; equal for equal requests.","schema":{"type":"string"}},
"Nicol-Size":{"description":"WIDTHxHEIGHT of the image.","schema":{"type":"string"}},
"Nicol-Scale":{"description":"Value at full colour, of s1, s2 and s3.","schema":{"type":"number"}},
"Nicol-Components":{"description":"Stokes components in stokes.planes: 3 where s3 is 0 everywhere, else 4.","schema":{"type":"integer"}},
"Retry-After":{"description":"Seconds after which to come again.","schema":{"type":"integer"}},
"Location":{"description":"Target of the scene's state.","schema":{"type":"string"}},
"Allow":{"description":"The methods that there are.","schema":{"type":"string"}},
"Content-Range":{"description":"The bytes that were sent, of how many.","schema":{"type":"string"}}})";

std::string header_references(std::initializer_list<const char*> names) {
    std::string text;
    for (const std::string name : names)
        text += (text.empty() ? "\"" : ",\"") + name + R"(":{"$ref":"#/components/headers/)" + name + "\"}";
    return "\"headers\":{" + text + "}";
}

std::string problem_response(int status, const std::string& description, const char* header = nullptr) {
    return ",\"" + std::to_string(status) + "\":{\"description\":" + json_string(description) +
           (header != nullptr ? "," + header_references({header}) : "") +
           R"(,"content":{"application/problem+json":{"schema":{"$ref":"#/components/schemas/Problem"}}}})";
}

/// Returns the responses that every path may give.
std::string common_responses() {
    return problem_response(405, "The method is none of those that there are", "Allow") +
           problem_response(421, "The service does not answer for this host") +
           problem_response(429, "All connections of this address are taken");
}

constexpr const char* kEvents =
    "To clients whose Accept names text/event-stream: server-sent events. `progress` has verb, percent of "
    "the verb, "
    "and, once it can be told, seconds_left of the verb; then comes `done` with the url of the image, or "
    "`failed` with "
    "a problem, and the connection closes.";

/// Returns what an image's bytes are.
const char* layout(Format format) {
    switch (format) {
        case Format::stokes_f32:
            return "Little-endian 32-bit floats [channel][row][column][s0 s1 s2 s3], first row at the top; "
                   "Nicol-Size has columns and rows";
        case Format::stokes_f16:
            return "Little-endian 16-bit floats [channel][row][column][s0 s1 s2 s3], first row at the top; "
                   "Nicol-Size has columns and rows";
        case Format::stokes_planes:
            return "The numbers of stokes.f16 as differences by row: [component][channel][byte][row][column]";
        default:
            return "The image";
    }
}

std::string image_path(const Options& options, const Resource& resource) {
    const bool planes = resource.format == Format::stokes_planes;
    std::string operation = "get_" + std::string(resource.name);
    std::ranges::replace(operation, '.', '_');
    const std::string image =
        json_string(resource.type) + R"(:{"schema":{"type":"string","format":"binary"}})";
    const std::string content = ",\"content\":{" + image + "}}";
    const std::string content_or_events =
        ",\"content\":{" + image + R"(,"text/event-stream":{"schema":{"type":"string","description":)" +
        json_string(kEvents) + "}}}}";
    std::string text = ",\"/scenes/{id}/" + std::string(resource.name) +
                       "\":{\"get\":{\"operationId\":" + json_string(operation) + ",\"summary\":";
    text += json_string(has_observer(resource.format) ? "An image of an observer"
                                                      : "The Stokes vector of every pixel");
    text += ",\"parameters\":[" + image_parameters(options, resource.format) + "],\"responses\":{";
    text += "\"200\":{\"description\":" + json_string(layout(resource.format)) + ",";
    text += header_references({"ETag", "Nicol-Size", planes ? "Nicol-Components" : "Nicol-Scale"}) +
            content_or_events;
    if (!planes) {
        text += R"(,"206":{"description":"The bytes that Range asks for",)" +
                header_references({"ETag", "Content-Range"}) + content;
        text += R"(,"416":{"description":"There are no such bytes",)" + header_references({"Content-Range"}) +
                "}";
    }
    text += R"(,"304":{"description":"As If-None-Match has it"})";
    text += problem_response(400, "A parameter is wrong; the problem names it and its range");
    if (!options.keys.empty()) text += problem_response(403, "The signature is missing, wrong or expired");
    text += problem_response(404, "There is no such scene") + common_responses();
    text +=
        problem_response(503, "The scene is not ready, too much to do, or a renderer failed", "Retry-After");
    return text + problem_response(504, "Not done within the deadline") + "}}}";
}

/// Returns the path of one scene.
std::string scene_path() {
    const std::string state =
        R"("content":{"application/json":{"schema":{"$ref":"#/components/schemas/SceneState"}}}})";
    return R"(,"/scenes/{id}":{"get":{"operationId":"get_scene","summary":"Whether a scene is ready, and its description",)"
           R"("parameters":[{"name":"id","in":"path","required":true,"schema":{"type":"string"}}],"responses":{"200":{"description":"OK",)" +
           state + problem_response(404, "There is no such scene") + common_responses() + "}}}";
}

/// Returns the operation that takes scenes. Its body has one media type, because generators of clients make
/// no working code of several.
std::string upload_operation(const Options& options) {
    std::string text =
        R"(,"post":{"operationId":"post_scene","summary":"Takes a scene: GLB, glTF or XML","requestBody":{"required":true,"description":)" +
        json_string(
            "The content says the format, and so may the types model/gltf-binary, model/gltf+json, "
            "application/xml and text/xml. multipart/form-data has several files by their filenames, the "
            "scene first.") +
        R"(,"content":{"application/octet-stream":{"schema":{"type":"string","format":"binary"}}}},)"
        R"("responses":{"202":{"description":"Taken; the scene becomes ready or broken",)" +
        header_references({"Location"}) +
        R"(,"content":{"application/json":{"schema":{"$ref":"#/components/schemas/SceneState"}}}})";
    text += problem_response(400, "The parts are not those of a scene");
    text += problem_response(403, options.keys.empty() ? "Pages of this origin may not send scenes"
                                                       : "The signature is missing, wrong or expired");
    text += problem_response(413, "The body is longer than --max-upload");
    text += problem_response(415, "The Content-Type is not that of a scene");
    text += problem_response(429, "Too many scenes are being sent or prepared", "Retry-After");
    text += problem_response(503, "The service is not ready", "Retry-After");
    return text + "}}";
}

/// Returns a path without parameters. further: other operations than get.
std::string plain_path(const std::string& name, const char* summary, const char* type, const char* schema,
                       const std::string& further = "") {
    return ",\"/" + name + R"(":{"get":{"operationId":"get_)" + name + R"(","summary":")" + summary +
           R"(","responses":{"200":{"description":"OK","content":{")" + type + "\":{\"schema\":" + schema +
           "}}}" + common_responses() + "}}" + further + "}";
}

}  // namespace

std::string openapi(const Options& options) {
    constexpr const char* state = R"({"$ref":"#/components/schemas/State"})";
    std::string text = R"({"openapi":"3.1.0","info":{"title":"nicol-serve","version":)";
    text += json_string(nicol_version_string());
    text += R"(,"description":"Images of polarized light.","license":{"name":"MIT","identifier":"MIT"}},)";
    text += R"("servers":[{"url":"/v1"}],"paths":{)";
    std::string paths = plain_path("scenes", "The scenes and their previews", "application/json",
                                   R"({"$ref":"#/components/schemas/Scenes"})",
                                   options.uploads ? upload_operation(options) : "") +
                        scene_path();
    for (const Resource& resource : resources) paths += image_path(options, resource);
    paths += plain_path("health", "Whether the service is alive", "application/json", state);
    paths +=
        plain_path("ready", "Whether it renders, and which scenes are ready; 503 where it does not render",
                   "application/json", state);
    paths += plain_path("metrics", "Counts and times for Prometheus", "text/plain", R"({"type":"string"})");
    text += paths.substr(1) + "},\"components\":{" + kSchemas + "," + kHeaders + "}}";
    return text + "\n";
}
