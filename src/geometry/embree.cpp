// SPDX-License-Identifier: MIT
#include "geometry/embree.hpp"

#include <exception>
#include <string>
#include <string_view>
#include <type_traits>

#include "error.hpp"
#include "files/shared_library.hpp"

namespace nicol::embree {
namespace {

constexpr const char* kVersion4 = "libembree4.so.4";
constexpr const char* kVersion3 = "libembree3.so.3";

/// Options of a query in version 3 (RTCIntersectContext), as rtcInitIntersectContext() sets them.
struct Context3 {
    unsigned flags = 0;
    Filter filter = nullptr;
    unsigned instance = kNoGeometry;
};
constexpr unsigned kCoherent3 = 1;

/// Options of a query in version 4 (RTCIntersectArguments and RTCOccludedArguments), as rtcInit...Arguments()
/// sets them.
struct Arguments4 {
    unsigned flags = 0;
    unsigned features = ~0U;
    void* context = nullptr;
    Filter filter = nullptr;
    void* function = nullptr;  // callback for user-defined geometry
    float min_width = 0;       // read only by builds with RTC_MIN_WIDTH
};
constexpr unsigned kCoherent4 = 1U << 16;

SharedLibrary opened() {
    try {
        return SharedLibrary({kVersion4, kVersion3}, ErrorCode::unsupported);
    } catch (const Error& error) {
        throw Error(error.code(),
                    std::string("shadows and the reference method need Embree; install libembree4-4 or "
                                "libembree3-3 (") +
                        error.what() + ")");
    }
}

}  // namespace

Library::Library() {
    const SharedLibrary file = opened();
    version_ = file.name() == kVersion4 ? 4 : 3;
    const auto find = [&file](auto& function, const char* name) {
        function = file.function<std::remove_reference_t<decltype(function)>>(name);
    };
    find(NewDevice, "rtcNewDevice");
    find(RetainDevice, "rtcRetainDevice");
    find(ReleaseDevice, "rtcReleaseDevice");
    find(GetDeviceError, "rtcGetDeviceError");
    find(NewScene, "rtcNewScene");
    find(ReleaseScene, "rtcReleaseScene");
    find(SetSceneFlags, "rtcSetSceneFlags");
    find(CommitScene, "rtcCommitScene");
    find(NewGeometry, "rtcNewGeometry");
    find(ReleaseGeometry, "rtcReleaseGeometry");
    find(CommitGeometry, "rtcCommitGeometry");
    find(AttachGeometryByID, "rtcAttachGeometryByID");
    find(DetachGeometry, "rtcDetachGeometry");
    find(SetNewGeometryBuffer, "rtcSetNewGeometryBuffer");
    find(SetGeometryInstancedScene, "rtcSetGeometryInstancedScene");
    find(SetGeometryUserData, "rtcSetGeometryUserData");
    find(SetGeometryIntersectFilterFunction, "rtcSetGeometryIntersectFilterFunction");
    find(SetGeometryOccludedFilterFunction, "rtcSetGeometryOccludedFilterFunction");
    find(intersect1_, "rtcIntersect1");
    find(intersect16_, "rtcIntersect16");
    find(occluded1_, "rtcOccluded1");
    find(occluded16_, "rtcOccluded16");
}

void Library::intersect(Scene* scene, RayHit& query) const {
    if (version_ == 4) {
        Arguments4 arguments;
        reinterpret_cast<void (*)(Scene*, RayHit*, Arguments4*)>(intersect1_)(scene, &query, &arguments);
    } else {
        Context3 context;
        reinterpret_cast<void (*)(Scene*, Context3*, RayHit*)>(intersect1_)(scene, &context, &query);
    }
}

void Library::intersect(Scene* scene, const std::array<int, Ray16::kRays>& valid, RayHit16& query,
                        bool coherent) const {
    // Version 3 requires a mask that is aligned to 64 bytes.
    alignas(64) const std::array<int, Ray16::kRays> mask = valid;
    if (version_ == 4) {
        Arguments4 arguments{.flags = coherent ? kCoherent4 : 0};
        reinterpret_cast<void (*)(const int*, Scene*, RayHit16*, Arguments4*)>(intersect16_)(
            mask.data(), scene, &query, &arguments);
    } else {
        Context3 context{.flags = coherent ? kCoherent3 : 0};
        reinterpret_cast<void (*)(const int*, Scene*, Context3*, RayHit16*)>(intersect16_)(mask.data(), scene,
                                                                                           &context, &query);
    }
}

void Library::occluded(Scene* scene, Ray& ray) const {
    if (version_ == 4) {
        Arguments4 arguments;
        reinterpret_cast<void (*)(Scene*, Ray*, Arguments4*)>(occluded1_)(scene, &ray, &arguments);
    } else {
        Context3 context;
        reinterpret_cast<void (*)(Scene*, Context3*, Ray*)>(occluded1_)(scene, &context, &ray);
    }
}

void Library::occluded(Scene* scene, const std::array<int, Ray16::kRays>& valid, Ray16& rays,
                       bool coherent) const {
    // Version 3 requires a mask that is aligned to 64 bytes.
    alignas(64) const std::array<int, Ray16::kRays> mask = valid;
    if (version_ == 4) {
        Arguments4 arguments{.flags = coherent ? kCoherent4 : 0};
        reinterpret_cast<void (*)(const int*, Scene*, Ray16*, Arguments4*)>(occluded16_)(mask.data(), scene,
                                                                                         &rays, &arguments);
    } else {
        Context3 context{.flags = coherent ? kCoherent3 : 0};
        reinterpret_cast<void (*)(const int*, Scene*, Context3*, Ray16*)>(occluded16_)(mask.data(), scene,
                                                                                       &context, &rays);
    }
}

const Library& library() {
    static const Library opened_once;
    return opened_once;
}

void open_if_there() noexcept {
    try {
        static_cast<void>(library());
    } catch (const std::exception&) {  // the caller that needs Embree meets the same error
    }
}

}  // namespace nicol::embree
