-- SPDX-License-Identifier: MIT
-- Renders a scene and saves the Stokes vectors of its green channel for numpy.
-- usage: luajit save_stokes.lua SCENE.xml OUT.npy [name=value...]
package.path = (arg[0]:match("^(.*/)") or "./") .. "?.lua;" .. package.path
local ffi = require("ffi")
local nicol = require("nicol")

local scene_file, output = arg[1], arg[2]

local context = nicol.context_create(nil)
local scene = nicol.scene_load(context, scene_file, nicol.strings({ unpack(arg, 3) }))
local camera = nicol.camera()
nicol.scene_get_camera(scene, camera)
local size = ffi.new("uint32_t[3]")
nicol.scene_get_film_size(scene, size, size + 1)
nicol.scene_get_channels(scene, size + 2)
local width, height, channels = size[0], size[1], size[2]

local framebuffer = nicol.framebuffer_create(context, width, height, channels)
nicol.render(scene, camera, nicol.render_options{ order_low = 4 }, framebuffer)
local stokes, count = nicol.plane(framebuffer, nicol.PLANE_STOKES, channels > 1 and 1 or 0)
local statistics = nicol.statistics()
nicol.framebuffer_get_statistics(framebuffer, statistics)

local head = ("{'descr': '<f4', 'fortran_order': False, 'shape': (%d, %d, 4), }"):format(height, width)
local file = assert(io.open(output, "wb"))
file:write("\147NUMPY\1\0\118\0", head, (" "):rep(117 - #head), "\n", ffi.string(stokes, 4 * count))
file:close()

local mean = { 0, 0, 0 }
for i = 0, count - 1, 4 do
    for component = 0, 2 do
        mean[component + 1] = mean[component + 1] + stokes[i + component] * 4 / count
    end
end
print(("%d x %d, %d vertices, mean s0 %.4f, s1 %+.4f, s2 %+.4f"):format(
    width, height, tonumber(statistics.vertices), unpack(mean)))
