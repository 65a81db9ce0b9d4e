-- SPDX-License-Identifier: MIT
-- For wrk: images of ever other cameras. SERVE_TARGET is the beginning of their targets, SERVE_PAUSE the milliseconds that a
-- connection rests between two of them.
local target, rest = os.getenv("SERVE_TARGET"), tonumber(os.getenv("SERVE_PAUSE") or "0")
local number = 0
-- Globals, which done() can get from the threads.
refused, wrong, untold = 0, 0, 0

function setup(thread)
  threads = threads or {}
  table.insert(threads, thread)
  thread:set("first", math.random() * 360)
end

function request()
  number = number + 1
  -- The golden angle comes to no place twice.
  return wrk.format("GET", string.format("%s&azimuth=%.4f", target, (first + number * 137.50776) % 360))
end

function delay()
  return rest
end

function response(status, headers)
  if status == 503 then
    refused = refused + 1
    if not headers["Retry-After"] then untold = untold + 1 end
  elseif status ~= 200 then
    wrong = wrong + 1
  end
end

function done(summary, latency)
  local sum = { refused = 0, wrong = 0, untold = 0 }
  for _, thread in ipairs(threads) do
    for name in pairs(sum) do sum[name] = sum[name] + (thread:get(name) or 0) end
  end
  local errors = summary.errors
  io.write(string.format('JSON {"seconds": %f, "requests": %d, "refused": %d, "wrong": %d, "untold": %d, "broken": %d, "p50": %f, "p99": %f}\n',
    summary.duration / 1e6, summary.requests, sum.refused, sum.wrong, sum.untold,
    errors.connect + errors.read + errors.write + errors.timeout, latency:percentile(50) / 1000, latency:percentile(99) / 1000))
end
