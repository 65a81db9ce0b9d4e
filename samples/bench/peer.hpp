// SPDX-License-Identifier: MIT
// Interface to harmonic transforms by another library.
#pragma once

#include <functional>
#include <memory>

/// Transforms on order + 1 Gauss-Legendre rows of 2 order + 2 columns.
struct PeerTransform {
    virtual ~PeerTransform() = default;
    virtual void synthesize_spin2() = 0;
    virtual void analyze_spin2() = 0;
    virtual void synthesize_scalar() = 0;
    virtual void analyze_scalar() = 0;
};

#ifdef NICOL_BENCH_LIBSHARP
std::unique_ptr<PeerTransform> libsharp_transform(int order);
#else
inline std::unique_ptr<PeerTransform> libsharp_transform(int) {
    return nullptr;
}
#endif
