// SPDX-License-Identifier: MIT
#include "openapi.hpp"

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

std::string problem_response(int status, const std::string& description) {
    return ",\"" + std::to_string(status) + "\":{\"description\":" + json_string(description) +
           R"(,"content":{"application/problem+json":{"schema":{"$ref":"#/components/schemas/Problem"}}}})";
}

std::string image_path(const Options& options, const Resource& resource) {
    std::string text = ",\"/scenes/{id}/" + std::string(resource.name) + "\":{\"get\":{\"summary\":";
    text += json_string(has_observer(resource.format) ? "An image of an observer"
                                                      : "The Stokes vector of every pixel");
    text += ",\"parameters\":[" + image_parameters(options, resource.format) + "],\"responses\":{";
    text += "\"200\":{\"description\":\"The image\",\"content\":{" + json_string(resource.type) + ":{}}}";
    text += R"(,"304":{"description":"As If-None-Match has it"})";
    text += problem_response(400, "A parameter is wrong; the problem names it and its range");
    if (!options.keys.empty()) text += problem_response(403, "The signature is missing, wrong or expired");
    text += problem_response(404, "There is no such scene");
    text += problem_response(421, "The service does not answer for this host");
    text += problem_response(
        503,
        "The scene is not ready, too much to do, or a renderer failed; Retry-After says when "
        "to come again");
    return text + problem_response(504, "Not done within the deadline") + "}}}";
}

std::string plain_path(const char* path, const char* summary, const char* type) {
    return std::string(",\"") + path + R"(":{"get":{"summary":")" + summary +
           R"(","responses":{"200":{"description":"OK","content":{")" + type + "\":{}}}}}}";
}

}  // namespace

std::string openapi(const Options& options) {
    std::string text = R"({"openapi":"3.1.0","info":{"title":"nicol-serve","version":)";
    text += json_string(nicol_version_string());
    text += R"(,"description":"Images of polarized light."},"paths":{)";
    std::string paths = plain_path("/scenes", "The scenes and their previews", "application/json");
    for (const Resource& resource : resources) paths += image_path(options, resource);
    paths += plain_path("/health", "Whether the service is alive", "application/json");
    paths +=
        plain_path("/ready", "Whether it renders, and which scenes are ready; 503 where it does not render",
                   "application/json");
    paths += plain_path("/metrics", "Counts and times for Prometheus", "text/plain");
    text += paths.substr(1);
    text +=
        R"(},"components":{"schemas":{"Problem":{"type":"object","required":["type","title","status","detail"],)"
        R"("properties":{"type":{"type":"string"},"title":{"type":"string"},"status":{"type":"integer"},)"
        R"("detail":{"type":"string"},"parameter":{"type":"string"},"range":{"type":"string"}}}}}})";
    return text + "\n";
}
