// SPDX-License-Identifier: MIT
// Nicol for Node.js: functions of the C headers without their prefix. Failures are exceptions, handles are released by
// release() or the garbage collector, descriptors are made from objects.
import koffi from "koffi";
import { constants, functions, types } from "./nicol_abi.js";

const library = koffi.load(process.env.NICOL_LIBRARY ?? "libnicol.so.0.1");
const structs = {};
for (const type of types) {
  if (type.kind === "alias") koffi.alias(type.name, type.of);
  if (type.kind === "handle") koffi.pointer(type.name, koffi.opaque(`${type.name}_impl`));
  if (type.kind === "callback") koffi.proto(type.of);
  if (type.kind === "struct") {
    const fields = type.fields.map(([name, of, count]) => [name, count ? koffi.array(of, count, "Array") : of]);
    koffi.struct(type.name, Object.fromEntries(fields));
    structs[type.name] = type;
  }
}

export class NicolError extends Error {
  constructor(code, message) {
    super(message);
    this.name = "NicolError";
    this.code = code;
  }
}

const lastError = library.func(functions.last_error[0]);
function check(code) {
  if (code !== constants.OK) throw new NicolError(code, lastError());
}

const releases = {}; // functions by type of handle
for (const { kind, name } of types) {
  if (kind === "handle") releases[name] = library.func(functions[`${name.slice(6)}_release`][0]);
}
const initialisers = {}; // functions by type of descriptor
for (const name of Object.keys(structs)) initialisers[name] = library.func(functions[`${name.slice(6)}_init`][0]);
const forgotten = new FinalizationRegistry(({ type, pointer }) => releases[type](pointer));

/** An object of the library. */
export class Handle {
  constructor(type, pointer) {
    this.type = type;
    this.pointer = pointer;
    forgotten.register(this, { type, pointer }, this);
  }

  release() {
    if (this.pointer !== null) releases[this.type](this.pointer);
    forgotten.unregister(this);
    this.pointer = null;
  }

  [Symbol.dispose ?? Symbol("dispose")]() {
    this.release();
  }
}

const plain = (value) => (value instanceof Handle ? value.pointer : value);

/** Returns a spectrum from a number or numbers. */
export function spectrum(value) {
  const values = typeof value === "number" ? [value] : [...value];
  if (values.length > constants.MAX_CHANNELS) throw new RangeError(`${values.length} values in a spectrum`);
  return { count: values.length, values: [...values, ...Array(constants.MAX_CHANNELS - values.length).fill(0)] };
}

/** Returns a descriptor: all fields, with defaults for those not given, and its struct_size. */
function make(name, given) {
  const made = {};
  check(initialisers[name](made, koffi.sizeof(name)));
  const kinds = Object.fromEntries(structs[name].fields);
  for (const [field, value] of Object.entries(given)) {
    if (!(field in made)) throw new TypeError(`${name} has no field ${field}; it has ${Object.keys(made).join(", ")}`);
    const numbers = typeof value === "number" || Array.isArray(value);
    made[field] = kinds[field] === "nicol_spectrum" && numbers ? spectrum(value) : plain(value);
  }
  // The descriptor keeps the objects that it names alive.
  Object.defineProperty(made, "named", { value: Object.values(given).filter((v) => v instanceof Handle) });
  return made;
}

const api = { ...constants };
for (const name of Object.keys(structs)) {
  if (name !== "nicol_spectrum") api[name.slice(6)] = (given = {}) => make(name, given);
}
for (const [name, [prototype, answersResult, made]] of Object.entries(functions)) {
  const f = library.func(prototype);
  api[name] = (...given) => {
    if (!answersResult) return f(...given.map(plain));
    const out = made === null ? [] : [[null]];
    check(f(...given.map(plain), ...out));
    return made === null || out[0][0] === null ? null : new Handle(made, out[0][0]);
  };
}

/** { width, height, channels } */
api.framebufferSize = (framebuffer) => {
  const [width, height, channels] = [[0], [0], [0]];
  api.framebuffer_get_size(framebuffer, width, height, channels);
  return { width: width[0], height: height[0], channels: channels[0] };
};

/** One plane of one colour channel as a Float32Array, row by row from the top. */
api.plane = (framebuffer, plane, channel = 0) => {
  const { width, height } = api.framebufferSize(framebuffer);
  const pixels = new Float32Array(width * height * (plane === constants.PLANE_STOKES ? 4 : 1));
  api.framebuffer_read(framebuffer, plane, channel, pixels, 0, pixels.byteLength);
  return pixels;
};

export default api;
