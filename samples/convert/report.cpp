// SPDX-License-Identifier: MIT
// Reports as text.
#include "report.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>

namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string percent(double part) {
    char text[32];
    std::snprintf(text, sizeof text, part < 0.01 ? "%.2g %%" : "%.1f %%", 100 * part);
    return text;
}

// Light that violates Eq. 70 has a degree of polarization without bound or meaning.
std::string degree(double part) {
    return part > 1.001 ? "> 100 %" : percent(part);
}

std::string joined(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
    return out;
}

// Lines "label  value", and rows with one column per channel.
class Page {
public:
    void line(const std::string& label, const std::string& value) { text_ += padded(label) + value + "\n"; }
    void row(const std::string& label, const std::vector<std::string>& cells) {
        text_ += padded(label);
        for (const std::string& cell : cells)
            text_ += std::string(cell.size() < 12 ? 12 - cell.size() : 1, ' ') + cell;
        text_ += "\n";
    }
    void row(const std::string& label, std::uint32_t channels,
             const std::function<std::string(std::uint32_t)>& cell) {
        std::vector<std::string> cells;
        for (std::uint32_t c = 0; c < channels; ++c) cells.push_back(cell(c));
        row(label, cells);
    }
    void gap(const std::string& title = {}) { text_ += "\n" + (title.empty() ? "" : title + "\n"); }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    static std::string padded(const std::string& label) {
        return "  " + label + std::string(label.size() < 22 ? 22 - label.size() : 1, ' ');
    }
    std::string text_;
};

// Returns the first order of each line: single orders up to 16, then octaves.
std::vector<std::uint32_t> order_lines(std::uint32_t order) {
    std::vector<std::uint32_t> first;
    for (std::uint32_t l = 0; l <= order; l = l < 16 ? l + 1 : (l == 16 ? 17 : 2 * l - 1)) first.push_back(l);
    first.push_back(order + 1);
    return first;
}

// Adds energy(l, column) in lines of orders, with the cumulative share of the total.
void add_energy(Page& page, std::uint32_t order, const std::vector<std::string>& columns,
                const std::function<double(std::uint32_t, std::size_t)>& energy) {
    double total = 0;
    for (std::uint32_t l = 0; l <= order; ++l)
        for (std::size_t i = 0; i < columns.size(); ++i) total += energy(l, i);
    std::vector<std::string> heads = columns;
    heads.emplace_back("up to here");
    page.row("order", heads);
    double reached = 0;
    const std::vector<std::uint32_t> first = order_lines(order);
    for (std::size_t line = 0; line + 1 < first.size(); ++line) {
        const std::uint32_t last = first[line + 1] - 1;
        std::vector<std::string> cells;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            double sum = 0;
            for (std::uint32_t l = first[line]; l <= last; ++l) sum += energy(l, i);
            reached += sum;
            cells.push_back(number(sum < 1e-15 * total ? 0 : sum));
        }
        char share[32];
        std::snprintf(share, sizeof share, "%.4f %%", total > 0 ? 100 * reached / total : 0);
        cells.emplace_back(share);
        page.row(std::to_string(first[line]) + (last > first[line] ? " to " + std::to_string(last) : ""),
                 cells);
    }
}

}  // namespace

std::string kind_name(nicol_file_kind kind) {
    switch (kind) {
        case NICOL_FILE_LIGHT_IMAGE:
            return "light as an equirectangular image (.exr)";
        case NICOL_FILE_LIGHT_CROSS:
            return "light as a cube map (four cross images, _s0.exr to _s3.exr)";
        case NICOL_FILE_LIGHT_PSH:
            return "light as coefficients (SHVec .npz)";
        case NICOL_FILE_MATERIAL_PSH:
            return "material as a coefficient matrix (SHMat .npz, ISOBI2)";
        case NICOL_FILE_MATERIAL_MEASURED:
            return "measured material (.pbsdf)";
        case NICOL_FILE_MATERIAL_TABLE:
            return "material as a response table (.response)";
        default:
            return "unknown";
    }
}

std::vector<std::string> channel_names(std::uint32_t channels, const double* wavelengths) {
    std::vector<std::string> names;
    for (std::uint32_t c = 0; c < channels; ++c) {
        if (wavelengths[c] > 0)
            names.push_back(number(wavelengths[c]) + " nm");
        else if (channels == 3)
            names.emplace_back(1, "RGB"[c]);
        else
            names.push_back(channels == 1 ? "Y" : std::to_string(c));
    }
    return names;
}

std::string as_text(const LightReport& report) {
    const nicol_light_report& n = report.numbers;
    const std::vector<std::string> names = channel_names(n.channels, n.wavelengths);
    const bool coefficients = n.kind == NICOL_FILE_LIGHT_PSH;
    // Coefficients of linearly polarized light may hold rounding errors for s3.
    const double most_s3 = *std::max_element(n.largest_circular, n.largest_circular + n.channels);
    const bool circular = n.circular != 0 && most_s3 > 1e-6;
    const double most_linear = *std::max_element(n.largest_dolp, n.largest_dolp + n.channels);
    const bool linear = n.polarized != 0 && most_linear > 1e-6;
    Page page;
    page.line("kind", kind_name(n.kind));
    page.line("channels", std::to_string(n.channels) + ": " + joined(names));
    if (coefficients) page.line("orders", "0 to " + std::to_string(n.order));
    page.line(coefficients ? "seen at" : "size",
              std::to_string(n.width) + " x " + std::to_string(n.height) + " pixels");
    page.line("polarization", std::string(linear     ? "linear"
                                          : circular ? ""
                                                     : "none") +
                                  (linear && circular ? " and " : "") + (circular ? "circular" : ""));
    page.gap();
    page.row("", names);
    const auto add = [&](const char* label, const double* values, std::string (*format)(double)) {
        page.row(label, n.channels, [&](std::uint32_t c) { return format(values[c]); });
    };
    add("mean s0", n.mean, number);
    add("smallest s0", n.smallest, number);
    add("largest s0", n.largest, number);
    for (std::uint32_t i = 0; i < 3; ++i) {
        page.row(std::string("comes from, ") + "xyz"[i], n.channels,
                 [&](std::uint32_t c) { return number(n.direction[3 * c + i]); });
    }
    if (linear) {
        add("mean DoLP", n.mean_dolp, percent);
        add("largest DoLP", n.largest_dolp, degree);
    }
    if (circular) add("largest |s3| / s0", n.largest_circular, degree);
    add("violates Eq. 70", n.unphysical, percent);
    add("  by, of mean s0", n.largest_excess, percent);
    page.gap("energy, all channels");
    const std::size_t orders = n.order + 1;
    add_energy(page, n.order, {"s0", "s1", "s2", "s3"}, [&](std::uint32_t l, std::size_t p) {
        double sum = 0;
        for (std::size_t c = 0; c < n.channels; ++c) sum += report.energy[4 * (c * orders + l) + p];
        return sum;
    });
    return report.file + "\n" + page.text();
}

std::string as_text(const MaterialReport& report) {
    const nicol_material_report& n = report.numbers;
    const std::vector<std::string> names = channel_names(n.channels, n.wavelengths);
    Page page;
    page.line("kind", kind_name(n.kind));
    page.line("channels", std::to_string(n.channels) + ": " + joined(names));
    if (n.measured_wavelengths != 0)
        page.line("measured at", std::to_string(n.measured_wavelengths) + " wavelengths, " +
                                     number(n.measured_range[0]) + " to " + number(n.measured_range[1]) +
                                     " nm");
    else
        page.line("orders of the file", "0 to " + std::to_string(n.file_order));
    page.line("examined orders", "0 to " + std::to_string(n.order));
    if (n.stokes_columns < 4)
        page.line("made for", n.stokes_columns == 1 ? "unpolarized light" : "linearly polarized light");
    page.gap();
    page.row("", names);
    const auto add = [&](const std::string& label, const double* values, std::string (*format)(double),
                         std::size_t stride = 1) {
        page.row(label, n.channels, [&](std::uint32_t c) { return format(values[stride * c]); });
    };
    add("albedo", n.albedo, number);
    add("largest albedo", n.largest_albedo, number);
    add("asymmetry", n.asymmetry, percent);
    add("violates Eq. 70", n.unphysical, percent);
    add("  by, of mean M00", n.excess, percent);
    page.gap("norms of the matrix, from light to reflected light");
    const char* const groups[] = {"s0", "s1 s2", "s3"};
    for (std::size_t in = 0; in < 3; ++in)
        for (std::size_t out = 0; out < 3; ++out)
            add(std::string(groups[in]) + " to " + groups[out], n.norms + 3 * out + in, number, 9);
    page.gap("energy of the matrix");
    add_energy(page, n.order, names,
               [&](std::uint32_t l, std::size_t c) { return report.energy[c * (n.order + 1) + l]; });
    return report.file + "\n" + page.text();
}
