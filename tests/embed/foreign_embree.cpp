// SPDX-License-Identifier: MIT
// Definitions of a different Embree, which the host's program exports. Nicol must call none of them.
#include <cstdio>
#include <cstdlib>

#define FOREIGN(name)                                              \
    extern "C" void name() {                                       \
        std::fputs("Nicol called the host's " #name "\n", stderr); \
        std::abort();                                              \
    }
FOREIGN(rtcNewDevice)
FOREIGN(rtcReleaseDevice)
FOREIGN(rtcGetDeviceError)
FOREIGN(rtcNewScene)
FOREIGN(rtcReleaseScene)
FOREIGN(rtcSetSceneFlags)
FOREIGN(rtcCommitScene)
FOREIGN(rtcNewGeometry)
FOREIGN(rtcReleaseGeometry)
FOREIGN(rtcCommitGeometry)
FOREIGN(rtcAttachGeometryByID)
FOREIGN(rtcSetNewGeometryBuffer)
FOREIGN(rtcSetGeometryUserData)
FOREIGN(rtcSetGeometryIntersectFilterFunction)
FOREIGN(rtcSetGeometryOccludedFilterFunction)
FOREIGN(rtcIntersect1)
FOREIGN(rtcOccluded1)
FOREIGN(rtcOccluded16)
