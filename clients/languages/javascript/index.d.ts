/** Three numbers: x, y, z or linear red, green, blue. */
export type Triple = readonly [number, number, number] | Float32Array | Float64Array;
/** Linear red, green and blue, or one number for gray. */
export type Color = Triple | number;
/** Numbers of many points, three by three. */
export type Triples = Float32Array | Float64Array | readonly number[];

/** A light, made by `directional`, `point` or `spot`. */
export interface Light {
  readonly kind: "directional" | "point" | "spot";
  readonly position?: Triple;
  readonly direction?: Triple;
  readonly intensity: Color;
  readonly attenuation?: Triple;
  readonly range?: number;
  readonly inner?: number;
  readonly outer?: number;
  readonly gltf?: boolean;
}

export interface Lamp {
  position: Triple;
  /** Default 1. */
  intensity?: Color;
  /** a, b, c of 1/(a + bq + cq²), where q is the distance. Default [1, 0, 0]. */
  attenuation?: Triple;
  /** The distance at which the light ends. Default Infinity. */
  range?: number;
  /** Whether it ends as the specification of glTF says, by 1 − (q/range)⁴ instead of its square. Default false. */
  gltf?: boolean;
}

/** A light so far away that its rays are parallel. `toward` is the direction to the light, of any length. */
export function directional(light: { toward: Triple; intensity?: Color }): Light;

/** A light that shines from a point in all directions. */
export function point(light: Lamp): Light;

/**
 * A point light that shines into a cone. `axis` is the direction in which it shines, of any length. The edge softens between the
 * half-angles `inner` (default 0) and `outer` (default π/4), in radians; equal ones are a hard edge.
 */
export function spot(light: Lamp & { axis: Triple; inner?: number; outer?: number }): Light;

export interface Material {
  /** The ambient reflectance. Default 0. */
  ka?: Color;
  /** The diffuse reflectance. Default 0. */
  kd?: Color;
  /** The reflectance of the highlight. Default 0. */
  ks?: Color;
  /** The shininess, 0 or more; whole numbers are faster. Default 1. */
  m?: number;
}

export interface Scene {
  points: Triples;
  /** As many as points, of any length. Where one has no direction, the result is black. */
  normals: Triples;
  eye: Triple;
  lights: readonly Light[];
  material?: Material;
  /** The ambient light. Default 1. */
  ambient?: Color;
  /** Default "blinn-phong". */
  model?: "lambert" | "phong" | "blinn-phong";
}

export interface Shading {
  /**
   * The linear light that each point sends to the eye: ka ambient, plus I (kd N·L + ks max(0, cosine)^m) for each light with
   * N·L > 0, where the cosine is R·V for "phong" and N·H for "blinn-phong". Throws a RangeError that names the bad argument.
   */
  shade(scene: Scene): Float32Array;
  /** The bytes of linear colors in sRGB, each rounded to the nearest. */
  toSrgb8(colors: Triples): Uint8Array;
  /** The module's memory. Each call frees what it takes. */
  readonly memory: WebAssembly.Memory;
}

/** Loads the module. Without a source, it is the file shading.wasm beside index.js. */
export function load(source?: URL | string | ArrayBuffer | Uint8Array | WebAssembly.Module): Promise<Shading>;
