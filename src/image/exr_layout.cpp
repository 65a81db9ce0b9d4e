// SPDX-License-Identifier: MIT
// Assignment of an OpenEXR file's channels to Stokes components of colours or wavelengths.
#include "image/exr_layout.hpp"

#include <ImfChannelList.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include "error.hpp"
#include "files/file_error.hpp"
#include "image/stokes_image.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

/// Returns the nanometres of "550,000000nm", "5,5E2nm" or "545,077196THz"; nothing for other texts.
std::optional<double> parse_wavelength(std::string_view text) {
    std::string number(text.substr(0, text.find_first_not_of("0123456789,Ee+-")));
    // A trailing E belongs to the unit (1Em is an exametre). The letters of other prefixes do not occur in
    // numbers.
    if (!number.empty() && (number.back() == 'E' || number.back() == 'e')) number.pop_back();
    const std::string_view unit = text.substr(number.size());
    std::ranges::replace(number, ',', '.');
    double value = 0;
    const auto parsed = std::from_chars(number.data(), number.data() + number.size(), value);
    if (number.empty() || parsed.ec != std::errc() || parsed.ptr != number.data() + number.size())
        return std::nullopt;

    // Powers of ten of the prefixes.
    static const std::map<std::string_view, int> prefixes = {
        {"Y", 24}, {"Z", 21}, {"E", 18}, {"P", 15}, {"T", 12}, {"G", 9},  {"M", 6},  {"k", 3},  {"h", 2},
        {"da", 1}, {"", 0},   {"d", -1}, {"c", -2}, {"m", -3}, {"u", -6}, {"n", -9}, {"p", -12}};
    const bool frequency = unit.ends_with("Hz");
    if (!frequency && !unit.ends_with("m")) return std::nullopt;
    const auto prefix = prefixes.find(unit.substr(0, unit.size() - (frequency ? 2 : 1)));
    if (prefix == prefixes.end()) return std::nullopt;
    constexpr double light_speed = 299792458e9;  // nm / s
    const double nanometres = frequency ? light_speed / (value * std::pow(10, prefix->second))
                                        : value * std::pow(10, prefix->second + 9);
    if (!(nanometres > 0) || std::isinf(nanometres)) return std::nullopt;
    return nanometres;
}

struct SpectralName {
    std::size_t component;
    double nanometres;
    std::string colour;
};

std::optional<SpectralName> parse_spectral(std::string_view name) {
    if (name.size() < 4 || name[0] != 'S' || name[1] < '0' || name[1] > '3' || name[2] != '.')
        return std::nullopt;
    const std::optional<double> nanometres = parse_wavelength(name.substr(3));
    if (!nanometres) return std::nullopt;
    return SpectralName{static_cast<std::size_t>(name[1] - '0'), *nanometres, std::string(name.substr(3))};
}

/// Returns the wavelengths and channel names that were requested.
std::vector<std::pair<double, std::string>> choose(const path& file,
                                                   const std::map<double, std::string>& there,
                                                   std::span<const double> requested) {
    if (requested.empty()) {
        if (there.size() > kMaxFileChannels)
            unsupported_file(file, "has " + std::to_string(there.size()) + " wavelengths from " +
                                       std::to_string(there.begin()->first) + " to " +
                                       std::to_string(there.rbegin()->first) + " nm; choose at most " +
                                       std::to_string(kMaxFileChannels) + " of them");
        return {there.begin(), there.end()};
    }
    std::vector<std::pair<double, std::string>> chosen;
    for (const double nm : requested) {
        // Names are written with rounded decimals, so the limits have a tolerance.
        constexpr double rounding = 1e-3;
        if (!(nm >= there.begin()->first - rounding && nm <= there.rbegin()->first + rounding))
            throw Error(ErrorCode::invalid_argument,
                        file.string() + ": wavelength " + std::to_string(nm) + " nm lies outside " +
                            std::to_string(there.begin()->first) + " to " +
                            std::to_string(there.rbegin()->first) + " nm, which the file has");
        chosen.emplace_back(*std::ranges::min_element(
            there, {}, [&](const auto& entry) { return std::abs(entry.first - nm); }));
    }
    return chosen;
}

bool is_left_handed(const path& file, const Imf::Header& header) {
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>("polarisationHandedness");
    if (attribute == nullptr || attribute->value() == "right") return false;
    if (attribute->value() != "left")
        invalid_file(file,
                     "polarisationHandedness is \"" + attribute->value() + "\"; it must be right or left");
    return true;
}

/// Sets the names of all components of these colours. s0 comes from its plain name if S0 is absent.
void name_channels(const path& file, const Imf::ChannelList& list, const std::vector<std::string>& colours,
                   ExrLayout& layout) {
    const auto has = [&](const std::string& name) { return list.findChannel(name) != nullptr; };
    std::array<bool, 4> present{};
    for (std::size_t p = 0; p < 4; ++p)
        for (const std::string& colour : colours) present[p] = present[p] || has(exr_channel(p, colour));
    // s1 and s2 mix when the frame rotates, so one is meaningless without the other.
    if (present[1] || present[2] || present[3]) present[1] = present[2] = true;
    if (!layout.wavelengths.empty()) present[0] = true;

    layout.names.resize(colours.size());
    for (std::size_t c = 0; c < colours.size(); ++c) {
        for (std::size_t p = 0; p < 4; ++p) {
            if (p > 0 && !present[p]) continue;
            const std::string name = p == 0 && !present[0] ? colours[c] : exr_channel(p, colours[c]);
            const Imf::Channel* channel = list.findChannel(name);
            if (channel == nullptr)
                invalid_file(file, "has no channel " + name + ", which its others call for");
            if (channel->xSampling != 1 || channel->ySampling != 1)
                unsupported_file(file, "channel " + name + " is subsampled; write it at full resolution");
            layout.names[c][p] = name;
        }
    }
}

}  // namespace

std::string exr_channel(std::size_t component, const std::string& colour) {
    return std::string("S").append(std::to_string(component)).append(".").append(colour);
}

std::string exr_wavelength(double nanometres) {
    std::array<char, 400> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), nanometres, std::chars_format::fixed, 6).ptr;
    std::string text(digits.begin(), end);
    std::ranges::replace(text, '.', ',');
    return text + "nm";
}

ExrLayout find_exr_layout(const path& file, const Imf::Header& header, std::span<const double> wavelengths) {
    const Imf::ChannelList& list = header.channels();
    const auto has = [&](const std::string& name) { return list.findChannel(name) != nullptr; };
    ExrLayout layout;

    std::map<double, std::string> spectral;
    bool reflectance = false;
    for (auto i = list.begin(); i != list.end(); ++i) {
        const std::string_view name = i.name();
        reflectance = reflectance || (name.starts_with("T.") && parse_wavelength(name.substr(2)));
        const std::optional<SpectralName> parsed = parse_spectral(name);
        if (!parsed) continue;
        const auto [there, added] = spectral.emplace(parsed->nanometres, parsed->colour);
        if (!added && there->second != parsed->colour)
            invalid_file(
                file, "has channels " + there->second + " and " + parsed->colour + " of the same wavelength");
    }
    if (!spectral.empty()) {
        std::vector<std::string> colours;
        for (const auto& [nm, colour] : choose(file, spectral, wavelengths)) {
            layout.wavelengths.push_back(nm);
            colours.push_back(colour);
        }
        layout.left_handed = is_left_handed(file, header);
        name_channels(file, list, colours, layout);
        return layout;
    }
    if (!wavelengths.empty())
        throw Error(ErrorCode::invalid_argument, file.string() + ": has no wavelengths to choose from");

    if (has("RY") || has("BY"))
        unsupported_file(file, "stores luminance and chroma (RY, BY); write R G B instead");
    std::vector<std::string> colours;
    for (const char* colour : {"R", "G", "B"})
        if (has(colour) || has(exr_channel(0, colour))) colours = {"R", "G", "B"};
    if (colours.empty() && (has("Y") || has("S0.Y"))) colours = {"Y"};
    const bool numbered = colours.empty();
    while (numbered && has(exr_channel(0, std::to_string(colours.size()))))
        colours.push_back(std::to_string(colours.size()));
    if (colours.empty() && reflectance)
        unsupported_file(file, "holds reflectances (T channels); light has S0 channels");
    if (colours.empty())
        invalid_file(file, "has neither R G B nor Y nor S0.R S0.G S0.B nor S0.Y nor S0.0 nor S0.550nm");
    if (colours.size() > kMaxFileChannels)
        unsupported_file(file, "has " + std::to_string(colours.size()) + " channels; at most " +
                                   std::to_string(kMaxFileChannels) + " are possible");
    name_channels(file, list, colours, layout);
    return layout;
}

}  // namespace nicol
