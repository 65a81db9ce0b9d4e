// SPDX-License-Identifier: MIT
#include "material/film.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "error.hpp"
#include "material/key.hpp"
#include "material/reflectance.hpp"
#include "material/spectrum_weights.hpp"

namespace nicol {
namespace {

// Visible wavelengths, nm.
constexpr int kShortest = 380;
constexpr int kLongest = 780;

// Largest difference of a film's phase between neighbours, in radians, of wavelengths and of angles.
constexpr double kWavelengthStep = 0.15;
constexpr double kAngleStep = 0.04;
constexpr double kFewestEntries = 257;
constexpr double kMostEntries = 2049;

// A wavelength and its weight in each channel.
struct Sample {
    double wavelength;
    std::vector<double> weights;
};

std::vector<Sample> samples_of(const FilmParameters& film, double largest_index) {
    std::vector<Sample> out;
    for (std::size_t c = 0; c < film.wavelengths.size(); ++c) {
        std::vector<double> weights(film.wavelengths.size());
        weights[c] = 1;
        out.push_back({film.wavelengths[c], std::move(weights)});
    }
    if (!out.empty()) return out;
    const double phase_per_nm =
        4 * std::numbers::pi * largest_index * film.thickness / (kShortest * kShortest);
    const int step = static_cast<int>(std::clamp(kWavelengthStep / phase_per_nm, 1.0, 5.0));
    std::vector<double> wavelengths;
    for (int nm = kShortest; nm <= kLongest; nm += step) wavelengths.push_back(nm);
    const ChannelWeights weights = rgb_weights(wavelengths);
    for (std::size_t k = 0; k < wavelengths.size(); ++k)
        out.push_back({wavelengths[k], {weights[0][k], weights[1][k], weights[2][k]}});
    return out;
}

SpShares clipped(SpShares shares) {
    shares.s = std::clamp(shares.s, 0.0, 1.0);
    shares.p = std::clamp(shares.p, 0.0, 1.0);
    const double most = std::sqrt(shares.s * shares.p);
    const double length = std::abs(shares.correlation);
    if (length > most) shares.correlation *= most / length;
    return shares;
}

FilmSplit clipped(const FilmSplit& split) {
    return {clipped(split.front), clipped(split.back), clipped(split.transmission)};
}

void add(FilmSplit& sum, double weight, const FilmSplit& split) {
    sum.front += weight * split.front;
    sum.back += weight * split.back;
    sum.transmission += weight * split.transmission;
}

// Place between two entries of a table.
template <class Real>
struct Between {
    std::size_t lower;
    Real share;  // share of the upper entry
};

// position: 0..1; numbers beyond, and NaN, become 0 or 1.
template <class Real>
Between<Real> between(Real position, std::size_t entries) {
    const Real scaled = position > 0 ? std::min(position, Real{1}) * static_cast<Real>(entries - 1) : Real{0};
    const auto lower = std::min(static_cast<std::size_t>(scaled), entries - 2);
    return {lower, scaled - static_cast<Real>(lower)};
}

FilmSplit interpolated(const std::vector<FilmSplit>& table, double position) {
    const auto [lower, share] = between(position, table.size());
    FilmSplit out;
    add(out, 1 - share, table[lower]);
    add(out, share, table[lower + 1]);
    return out;
}

}  // namespace

void check_film(const FilmParameters& film) {
    check_range(film.thickness, 0, kThickestFilm, "film_thickness");
    if (film.eta.empty()) throw Error(ErrorCode::invalid_argument, "film_eta has no value");
    for (const std::complex<double> eta : film.eta) {
        check_range(eta.real(), 0.1, 100, "film_eta");
        check_range(-eta.imag(), 0, 100, "film_k");
    }
    for (const double wavelength : film.wavelengths)
        check_range(wavelength, 100, 5000, "wavelengths of the film");
    const auto channels = static_cast<std::size_t>(film.channels());
    if (film.eta.size() != 1) check_channels(film.eta.size(), "film_eta", channels, "the film");
}

FilmTable::FilmTable(const FilmParameters& film, double outside, std::vector<std::complex<double>> inside,
                     Kind kind)
    : outside_(outside), eta_(std::move(inside)), tables_(static_cast<std::size_t>(film.channels())) {
    check_film(film);
    if (eta_.size() != 1) check_channels(eta_.size(), "eta", tables_.size(), "the film");
    for (std::complex<double>& eta : eta_) eta /= outside;
    const bool transmits = eta_.size() == 1 && eta_.front().imag() == 0;
    if (transmits) {
        const double eta = eta_.front().real();
        lower_ = std::min(1.0, eta);
        excess_ = std::abs(eta * eta - 1);
    }
    key_ = Key("film")
               .add("thickness", film.thickness)
               .add("eta", film.eta)
               .add("wavelengths", film.wavelengths)
               .add("outside", outside)
               .add("inside", eta_)
               .add("slab", kind == Kind::slab)
               .text();

    const double shortest = film.wavelengths.empty() ? static_cast<double>(kShortest)
                                                     : *std::ranges::min_element(film.wavelengths);
    const double phase = 8 * std::numbers::pi * film.thickness / shortest;
    const auto entries =
        static_cast<std::size_t>(std::clamp(phase / kAngleStep, kFewestEntries, kMostEntries));
    std::vector<std::vector<FilmSplit>> refracted = tabulate(film, false, entries, kind);
    std::vector<std::vector<FilmSplit>> total(tables_.size());
    // Light never arrives from within a slab.
    if (excess_ > 0 && (kind == Kind::interface || lower_ < 1)) total = tabulate(film, true, entries, kind);
    for (std::size_t c = 0; c < tables_.size(); ++c) {
        tables_[c].refracted = std::move(refracted[c]);
        tables_[c].total = std::move(total[c]);
        for (const FilmSplit& split : tables_[c].refracted) {
            const auto [a, b, re, im] = block_of(split.front);
            tables_[c].in_front.push_back({static_cast<float>(a), static_cast<float>(b),
                                           static_cast<float>(re), static_cast<float>(im)});
        }
    }
}

std::vector<std::vector<FilmSplit>> FilmTable::tabulate(const FilmParameters& film, bool total,
                                                        std::size_t entries, Kind kind) const {
    double largest = 0;
    for (const std::complex<double> eta : film.eta) largest = std::max(largest, eta.real());
    const std::vector<Sample> samples = samples_of(film, largest);
    const auto of = [](const std::vector<std::complex<double>>& values, std::size_t c) {
        return values[values.size() == 1 ? 0 : c];
    };
    const bool same = film.eta.size() == 1 && eta_.size() == 1;
    std::vector<std::vector<FilmSplit>> out(tables_.size(), std::vector<FilmSplit>(entries));
    tbb::parallel_for(std::size_t{0}, entries, [&](std::size_t i) {
        const double x = static_cast<double>(i) / static_cast<double>(entries - 1);
        // Both parameters make the table smooth at grazing and at the critical angle.
        const double decay = std::sin(x * std::numbers::pi / 2);
        const double tangential2 =
            lower_ * lower_ + (total ? excess_ * decay * decay : -lower_ * lower_ * x * x * x * x);
        for (const Sample& sample : samples) {
            FilmSplit split;
            bool known = false;
            for (std::size_t c = 0; c < tables_.size(); ++c) {
                if (sample.weights[c] == 0) continue;
                if (!known) {
                    const ThinFilm of_channel{film.thickness, of(film.eta, c) / outside_};
                    split = film_split(tangential2, of(eta_, c), of_channel, sample.wavelength / outside_);
                    if (kind == Kind::slab) split = slab_of(split);
                    known = same;
                }
                add(out[c][i], sample.weights[c], split);
            }
        }
        for (auto& table : out) table[i] = clipped(table[i]);
    });
    return out;
}

ReflectionBlock<double> FilmTable::reflection(int channel, double cosine) const {
    return block_of(split(channel, cosine, false).front);
}

void FilmTable::reflection_lanes(int channel, const Lanes& cosines, ReflectionBlock<Lanes>& out) const {
    const Channel& table = tables_[static_cast<std::size_t>(channel)];
    // A medium of higher index in front has its own cosine, and reflects totally.
    const bool direct = table.total.empty() || lower_ == 1;
    for (std::size_t i = 0; i < kLanes; ++i) {
        if (!direct) {
            const auto [a, b, c, d] =
                reflection(channel, std::clamp(static_cast<double>(cosines[i]), 0.0, 1.0));
            out.a[i] = static_cast<float>(a);
            out.b[i] = static_cast<float>(b);
            out.c[i] = static_cast<float>(c);
            out.d[i] = static_cast<float>(d);
            continue;
        }
        const auto [lower, share] =
            between(cosines[i] > 0 ? std::sqrt(cosines[i]) : 0.0F, table.in_front.size());
        const std::array<float, 4>& below = table.in_front[lower];
        const std::array<float, 4>& above = table.in_front[lower + 1];
        out.a[i] = below[0] + share * (above[0] - below[0]);
        out.b[i] = below[1] + share * (above[1] - below[1]);
        out.c[i] = below[2] + share * (above[2] - below[2]);
        out.d[i] = below[3] + share * (above[3] - below[3]);
    }
}

FilmSplit FilmTable::split(int channel, double cosine, bool from_behind) const {
    const Channel& table = tables_[tables_.size() == 1 ? 0 : static_cast<std::size_t>(channel)];
    const double index = from_behind ? eta_.front().real() : 1.0;
    const bool higher = index > lower_;
    // Square of the normal part of the wave vector in the medium of lower index.
    const double normal2 = index * index * cosine * cosine - (higher ? excess_ : 0);
    if (normal2 >= 0 || table.total.empty())
        return interpolated(table.refracted, std::sqrt(std::sqrt(std::max(normal2, 0.0)) / lower_));
    return interpolated(table.total,
                        std::atan2(std::sqrt(-normal2), index * cosine) / (std::numbers::pi / 2));
}

FilmTablePtr film_table(const FilmParameters& film, double outside, std::vector<std::complex<double>> inside,
                        FilmTable::Kind kind) {
    if (!film.present()) return nullptr;
    return std::make_shared<const FilmTable>(film, outside, std::move(inside), kind);
}

}  // namespace nicol
