// SPDX-License-Identifier: MIT
#include "shading/lane_frames.hpp"

#include "simd/dispatch.hpp"

namespace nicol {
namespace {

template <class Number>
[[gnu::always_inline]] inline void into_all(const LaneFrames& frames, const LaneVectors& vectors,
                                            LaneVectors& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> v;
        load_part(vectors, first, v);
        store_part(along(frames, first, v), first, out);
    }
}

template <class Number>
[[gnu::always_inline]] inline void out_of_all(const LaneFrames& frames, const LaneVectors& components,
                                              LaneVectors& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> x, y, z, c;
        load_part(frames.x, first, x);
        load_part(frames.y, first, y);
        load_part(frames.z, first, z);
        load_part(components, first, c);
        store_part(Vector3<Number>{c.x * x.x + c.y * y.x + c.z * z.x, c.x * x.y + c.y * y.y + c.z * z.y,
                                   c.x * x.z + c.y * y.z + c.z * z.z},
                   first, out);
    }
}

}  // namespace

void into_frames(const LaneFrames& frames, const LaneVectors& vectors, LaneVectors& out) {
    dispatch<into_all<FourLanes>, into_all<EightLanes>, into_all<AllLanes>>(frames, vectors, out);
}

void out_of_frames(const LaneFrames& frames, const LaneVectors& components, LaneVectors& out) {
    dispatch<out_of_all<FourLanes>, out_of_all<EightLanes>, out_of_all<AllLanes>>(frames, components, out);
}

}  // namespace nicol
