/** Three numbers: x, y, z or linear red, green, blue. */
export type Triple = readonly [number, number, number] | Float32Array | Float64Array;
/** Linear red, green and blue, or one number for gray. */
export type Color = Triple | number;
/** Numbers of many points, three by three. */
export type Triples = Float32Array | Float64Array | readonly number[];
/**
 * A number, three numbers, or a texture: three numbers for each point, or one if it is gray. (Three numbers for three points are a
 * color.) They are linear, usually from 0 to 1. `fromSrgb8` decodes the bytes of an image.
 */
export type Texture = number | Triples;

/** A light, made by `directional`, `point` or `spot`. */
export interface Light {
  readonly kind: "directional" | "point" | "spot";
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

export interface Scene {
  points: Triples;
  /** As many as points, of any length. Where one is 0, the result is black. */
  normals: Triples;
  /** Three numbers, or three for each point. A point that is at the eye is black. */
  eye: Triples;
  lights: Light | readonly Light[];
  /** What the surface reflects of the ambient light. At least one of k_a, k_d and k_s must be given; the others are 0. */
  k_a?: Texture;
  /** What it reflects diffusely. */
  k_d?: Texture;
  /** What it reflects in the highlight. */
  k_s?: Texture;
  /** The shininess, 0 or more, or one for each point; whole numbers are faster. Default 1. */
  m?: number | Triples;
  /** The ambient light. Default 1. */
  ambient?: Texture;
  /** Default "blinn-phong". */
  model?: "lambert" | "phong" | "blinn-phong";
  /**
   * Which fraction of each light, from 0 to 1, reaches each point: for the first light those of all points, then for the second.
   * Without it, each light reaches each point.
   */
  visible?: Triples | Uint8Array | readonly boolean[];
  /** Whether to return the ambient, the diffuse and the specular part one by one. Default false. */
  parts?: boolean;
}

export interface Parts {
  ambient: Float32Array;
  diffuse: Float32Array;
  specular: Float32Array;
}

export interface Shading {
  /**
   * The linear light that each point sends to the eye: k_a ambient, plus I (k_d N·L + k_s max(0, cosine)^m) for each light with
   * N·L > 0, where the cosine is R·V for "phong" and N·H for "blinn-phong". Throws a TypeError or RangeError that names the bad
   * argument; a RangeError of a light or a point has its index in `light` or `index`.
   */
  shade(scene: Scene & { parts: true }): Parts;
  shade(scene: Scene & { parts?: false }): Float32Array;
  /** The bytes of linear colors in sRGB, each rounded to the nearest: three for each color. */
  toSrgb8(colors: Triples): Uint8ClampedArray;
  /** The same with an opaque alpha, four for each color, as the ImageData of a canvas takes them. */
  toSrgba8(colors: Triples): Uint8ClampedArray<ArrayBuffer>;
  /** The linear colors of sRGB bytes, for k_d: three bytes for each texel, or an ImageData, whose alpha is left out. */
  fromSrgb8(texture: Uint8Array | Uint8ClampedArray | { data: Uint8ClampedArray; width: number; height: number }): Float32Array;
  /**
   * The unit normals (−∂z/∂x, −∂z/∂y, 1) of a grid of heights, row by row. x grows by `dx` from a column to the next, and y by
   * `dy` from a row to the next; the defaults are 1. `dy` is negative if the first row is the top of an image and y points up.
   */
  heightField(field: { z: Triples; columns: number; dx?: number; dy?: number }): Float32Array;
  /**
   * The unit normals of an implicit surface, on which a field of values is constant, at points of it. They point to where the
   * values grow. The values stand row by row and layer by layer, the first at (0, 0, 0); x grows by `dx` from a column to the next,
   * y by `dy` from a row to the next, and z by `dz` from a layer to the next. The normals are approximate: the gradient at the nodes
   * is that of central differences, and is interpolated in between. If you know the gradient, pass it to `shade` as the normals.
   */
  implicit(surface: {
    values: Triples; rows: number; columns: number; points: Triples; dx?: number; dy?: number; dz?: number;
  }): Float32Array;
  /**
   * The unit normals of a mesh of triangles, counter-clockwise as seen from outside: one for each vertex. With a crease, the
   * greatest angle in radians between triangles that are one smooth surface, there is one for each corner of each triangle.
   */
  meshNormals(mesh: { vertices: Triples; faces: Uint32Array | Uint16Array | readonly number[]; crease?: number }): Float32Array;
  /** The module's memory. Each call frees what it takes. */
  readonly memory: WebAssembly.Memory;
}

/** Loads the module. Without a source, it is the file shading.wasm of the package. */
export function load(source?: URL | string | ArrayBuffer | Uint8Array | WebAssembly.Module): Promise<Shading>;
