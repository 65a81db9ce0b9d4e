// SPDX-License-Identifier: MIT
// The Node.js module: layouts, errors, lifetimes and descriptors. usage: node node_test.js, beside nicol.js, with the
// header's layout in LAYOUT as `struct NAME SIZE` and `field NAME.FIELD OFFSET ...` lines
import assert from "node:assert/strict";
import koffi from "koffi";
import nicol, { Handle, NicolError, spectrum } from "./nicol.js";

let fields = 0;
for (const line of process.env.LAYOUT.split("\n")) {
  const [kind, name, value] = line.split(" ");
  if (kind === "struct") assert.equal(koffi.sizeof(name), Number(value), name);
  if (kind === "field") assert.equal(koffi.offsetof(...name.split(".")), Number(value), name);
  fields += kind === "field";
}
assert(fields > 100);
assert.equal(nicol.version(), nicol.VERSION);
assert.match(nicol.version_string(), /^\d+\.\d+\.\d+$/);

const options = nicol.render_options({ order_low: 6 });
assert.equal(options.struct_size, koffi.sizeof("nicol_render_options"));
assert.deepEqual([options.order_low, options.order_high], [6, nicol.ORDER_AUTOMATIC]);
assert.throws(() => nicol.render_options({ order_lwo: 4 }), /no field order_lwo; it has .*order_low/);
assert.deepEqual(nicol.sky({ radiance: [0.5, 0.25, 1] }).radiance.values.slice(0, 4), [0.5, 0.25, 1, 0]);
assert.equal(nicol.sky({ radiance: 0.5 }).radiance.count, 1);

const context = nicol.context_create(nicol.context_options({ threads: 1 }));
assert.throws(() => nicol.environment_load(context, "nowhere.exr", null), (error) =>
  error instanceof NicolError && error.code === nicol.ERROR_FILE_NOT_FOUND && error.message.includes("nowhere.exr"));
const info = nicol.context_info();
nicol.context_get_info(context, info);
assert(info.renderer.length > 0 && info.threads === 1);

const scene = nicol.scene_create(context);
const mesh = nicol.mesh_create_sphere(context);
const material = nicol.material_create_diffuse(context, spectrum(0.25));
nicol.scene_add_instance(scene, nicol.instance({ mesh, material }), null);
const light = nicol.environment_create_constant(context, spectrum(2));
nicol.scene_set_environment(scene, light, null, 1);
for (const object of [light, mesh, material]) object.release();
light.release();
assert.throws(() => nicol.environment_get_info(light, nicol.environment_info()), NicolError);
const [again, turn, scale] = [[null], Array(16).fill(0), [0]];
nicol.scene_get_environment(scene, again, turn, scale);
assert.deepEqual([turn[0], turn[1], turn[5], scale[0]], [1, 0, 1, 1]);
new Handle("nicol_environment", again[0]).release();

const texture = nicol.texture_create_checkerboard(context, null, null, null);
const polarization = nicol.polarization({ dolp: 1, aolp: 0.5 });
const ids = [0];
nicol.scene_add_light(scene, nicol.light({ kind: nicol.LIGHT_SPOT, value: 2, polarization, texture }), null);
nicol.scene_add_light(scene, nicol.light(), ids);
assert.equal(ids[0], 1);
texture.release();
const told = nicol.light();
nicol.scene_get_light(scene, 0, told)?.release();
assert.deepEqual([told.kind, told.value.values[0], told.polarization.dolp, told.polarization.axis[0]], [2, 2, 1, 1]);
const wrong = nicol.light({ polarization: nicol.polarization({ docp: 3 }) });
assert.throws(() => nicol.scene_add_light(scene, wrong, null), /docp is 3/);
for (const id of [0, 1]) nicol.scene_remove_light(scene, id);

const camera = nicol.camera({ fov: 40 });
nicol.camera_look_at(camera, [0, 0, 4], [0, 0, 0], [0, 1, 0]);
const framebuffer = nicol.framebuffer_create(context, 32, 24, 1);
context.release();
nicol.render(scene, camera, options, framebuffer);
const stokes = nicol.plane(framebuffer, nicol.PLANE_STOKES);
assert.equal(stokes.length, 4 * 32 * 24);
assert(Math.abs(stokes[4 * (12 * 32 + 16)] - 0.5) < 1e-4); // a white furnace: radiance 2 times 0.25
assert.equal(stokes[0], 2);
assert.throws(() => nicol.plane(framebuffer, nicol.PLANE_S0, 1), /channel/);

// Callbacks on the calling thread.
const progress = koffi.register(() => 0, "nicol_progress_callback *");
const stopped = nicol.render_options({ progress, method: nicol.METHOD_REFERENCE });
assert.throws(() => nicol.render(scene, camera, stopped, framebuffer), (error) => error.code === nicol.ERROR_CANCELLED);
koffi.unregister(progress);

// Results in typed arrays.
const transform = nicol.psh_transform_create(nicol.psh_sampling({ order: 3 }));
const [rows, columns] = [[0], [0]];
nicol.psh_transform_get_size(transform, rows, columns);
const [theta, weight] = [new Float64Array(rows[0]), new Float64Array(rows[0])];
nicol.psh_transform_get_rows(transform, theta, weight, rows[0]);
assert(Math.abs(weight.reduce((sum, x) => sum + x) - 2) < 1e-12);
console.log("passed");
