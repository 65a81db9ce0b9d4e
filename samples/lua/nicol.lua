-- SPDX-License-Identifier: MIT
-- Nicol for LuaJIT: functions of the C headers without their prefix. Failures are errors, handles are released by the garbage
-- collector or by nicol.release, descriptors are made from tables.
local ffi = require("ffi")
local abi = require("nicol_ffi")

local C = ffi.load(os.getenv("NICOL_LIBRARY") or "nicol")
local nicol = { C = C }

local function check(result)
    if result ~= 0 then error(ffi.string(C.nicol_last_error()), 3) end
end

-- Calls f with the arguments and `last` after them, for any number of arguments and nils.
local function call_with(f, last, ...)
    local n, arguments = select("#", ...), { ... }
    arguments[n + 1] = last
    return f(unpack(arguments, 1, n + 1))
end

-- Returns a function that returns the made object instead of taking a pointer to it.
local function creator(f, handle)
    local release, out = C[handle .. "_release"], ffi.typeof(handle .. "[1]")
    return function(...)
        local made = out()
        check(call_with(f, made, ...))
        if made[0] == nil then return nil end
        return ffi.gc(made[0], release)
    end
end

-- Returns a function like nicol.render_options{order_low = 4}, which sets struct_size and defaults and accepts a number
-- or a list for a spectrum.
local function maker(name)
    local type, init = ffi.typeof("nicol_" .. name), C["nicol_" .. name .. "_init"]
    return function(fields)
        local struct = type()
        check(init(struct, ffi.sizeof(type)))
        for field, value in pairs(fields or {}) do
            if ffi.istype("nicol_spectrum", struct[field]) and not ffi.istype("nicol_spectrum", value) then
                value = nicol.spectrum_of(value)
            end
            struct[field] = value
        end
        return struct
    end
end

function nicol.spectrum_of(values)
    if type(values) == "number" then values = { values } end
    return ffi.new("nicol_spectrum", #values, values)
end

-- Returns the array of a list of strings and its length, for nicol.scene_load.
function nicol.strings(list)
    return ffi.new("const char*[?]", #list, list), #list
end

-- Releases a handle now instead of at the next garbage collection.
function nicol.release(handle)
    for name, made in pairs(abi.results) do
        if made ~= true and ffi.istype(made, handle) then
            return C[made .. "_release"](ffi.gc(handle, nil))
        end
    end
    error("not a handle of Nicol", 2)
end

function nicol.framebuffer_size(framebuffer)
    local size = ffi.new("uint32_t[3]")
    check(C.nicol_framebuffer_get_size(framebuffer, size, size + 1, size + 2))
    return size[0], size[1], size[2]
end

-- Returns one plane of one colour channel as floats, row by row from the top, and their number.
function nicol.plane(framebuffer, plane, channel)
    local width, height = nicol.framebuffer_size(framebuffer)
    local count = width * height * (plane == nicol.PLANE_STOKES and 4 or 1)
    local pixels = ffi.new("float[?]", count)
    check(C.nicol_framebuffer_read(framebuffer, plane, channel or 0, pixels, 0, 4 * count))
    return pixels, count
end

return setmetatable(nicol, {
    __index = function(_, name)
        local found = abi.constants[name]
        if found == nil and abi.structs[name] ~= nil then found = maker(name) end
        if found == nil then
            local result = abi.results[name]
            local f = C["nicol_" .. name]
            if type(result) == "string" then
                found = creator(f, result)
            elseif result then
                found = function(...) check(f(...)) end
            else
                found = f
            end
        end
        rawset(nicol, name, found)
        return found
    end,
})
