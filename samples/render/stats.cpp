// SPDX-License-Identifier: MIT
#include "stats.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>

#include "common/failure.hpp"
#include "options.hpp"

namespace {

std::string quoted(const char* text) {
    std::string result = "\"";
    for (const char* p = text ? text : ""; *p; ++p) {
        const auto c = static_cast<unsigned char>(*p);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += *p;
        } else if (c < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
            result += escape;
        } else {
            result += *p;
        }
    }
    return result + '"';
}

const char* backend_name(nicol_backend backend) {
    if (backend == NICOL_BACKEND_EGL) return "egl";
    if (backend == NICOL_BACKEND_OSMESA) return "osmesa";
    return "unknown";
}

std::string milliseconds(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    return text;
}

}  // namespace

std::string stats_json(const nicol_context_info& context, std::uint32_t width, std::uint32_t height,
                       std::uint32_t channels, const nicol_statistics& s) {
    std::ostringstream json;
    json << "{\n"
         << "  \"nicol\": " << quoted(nicol_version_string()) << ",\n"
         << "  \"backend\": " << quoted(backend_name(context.backend)) << ",\n"
         << "  \"renderer\": " << quoted(context.renderer) << ",\n"
         << "  \"opengl\": " << quoted(context.version) << ",\n"
         << "  \"software\": " << (context.software != 0 ? "true" : "false") << ",\n"
         << "  \"threads\": " << context.threads << ",\n"
         << "  \"executor\": " << quoted(s.compute != 0 ? "compute" : "cpu") << ",\n"
         << "  \"width\": " << width << ",\n"
         << "  \"height\": " << height << ",\n"
         << "  \"channels\": " << channels << ",\n"
         << "  \"order_low\": " << s.order_low << ",\n"
         << "  \"order\": " << s.order << ",\n"
         << "  \"predicted_error\": " << s.predicted_error << ",\n"
         << "  \"vertices\": " << s.vertices << ",\n"
         << "  \"vertices_added\": " << s.vertices_added << ",\n"
         << "  \"triangles\": " << s.triangles << ",\n"
         << "  \"local_lights\": " << s.local_lights << ",\n"
         << "  \"lights_split\": " << s.lights_split << ",\n"
         << "  \"bounces\": {\n"
         << "    \"links\": " << s.bounce_links << ",\n"
         << "    \"rounds\": " << s.bounce_rounds << ",\n"
         << "    \"light\": " << s.bounced_light << ",\n"
         << "    \"left\": " << s.bounced_left << "\n"
         << "  },\n"
         << "  \"pixels_shaded\": " << s.pixels_shaded << ",\n"
         << "  \"milliseconds\": {\n"
         << "    \"project\": " << milliseconds(s.project_ms) << ",\n"
         << "    \"bake\": " << milliseconds(s.bake_ms) << ",\n"
         << "    \"bake_trace\": " << milliseconds(s.bake_trace_ms) << ",\n"
         << "    \"relight\": " << milliseconds(s.relight_ms) << ",\n"
         << "    \"bounce\": " << milliseconds(s.bounce_ms) << ",\n"
         << "    \"shade\": " << milliseconds(s.shade_ms) << ",\n"
         << "    \"light\": " << milliseconds(s.light_ms) << ",\n"
         << "    \"trace\": " << milliseconds(s.trace_ms) << ",\n"
         << "    \"draw\": " << milliseconds(s.draw_ms) << ",\n"
         << "    \"observe\": " << milliseconds(s.observe_ms) << "\n"
         << "  },\n"
         << "  \"rays\": {\n"
         << "    \"bake\": " << s.bake_rays << ",\n"
         << "    \"bake_skipped\": " << s.bake_rays_skipped << ",\n"
         << "    \"camera\": " << s.camera_rays << ",\n"
         << "    \"shadow\": " << s.shadow_rays << ",\n"
         << "    \"light\": " << s.light_rays << ",\n"
         << "    \"light_skipped\": " << s.light_rays_skipped << ",\n"
         << "    \"smooth\": " << s.smooth_rays << "\n"
         << "  },\n"
         << "  \"unphysical\": " << s.vertices_unphysical << ",\n"
         << "  \"skipped\": {\n"
         << "    \"vertices\": " << s.vertices_skipped << ",\n"
         << "    \"unoccluded\": " << s.vertices_unoccluded << ",\n"
         << "    \"unbaked\": " << s.vertices_unbaked << ",\n"
         << "    \"light_columns\": " << s.light_columns_skipped << ",\n"
         << "    \"response_rows\": " << s.response_rows_skipped << ",\n"
         << "    \"channels_shared\": " << s.channels_shared << "\n"
         << "  },\n"
         << "  \"bytes\": {\n"
         << "    \"response\": " << s.response_bytes << ",\n"
         << "    \"visibility\": " << s.visibility_bytes << ",\n"
         << "    \"transfer\": " << s.transfer_bytes << ",\n"
         << "    \"buffer\": " << s.buffer_bytes << ",\n"
         << "    \"texture\": " << s.texture_bytes << "\n"
         << "  }\n"
         << "}\n";
    return json.str();
}

void write_file(const std::string& path, const std::string& content) {
    errno = 0;
    bool written = false;
    if (path == kStandardOutput) {
        written = std::fputs(content.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
    } else {
        std::ofstream file(path, std::ios::binary);
        file << content;
        file.close();
        written = file.good();
    }
    if (!written) throw Failure(path + ": cannot write: " + std::strerror(errno));
}
