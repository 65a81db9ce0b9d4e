// SPDX-License-Identifier: MIT
// Fuzzer of HTTP requests to nicol-serve. The input holds the bytes of one or more requests, as read from a
// connection.
#include <algorithm>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <optional>

#include "image_request.hpp"
#include "memory_file.hpp"
#include "options.hpp"
#include "problem.hpp"
#include "signature.hpp"
#include "upload.hpp"

namespace http = boost::beast::http;
using nicol::fuzz::require;

namespace {

SceneInfo scene_of(std::uint32_t channels) {
    return {
        .id = "a", .digest = "0", .channels = channels, .width = 640, .height = 480, .fov = 50, .orbit = {}};
}

std::optional<ImageRequest> request_of(const Target& target, Format format, const SceneInfo& scene) {
    try {
        return parse_image(target, format, 0, scene, {});
    } catch (const Refusal& refusal) {
        require(!problem_json(refusal.problem).empty(), "a problem has a text");
        return std::nullopt;
    }
}

/// Parses the target for every resource of a scene in colour and of one in other channels. A canonical name
/// must parse to a request with that canonical name.
void parse(const Target& target) {
    for (const Resource& resource : resources) {
        for (const std::uint32_t channels : {3u, 5u}) {
            const SceneInfo scene = scene_of(channels);
            const std::optional<ImageRequest> request = request_of(target, resource.format, scene);
            if (!request) continue;
            const Limits limits;
            const View& view = request->view;
            require(view.width > 0 && view.height > 0 && view.width <= limits.max_side &&
                        view.height <= limits.max_side && view.width * view.height <= limits.max_pixels,
                    "the size is within limits");
            const std::string name = canonical(*request, scene);
            const Target again = parse_target(std::string_view(name).substr(name.find('/')));
            require(canonical(parse_image(again, resource.format, 0, scene, limits), scene) == name,
                    name.c_str());
        }
    }
}

void handle(std::string_view target) {
    try {
        parse(parse_target(target));
        check_signature(std::string(target), {"key"}, 0);
    } catch (const Refusal& refusal) {
        require(refusal.problem.status >= 400 && refusal.problem.status < 500, "the client is to blame");
    }
}

/// Reads the input as the body of an upload: a Content-Type, a line's end and the content.
void receive(std::string_view bytes) {
    const std::size_t line = std::min(bytes.find('\n'), bytes.size());
    for (const std::string_view type :
         {bytes.substr(0, line), std::string_view("multipart/form-data; boundary=b")}) {
        try {
            const Upload upload = parse_upload(type, bytes.substr(std::min(line + 1, bytes.size())));
            Upload again;
            require(unpack(pack(upload), again) && pack(again) == pack(upload),
                    "an upload survives its packing");
        } catch (const Refusal& refusal) {
            require(refusal.problem.status == 400 || refusal.problem.status == 415, "the client is to blame");
        }
    }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const Options options;
    boost::asio::const_buffer left(bytes, size);
    while (left.size() > 0) {
        http::request_parser<http::string_body> parser;
        parser.header_limit(options.header_bytes);
        parser.body_limit(options.body_bytes);
        parser.eager(true);
        boost::system::error_code error;
        left += parser.put(left, error);
        if (error || !parser.is_done()) break;
        const auto target = parser.get().target();
        handle({target.data(), target.size()});
    }
    handle(nicol::fuzz::text_of(bytes, size));
    receive(nicol::fuzz::text_of(bytes, size));
    return 0;
}
