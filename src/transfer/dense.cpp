// SPDX-License-Identifier: MIT
#include "transfer/dense.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "harmonics/rotation.hpp"
#include "polarization/stokes.hpp"
#include "simd/dispatch.hpp"
#include "simd/work_space.hpp"

namespace nicol {
namespace {

// Returns the number of rows rounded up to whole vectors of eight.
std::size_t padded(std::size_t rows) {
    return (rows + 7) / 8 * 8;
}

std::vector<std::size_t> columns_of(int order, LightKind kind) {
    std::vector<std::size_t> columns;
    for (std::size_t p = 0; p < static_cast<std::size_t>(kind); ++p) {
        for (std::size_t i = p == 1 || p == 2 ? psh_count(1) : 0; i < psh_count(order); ++i) {
            columns.push_back(4 * i + p);
        }
    }
    return columns;
}

// Returns the smallest kind that contains the outgoing Stokes components of these channels.
LightKind kind_out(std::span<const IsotropicMatrix> channels, LightKind kind_in) {
    LightKind kind = LightKind::unpolarized;
    for (const IsotropicMatrix& matrix : channels) {
        for (int m = 0; m <= std::min(matrix.order_in(), matrix.order_out()); ++m) {
            for (int out = m; out <= matrix.order_out(); ++out) {
                for (int in = m; in <= matrix.order_in(); ++in) {
                    const IsotropicMatrix::Block& block = matrix.block(m, out, in);
                    // Rows and columns of a block are s0, s3, w, conj w.
                    const auto any = [&block, kind_in](std::size_t row) {
                        const std::complex<double> zero = 0;
                        return block[4 * row] != zero ||
                               (kind_in == LightKind::full && block[4 * row + 1] != zero) ||
                               (kind_in != LightKind::unpolarized &&
                                (block[4 * row + 2] != zero || block[4 * row + 3] != zero));
                    };
                    if (any(1)) return LightKind::full;
                    if (any(2) || any(3)) kind = LightKind::linear;
                }
            }
        }
    }
    return kind;
}

// Adds to `out`: a matrix of `columns` columns of `rows` numbers each, times x.
[[gnu::always_inline]] inline void multiply(std::size_t rows, std::size_t columns, const float* matrix,
                                            const float* x, float* out) {
    std::size_t j = 0;
    for (; j + 4 <= columns; j += 4) {
        const float* m = matrix + j * rows;
        const float x0 = x[j];
        const float x1 = x[j + 1];
        const float x2 = x[j + 2];
        const float x3 = x[j + 3];
#pragma omp simd
        for (std::size_t i = 0; i < rows; ++i) {
            out[i] += m[i] * x0 + m[rows + i] * x1 + m[2 * rows + i] * x2 + m[3 * rows + i] * x3;
        }
    }
    for (; j < columns; ++j) {
#pragma omp simd
        for (std::size_t i = 0; i < rows; ++i) out[i] += matrix[j * rows + i] * x[j];
    }
}

[[gnu::always_inline]] inline void add_scaled(std::size_t n, float factor, const float* from, float* to) {
#pragma omp simd
    for (std::size_t i = 0; i < n; ++i) to[i] += factor * from[i];
}

}  // namespace

DenseMaterial::DenseMaterial(std::span<const IsotropicMatrix> channels, LightKind kind)
    : outgoing_(channels.empty() ? -1 : channels.front().order_out(), kind_out(channels, kind)),
      columns_(columns_of(channels.front().order_in(), kind)) {
    for (const IsotropicMatrix& channel : channels) {
        const CoefficientMatrix matrix = channel.dense();
        std::vector<Entry>& entries = entries_.emplace_back();
        for (std::size_t row = 0; row < outgoing_.size(); ++row) {
            const auto& [first, second] = outgoing_.terms()[row];
            for (std::size_t column = 0; column < matrix.columns(); ++column) {
                const double value = first.factor * matrix(first.coefficient, column) +
                                     second.factor * matrix(second.coefficient, column);
                if (value != 0) entries.push_back({row, column, static_cast<float>(value)});
            }
        }
    }
}

DenseTransfer::DenseTransfer(std::shared_ptr<const DenseMaterial> material, std::size_t vertices)
    : material_(std::move(material)),
      vertices_(vertices),
      row_stride_(padded(material_->outgoing().size())),
      vertex_stride_(row_stride_ * material_->columns().size() *
                     static_cast<std::size_t>(material_->channels())),
      data_(std::make_unique_for_overwrite<float[]>(vertices * vertex_stride_)) {}

void DenseTransfer::apply(const PshVector& light, std::size_t first, std::size_t last, std::size_t out_first,
                          VertexLight& out) const {
    const std::vector<std::size_t>& columns = material_->columns();
    const std::size_t inputs = static_cast<std::size_t>(light.channels()) * columns.size();
    const std::span<float> work = work_space<DenseTransfer, float>(inputs + row_stride_);
    const std::span<float> x = work.first(inputs);
    const std::span<float> sums = work.subspan(inputs);
    for (int c = 0; c < light.channels(); ++c) {
        float* values = x.data() + static_cast<std::size_t>(c) * columns.size();
        for (const std::size_t column : columns) *values++ = static_cast<float>(light.channel(c)[column]);
    }
    const std::size_t matrix_size = row_stride_ * columns.size();
    for (std::size_t v = first; v < last; ++v) {
        const float* matrices = data_.get() + v * vertex_stride_;
        for (int c = 0; c < out.channels(); ++c) {
            std::ranges::fill(sums, 0.0F);
            const std::size_t channel = material_->channels() == 1 ? 0 : static_cast<std::size_t>(c);
            dispatch<multiply>(
                row_stride_, columns.size(), matrices + channel * matrix_size,
                x.data() + (light.channels() == 1 ? 0 : static_cast<std::size_t>(c)) * columns.size(),
                sums.data());
            const std::size_t to = out_first + v;
            const std::span<Lanes> numbers = out.block(to / kLanes, c);
            for (std::size_t row = 0; row < numbers.size(); ++row) numbers[row][to % kLanes] = sums[row];
        }
    }
}

DenseBuilder::DenseBuilder(std::shared_ptr<const DenseMaterial> material,
                           std::shared_ptr<const ShadowMatrix> shadows)
    : material_(std::move(material)),
      shadows_(std::move(shadows)),
      identity_(material_->order(), material_->order()),
      rotated_(material_->order(), material_->order()),
      rows_(rotated_.rows() * material_->columns().size()),
      products_(material_->outgoing().size() * material_->columns().size()) {
    for (std::size_t i = 0; i < identity_.rows(); ++i) identity_(i, i) = 1;
}

void DenseBuilder::build(const glm::vec3& normal, std::span<const double> visibility, std::span<float> out) {
    // Computes shadow x rotation by rotating the rows of the shadow matrix as if they were fields. The two
    // are equal because rotations are orthogonal.
    const PshRotation to_world(material_->order(), theta_phi_frame(glm::dvec3(normal)));
    if (visibility.empty()) {
        to_world.apply(identity_.data(), rotated_.data());
    } else {
        to_world.apply(shadows_->expand(visibility).data(), rotated_.data());
    }
    const std::vector<std::size_t>& columns = material_->columns();
    const std::size_t n = columns.size();
    for (std::size_t row = 0; row < rotated_.rows(); ++row) {
        for (std::size_t j = 0; j < n; ++j)
            rows_[row * n + j] = static_cast<float>(rotated_(row, columns[j]));
    }

    const std::size_t rows = material_->outgoing().size();
    const std::size_t stride = padded(rows);
    std::ranges::fill(out, 0.0F);
    for (std::size_t c = 0; c < material_->entries_.size(); ++c) {
        std::ranges::fill(products_, 0.0F);
        for (const DenseMaterial::Entry& e : material_->entries_[c]) {
            dispatch<add_scaled>(n, e.value, rows_.data() + e.column * n, products_.data() + e.row * n);
        }
        const std::span<float> matrix = out.subspan(c * n * stride, n * stride);
        for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t j = 0; j < n; ++j) matrix[j * stride + row] = products_[row * n + j];
        }
    }
}

}  // namespace nicol
