// SPDX-License-Identifier: MIT
// Renders a scene and saves the Stokes vectors of its green channel for numpy.
// usage: node save_stokes.js SCENE.xml OUT.npy [name=value...]
import { writeFileSync } from "node:fs";
import nicol from "./nicol.js";

const [sceneFile, output, ...definitions] = process.argv.slice(2);

const context = nicol.context_create(null);
const scene = nicol.scene_load(context, sceneFile, definitions, definitions.length);
const camera = nicol.camera();
nicol.scene_get_camera(scene, camera);
const [width, height, channels] = [[0], [0], [0]];
nicol.scene_get_film_size(scene, width, height);
nicol.scene_get_channels(scene, channels);

const framebuffer = nicol.framebuffer_create(context, width[0], height[0], channels[0]);
nicol.render(scene, camera, nicol.render_options({ order_low: 4 }), framebuffer);
const stokes = nicol.plane(framebuffer, nicol.PLANE_STOKES, Math.min(1, channels[0] - 1));
const statistics = nicol.statistics();
nicol.framebuffer_get_statistics(framebuffer, statistics);
for (const object of [framebuffer, scene, context]) object.release();

const head = `{'descr': '<f4', 'fortran_order': False, 'shape': (${height[0]}, ${width[0]}, 4), }`.padEnd(117) + "\n";
writeFileSync(output, Buffer.concat([Buffer.from("\x93NUMPY\x01\0\x76\0" + head, "latin1"), Buffer.from(stokes.buffer)]));

const mean = [0, 1, 2].map((p) => stokes.reduce((sum, x, i) => (i % 4 === p ? sum + x : sum), 0) / (stokes.length / 4));
console.log(`${width[0]} x ${height[0]}, ${statistics.vertices} vertices, mean s0 ${mean[0].toFixed(4)}, ` +
  `s1 ${mean[1].toFixed(4)}, s2 ${mean[2].toFixed(4)}`);
