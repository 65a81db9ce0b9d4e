-- SPDX-License-Identifier: MIT
-- The Lua module: errors, lifetimes and descriptors. usage: luajit lua_test.lua, with LUA_PATH set to the module's folder
local ffi = require("ffi")
local nicol = require("nicol")

local function fails(words, f, ...)
    local ok, message = pcall(f, ...)
    assert(not ok, "no error that says " .. words)
    assert(tostring(message):find(words, 1, true), message)
end

local function near(a, b, tolerance)
    assert(math.abs(a - b) <= tolerance, a .. " is not " .. b)
end

assert(nicol.version() == nicol.VERSION)
assert(ffi.string(nicol.version_string()):match("^%d+%.%d+%.%d+$"))
fails("nowhere", function() return nicol.nowhere end)

-- Descriptors.
local options = nicol.render_options{ order_low = 4 }
assert(options.struct_size == ffi.sizeof("nicol_render_options") and options.order_low == 4 and options.order_high == nicol.ORDER_AUTOMATIC)
fails("order_lwo", nicol.render_options, { order_lwo = 4 })
local sky = nicol.sky{ radiance = { 0.5, 0.25, 1 }, sun_direction = { 1, 2, 3 } }
assert(sky.radiance.count == 3 and sky.radiance.values[1] == 0.25 and sky.sun_direction[2] == 3)
assert(nicol.sky{ radiance = 0.5 }.radiance.count == 1)

-- Errors carry the library's words; objects survive what they were made from.
local context = nicol.context_create(nil)
fails("nowhere.exr", nicol.environment_load, context, "nowhere.exr", nil)
local scene = nicol.scene_create(context)
do
    local mesh = nicol.mesh_create_sphere(context)
    local material = nicol.material_create_diffuse(context, nicol.spectrum_of(0.25))
    nicol.scene_add_instance(scene, nicol.instance{ mesh = mesh, material = material }, nil)
    local light = nicol.environment_create_constant(context, nicol.spectrum_of(2))
    nicol.scene_set_environment(scene, light, nil, 1)
    assert(nicol.release(light) == nicol.OK)
    assert(nicol.C.nicol_environment_release(light) == nicol.ERROR_INVALID_HANDLE)
end
collectgarbage()

do
    local texture = nicol.texture_create_checkerboard(context, nil, nil, nil)
    local polarization = nicol.polarization{ dolp = 1, aolp = 0.5 }
    local lamp = nicol.light{ kind = nicol.LIGHT_SPOT, value = 2, polarization = polarization, texture = texture }
    local id = ffi.new("uint32_t[1]")
    nicol.scene_add_light(scene, lamp, id)
    nicol.scene_add_light(scene, nicol.light{}, id)
    assert(id[0] == 1)
    local told = nicol.light()
    assert(nicol.scene_get_light(scene, 0, told) ~= nil)
    assert(told.value.values[0] == 2 and told.polarization.dolp == 1 and told.polarization.axis[0] == 1)
    assert(nicol.scene_get_light(scene, 1, told) == nil and told.polarization.axis[0] == 1)
    fails("docp is 3", nicol.scene_add_light, scene, nicol.light{ polarization = nicol.polarization{ docp = 3 } }, nil)
    for i = 0, 1 do nicol.scene_remove_light(scene, i) end
end

local camera = nicol.camera{ fov = 40 }
local function vector(x, y, z) return ffi.new("double[3]", x, y, z) end
nicol.camera_look_at(camera, vector(0, 0, 4), vector(0, 0, 0), vector(0, 1, 0))
local framebuffer = nicol.framebuffer_create(context, 32, 24, 1)
nicol.render(scene, camera, nil, framebuffer)
local stokes, count = nicol.plane(framebuffer, nicol.PLANE_STOKES)
assert(count == 4 * 32 * 24)
near(stokes[4 * (12 * 32 + 16)], 0.5, 1e-4) -- a white furnace: radiance 2 times 0.25
fails("channel", nicol.plane, framebuffer, nicol.PLANE_S0, 1)

-- Callbacks on the calling thread.
local verbs = 0
local progress = ffi.cast("nicol_progress_callback", function() verbs = verbs + 1; return 0 end)
fails("asked to stop", nicol.render, scene, camera,
    nicol.render_options{ progress = progress, method = nicol.METHOD_REFERENCE }, framebuffer)
progress:free()
assert(verbs == 1)

-- In darkness no environment comes back.
nicol.scene_set_environment(scene, nil, nil, 1)
local environment = ffi.new("nicol_environment[1]")
nicol.scene_get_environment(scene, environment, nil, nil)
assert(environment[0] == nil)
fails("not a handle", nicol.release, options)
print("passed")
