// SPDX-License-Identifier: MIT
#include "image_request.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "json.hpp"
#include "parameters.hpp"
#include "problem.hpp"

const std::array<Resource, 6> resources = {{
    {.format = Format::png, .name = "image.png", .type = "image/png"},
    {.format = Format::exr, .name = "image.exr", .type = "image/x-exr"},
    {.format = Format::stokes_exr, .name = "stokes.exr", .type = "image/x-exr"},
    {.format = Format::stokes_planes, .name = "stokes.planes", .type = "application/octet-stream"},
    {.format = Format::stokes_f16, .name = "stokes.f16", .type = "application/octet-stream"},
    {.format = Format::stokes_f32, .name = "stokes.f32", .type = "application/octet-stream"},
}};

const Resource& resource_of(Format format) {
    return *std::ranges::find(resources, format, &Resource::format);
}

namespace {

/// Returns the remainder of a division by a positive period, never negative.
double wrapped(double value, double period) {
    const double rest = std::fmod(value, period);
    const double positive = rest < 0 ? rest + period : rest;
    return positive == period ? 0 : positive;
}

/// The parameters of one URL, each checked against its row of the table.
class Reader {
public:
    Reader(const Target& target, const Limits& limits, Format format)
        : target_(target), limits_(limits), table_(parameters(limits)) {
        for (const auto& parameter : target.query) {
            const std::string& name = parameter.first;
            // These parameters are checked with the signature.
            if (name == "sig" || name == "expires") continue;
            const auto known =
                std::ranges::find_if(table_, [&](const Parameter& p) { return p.name == name; });
            if (known == table_.end() || !known->applies_to(format)) refuse_unknown(name, format);
        }
    }

    [[nodiscard]] const Parameter& row(std::string_view name) const {
        return *std::ranges::find_if(table_, [&](const Parameter& p) { return p.name == name; });
    }
    [[nodiscard]] bool has(std::string_view name) const { return target_.find(name) != nullptr; }
    [[nodiscard]] std::optional<double> number(std::string_view name) const {
        const std::string* text = target_.find(name);
        return text == nullptr ? std::nullopt : std::optional(parse_number(row(name), *text));
    }
    template <std::size_t N>
    bool numbers(std::string_view name, std::array<double, N>& into) const {
        const std::string* text = target_.find(name);
        if (text == nullptr) return false;
        std::ranges::copy(parse_numbers(row(name), *text), into.begin());
        return true;
    }
    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> size(const SceneInfo& info) const {
        if (const std::string* text = target_.find("size")) return parse_size(row("size"), *text, limits_);
        const auto side = static_cast<double>(std::max(info.width, info.height));
        const double pixels = static_cast<double>(info.width) * info.height;
        const double factor =
            std::min({1.0, limits_.max_side / side, std::sqrt(limits_.max_pixels / pixels)});
        const auto fit = [&](std::uint32_t length) {
            return std::max(1u, static_cast<std::uint32_t>(std::floor(length * factor)));
        };
        return {fit(info.width), fit(info.height)};
    }
    [[nodiscard]] std::optional<std::size_t> choice(std::string_view name) const {
        const std::string* text = target_.find(name);
        return text == nullptr ? std::nullopt : std::optional(parse_choice(row(name), *text));
    }

private:
    [[noreturn]] void refuse_unknown(const std::string& name, Format format) const {
        std::string known;
        for (const Parameter& p : table_)
            if (p.applies_to(format)) known += (known.empty() ? "" : ", ") + p.name;
        throw Refusal({.status = 400,
                       .detail = "There is no such parameter here.",
                       .parameter = name,
                       .range = "one of " + known});
    }

    const Target& target_;
    const Limits& limits_;
    std::vector<Parameter> table_;
};

void read_camera(const Reader& reader, const SceneInfo& info, View& view) {
    view.fov = reader.number("fov").value_or(0);
    const bool orbits =
        reader.has("azimuth") || reader.has("elevation") || reader.has("distance") || reader.has("target");
    if (reader.numbers("matrix", view.matrix)) {
        if (orbits) refuse_parameter(reader.row("matrix"), "A camera has a matrix or an orbit, not both.");
        view.camera = CameraKind::matrix;
    } else if (orbits) {
        view.camera = CameraKind::orbit;
        view.orbit = info.orbit;
        view.orbit.azimuth = wrapped(reader.number("azimuth").value_or(info.orbit.azimuth), 360);
        view.orbit.elevation = reader.number("elevation").value_or(info.orbit.elevation);
        view.orbit.distance = reader.number("distance").value_or(info.orbit.distance);
        reader.numbers("target", view.orbit.target);
    }
}

void read_orders(const Reader& reader, View& view) {
    const auto order = [&](std::string_view name) {
        return static_cast<std::int32_t>(reader.number(name).value_or(-1));
    };
    view.order_low = order("order_low");
    view.order_high = order("order_high");
    view.tolerance = reader.number("tolerance").value_or(0);
    if (view.tolerance > 0 && (view.order_low >= 0 || view.order_high >= 0))
        refuse_parameter(reader.row("tolerance"),
                         "A tolerance chooses the orders; they cannot be given too.");
    if (view.order_high >= 0 && view.order_high < view.order_low)
        refuse_parameter(reader.row("order_high"),
                         "The value is below order_low, which is " + std::to_string(view.order_low) + ".");
}

void read_observer(const Reader& reader, const SceneInfo& info, ImageRequest& request) {
    const std::optional<double> angle = reader.number("polarizer");
    const std::optional<std::size_t> choice = reader.choice("observer");
    request.observer = choice ? static_cast<Observer>(*choice) : (angle ? Observer::polarizer : Observer::s0);
    const bool through = request.observer == Observer::polarizer;
    if (angle && !through)
        refuse_parameter(reader.row("observer"), "Only the observer polarizer has an angle.");
    // Parameters without effect on this observer are dropped, so that they do not make another image.
    const double exposure = reader.number("exposure").value_or(0), scale = reader.number("scale").value_or(0);
    const bool bright = through || request.observer == Observer::s0;
    const bool component = request.observer == Observer::s1 || request.observer == Observer::s2 ||
                           request.observer == Observer::s3;
    if (through) request.polarizer = wrapped(angle.value_or(0), 180);
    if (bright) request.exposure = exposure;
    if (component && request.format == Format::png) request.scale = scale;
    if (bright && request.format == Format::png && info.channels != 1 && info.channels != 3)
        refuse_parameter(reader.row("observer"),
                         "The scene has " + std::to_string(info.channels) +
                             " channels, which are no colour: s0 and polarizer are there as EXR only.");
}

std::string list(const double* values, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ",") + json_number(values[i]);
    return text;
}

}  // namespace

ImageRequest parse_image(const Target& target, Format format, std::uint32_t scene, const SceneInfo& info,
                         const Limits& limits) {
    const Reader reader(target, limits, format);
    ImageRequest request;
    request.format = format;
    request.view.scene = scene;
    std::tie(request.view.width, request.view.height) = reader.size(info);
    read_camera(reader, info, request.view);
    request.view.light = wrapped(reader.number("light").value_or(0), 360);
    request.view.light_tilt = reader.number("light_tilt").value_or(0);
    read_orders(reader, request.view);
    request.view.samples = static_cast<std::uint32_t>(reader.number("samples").value_or(1));
    if (has_observer(format)) read_observer(reader, info, request);
    request.bits = static_cast<std::uint32_t>(reader.number("bits").value_or(0));
    return request;
}

std::size_t most_bytes(const ImageRequest& request, const SceneInfo& info) {
    const std::size_t half = 2, single = 4, components = 4, colours = 3;
    const std::size_t pixels = std::size_t{request.view.width} * request.view.height;
    const auto of_pixel = [&]() -> std::size_t {
        switch (request.format) {
            case Format::png:
                return colours;
            case Format::exr:
                return info.channels * single;
            case Format::stokes_f16:
            case Format::stokes_planes:
                return info.channels * components * half;
            default:
                return info.channels * components * single;
        }
    };
    // The bound includes headers, tables of lines, and the overhead of compressors for incompressible data.
    constexpr std::size_t header = 16384, of_line = 64;
    const std::size_t content = pixels * of_pixel();
    return header + request.view.height * of_line + content + content / 256;
}

std::string canonical(const ImageRequest& request, const SceneInfo& info) {
    const View& view = request.view;
    std::string text = info.id;
    text.append("/").append(resource_of(request.format).name);
    text += "?size=" + std::to_string(view.width) + "x" + std::to_string(view.height);
    if (view.camera == CameraKind::orbit)
        text += "&azimuth=" + json_number(view.orbit.azimuth) +
                "&elevation=" + json_number(view.orbit.elevation) +
                "&distance=" + json_number(view.orbit.distance) +
                "&target=" + list(view.orbit.target.data(), 3);
    if (view.camera == CameraKind::matrix) text += "&matrix=" + list(view.matrix.data(), 16);
    if (view.fov > 0) text += "&fov=" + json_number(view.fov);
    text += "&light=" + json_number(view.light) + "&light_tilt=" + json_number(view.light_tilt);
    if (view.order_low >= 0) text += "&order_low=" + std::to_string(view.order_low);
    if (view.order_high >= 0) text += "&order_high=" + std::to_string(view.order_high);
    if (view.tolerance > 0) text += "&tolerance=" + json_number(view.tolerance);
    if (view.samples > 1) text += "&samples=" + std::to_string(view.samples);
    if (has_observer(request.format)) {
        text += "&observer=" + std::to_string(static_cast<unsigned>(request.observer));
        text += "&polarizer=" + json_number(request.polarizer) +
                "&exposure=" + json_number(request.exposure) + "&scale=" + json_number(request.scale);
    }
    if (request.bits > 0) text += "&bits=" + std::to_string(request.bits);
    if (request.deflate) text += "&deflate";
    return text;
}
