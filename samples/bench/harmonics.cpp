// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <nicol_psh.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "common/handles.hpp"
#include "median.hpp"
#include "peer.hpp"

namespace {

const double not_measured = std::nan("");

/// Returns the median seconds per call of each contestant. Contestants alternate in one process. Every
/// contestant runs once untimed; then all alternate until `seconds` have passed, for at least five rounds. A
/// run repeats the call for about a millisecond, because clocks are coarse.
std::vector<double> contest(const std::vector<std::function<void()>>& contestants, double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto elapsed = [](Clock::time_point since) {
        return std::chrono::duration<double>(Clock::now() - since).count();
    };
    std::vector<int> repeats;
    for (const auto& run : contestants) {
        run();
        const auto start = Clock::now();
        run();
        repeats.push_back(static_cast<int>(std::clamp(1e-3 / std::max(elapsed(start), 1e-9), 1.0, 1e5)));
    }
    std::vector<std::vector<double>> times(contestants.size());
    const auto begin = Clock::now();
    while (times.front().size() < 5 || elapsed(begin) < seconds) {
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            const auto start = Clock::now();
            for (int r = 0; r < repeats[i]; ++r) contestants[i]();
            times[i].push_back(elapsed(start) / repeats[i]);
        }
    }
    std::vector<double> medians;
    for (auto& list : times) medians.push_back(median(std::move(list)));
    return medians;
}

std::size_t coefficient_count(int order) {
    return std::size_t{4} * static_cast<std::size_t>((order + 1) * (order + 1));
}

enum class Parts { linear, all };

// Returns random coefficients of s1 and s2, or of all components.
std::vector<double> random_field(int order, Parts parts) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> value(-1, 1);
    std::vector<double> field(coefficient_count(order));
    for (std::size_t i = 0; i < field.size(); ++i) {
        const bool linear = i % 4 == 1 || i % 4 == 2;
        if (linear ? i / 4 >= 4 : parts == Parts::all) field[i] = value(random);
    }
    return field;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

void bench_transform(Report& report, int order, Parts parts, double seconds) {
    nicol_psh_sampling sampling = NICOL_PSH_SAMPLING_INIT;
    sampling.grid = NICOL_PSH_GRID_GAUSS_LEGENDRE;
    sampling.order = static_cast<std::uint32_t>(order);
    sampling.rows = static_cast<std::uint32_t>(order + 1);
    sampling.columns = static_cast<std::uint32_t>(2 * order + 2);
    nicol_psh_transform transform = nullptr;
    check(nicol_psh_transform_create(&sampling, &transform));
    const std::vector<double> field = random_field(order, parts);
    std::vector<double> samples(std::size_t{4} * sampling.rows * sampling.columns);
    std::vector<double> back(field.size());
    const auto synthesize = [&] {
        check(nicol_psh_synthesize(transform, 1, field.data(), field.size(), samples.data(), samples.size()));
    };
    const auto analyze = [&] {
        check(nicol_psh_analyze(transform, 1, samples.data(), samples.size(), back.data(), back.size()));
    };
    synthesize();
    analyze();
    const double error = largest_difference(field, back);

    std::vector<std::function<void()>> contestants{synthesize, analyze};
    const std::unique_ptr<PeerTransform> peer = libsharp_transform(order);
    if (peer) {
        contestants.emplace_back([&] {
            peer->synthesize_spin2();
            if (parts == Parts::all) peer->synthesize_scalar(), peer->synthesize_scalar();
        });
        contestants.emplace_back([&] {
            peer->analyze_spin2();
            if (parts == Parts::all) peer->analyze_scalar(), peer->analyze_scalar();
        });
    }
    const std::vector<double> seconds_a_call = contest(contestants, seconds);
    const std::string what =
        std::string(parts == Parts::all ? "s0..s3" : "s1, s2") + ", L = " + std::to_string(order);
    report.add(what + ", synthesis",
               {peer ? seconds_a_call[0] / seconds_a_call[2] : not_measured, 1e6 * seconds_a_call[0], error});
    report.add(what + ", analysis",
               {peer ? seconds_a_call[1] / seconds_a_call[3] : not_measured, 1e6 * seconds_a_call[1], error});
    check(nicol_psh_transform_release(transform));
}

void bench_rotation(Report& report, int order, double seconds) {
    constexpr std::uint64_t batch = 64;
    const std::vector<double> field = random_field(order, Parts::all);
    std::vector<double> many;
    for (std::uint64_t i = 0; i < batch; ++i) many.insert(many.end(), field.begin(), field.end());
    const double c = std::cos(0.7);
    const double s = std::sin(0.7);
    // The rotation is Rz(0.7) Ry(0.7), because 0.7 is no special angle.
    const double rotation[9] = {c * c, -s, c * s, s * c, c, s * s, -s, 0, c};
    const double inverse[9] = {c * c, s * c, -s, -s, c, 0, c * s, s * s, c};
    std::vector<double> out(many.size());
    const auto rotate = [&](std::uint64_t vectors, const std::vector<double>& from, const double* r) {
        check(nicol_psh_rotate(static_cast<std::uint32_t>(order), vectors, from.data(), from.size(), r,
                               out.data(), from.size()));
    };
    rotate(1, field, rotation);
    std::vector<double> rotated(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(field.size()));
    rotate(1, rotated, inverse);
    out.resize(field.size());
    const double error = largest_difference(field, out);
    out.resize(many.size());
    const std::vector<double> seconds_a_call =
        contest({[&] { rotate(1, field, rotation); }, [&] { rotate(batch, many, rotation); }}, seconds);
    const std::string what = "rotation, L = " + std::to_string(order);
    report.add(what + ", one field, set-up included", {not_measured, 1e6 * seconds_a_call[0], error});
    report.add(what + ", of 64 at once", {not_measured, 1e6 * seconds_a_call[1] / batch, error});
}

void bench_projection(Report& report, double seconds) {
    nicol_image image = NICOL_IMAGE_INIT;
    image.width = 4096;
    image.height = 2048;
    image.channels = 3;
    image.components = 4;
    std::vector<float> pixels(std::size_t{image.width} * image.height * image.channels * image.components);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i] = i % 4 == 0 ? 1.0F + 0.1F * static_cast<float>(i % 97) : 0.2F;
    }
    image.pixels = pixels.data();
    image.byte_size = pixels.size() * sizeof(float);
    std::vector<double> coefficients(3 * coefficient_count(9));
    float sum = 0;
    const std::vector<double> seconds_a_call =
        contest({[&] { check(nicol_psh_project_image(&image, 9, coefficients.data(), coefficients.size())); },
                 [&] {
                     float lanes[16] = {};
                     for (std::size_t i = 0; i < pixels.size(); i += 16) {
                         for (std::size_t k = 0; k < 16; ++k) lanes[k] += pixels[i + k];
                     }
                     sum = std::accumulate(std::begin(lanes), std::end(lanes), 0.0F);
                 }},
                seconds);
    const double gigabytes = static_cast<double>(image.byte_size) * 1e-9;
    report.add("projection of 4096 x 2048 RGB Stokes, L = 9 (peer: a plain read)",
               {seconds_a_call[0] / seconds_a_call[1], 1e6 * seconds_a_call[0], not_measured});
    report.note("Projection reads " + std::to_string(gigabytes / seconds_a_call[0]) +
                " GB/s on all cores; the plain read, on one, " +
                std::to_string(gigabytes / seconds_a_call[1]) + (sum == 0 ? " GB/s" : " GB/s."));
}

}  // namespace

Report bench_harmonics(double seconds) {
    Report report({"what", "ratio to peer", "microseconds", "round-trip error"});
    for (const Parts parts : {Parts::linear, Parts::all}) {
        for (const int order : {9, 32, 100, 300, 1000}) bench_transform(report, order, parts, seconds);
    }
    for (const int order : {9, 32}) bench_rotation(report, order, seconds);
    bench_projection(report, seconds);
    report.note(
        "Transforms and rotation run on one thread, on order + 1 Gauss-Legendre rows of 2 order + 2 "
        "columns.");
#ifndef NICOL_BENCH_LIBSHARP
    report.note(
        "Built without a peer; configure with -DNICOL_BENCH_LIBSHARP=ON where libsharp is installed.");
#endif
    return report;
}
