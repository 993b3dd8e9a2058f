// The same from JavaScript, by WebAssembly, on typed arrays: node main.mjs MODULE FOLDER.
import { readFileSync } from "node:fs";
import { argv, exit } from "node:process";

const BLINN_PHONG = 2;
const [DIRECTIONAL, POINT, SPOT] = [0, 1, 2];
const NONE = [0, 0, 0];
const LIGHTS = [
    { kind: DIRECTIONAL, direction: [-1, 2, 2], intensity: [0.25, 0.25, 0.375] },
    { kind: POINT, position: [2, 1, 2], intensity: [1, 0.75, 0.5], attenuation: [1, 0, 0.25] },
    { kind: POINT, position: [-4, -2, 4], intensity: [2, 4, 8], attenuation: [0, 0, 1], range: 8, unsquared: 1 },
    { kind: SPOT, position: [0, 3, 3], direction: [0, -1, -1], intensity: [3, 1, 1], attenuation: [1, 0.5, 0], range: 8, inner: 0.25, outer: 0.375 },
];
const CLAY = { k_a: [0.125, 0.125, 0.125], k_d: [0.5, 0.375, 0.25], k_s: [0.5, 0.5, 0.5], m: 32 };
const EYE = [0, 0, 5];
const AMBIENT = [0.5, 0.5, 0.5];

/** The functions of shading.h, on typed arrays. */
class Shading {
    static async load(path) {
        const { instance } = await WebAssembly.instantiate(readFileSync(path));
        return Object.assign(new Shading(), { module: instance.exports });
    }

    /** The light that each point sends to the eye. */
    shade(model, points, normals, eye, material, ambient, lights) {
        if (normals.length !== points.length || points.length % 3) throw new RangeError("points and normals differ");
        const surface = [...material.k_a, ...material.k_d, ...material.k_s, material.m];
        const inputs = [points, normals, eye, surface, ambient, this.#packed(lights)];
        return this.#with(inputs, points.length, (rooms, out) =>
            this.module.shading_shade(model, points.length / 3, ...rooms, lights.length, out));
    }

    #packed(lights) {
        const words = new ArrayBuffer(68 * lights.length);
        lights.forEach((light, i) => {
            const { position = NONE, direction = NONE, attenuation = [1, 0, 0], range = Infinity, inner = 0, outer = 0 } = light;
            new Uint32Array(words, 68 * i, 1)[0] = light.kind;
            new Float32Array(words, 68 * i + 4, 15)
                .set([...position, ...direction, ...light.intensity, ...attenuation, range, inner, outer]);
            new Uint32Array(words, 68 * i + 64, 1)[0] = light.unsquared ?? 0;
        });
        return new Float32Array(words);
    }

    /** Copies numbers into the module, calls it, and copies the result out. */
    #with(inputs, length, call) {
        const rooms = [];
        const room = (bytes) => {
            const address = this.module.shading_alloc(bytes);
            if (!address && bytes) throw new RangeError("no memory");
            rooms.push([address, bytes]);
            return address;
        };
        try {
            const addresses = inputs.map((input) => room(4 * input.length));
            const out = room(4 * length);
            // memory grows by a new buffer, so the views come last
            inputs.forEach((input, i) => {
                const bits = input instanceof Float32Array ? input : Float32Array.from(input);
                new Uint8Array(this.module.memory.buffer, addresses[i], 4 * input.length)
                    .set(new Uint8Array(bits.buffer, bits.byteOffset, bits.byteLength));
            });
            const status = call(addresses, out);
            if (status) throw new RangeError(`shading: status ${status}`);
            return new Float32Array(this.module.memory.buffer, out, length).slice();
        } finally {
            rooms.forEach(([address, bytes]) => this.module.shading_free(address, bytes));
        }
    }
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const scaled = (v, s) => [v[0] * s, v[1] * s, v[2] * s];
const unit = (v) => scaled(v, 1 / Math.sqrt(dot(v, v)));
const difference = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const clamped = (t) => Math.min(1, Math.max(0, t));

/** What one writes in JavaScript alone, in doubles. */
function byHand(points, normals, eye, material, ambient, lights) {
    const colors = new Float32Array(points.length);
    for (let i = 0; i < points.length; i += 3) {
        const p = [points[i], points[i + 1], points[i + 2]];
        const n = unit([normals[i], normals[i + 1], normals[i + 2]]);
        const v = unit(difference(eye, p));
        const color = [0, 1, 2].map((c) => material.k_a[c] * ambient[c]);
        for (const light of lights) {
            let l, factor = 1;
            if (light.kind === DIRECTIONAL) {
                l = unit(light.direction);
            } else {
                const way = difference(light.position, p);
                const q = Math.sqrt(dot(way, way));
                l = scaled(way, 1 / q);
                const [a, b, c] = light.attenuation;
                factor = 1 / (a + b * q + c * q * q);
                if (light.range) factor *= clamped(1 - (q / light.range) ** 4) ** (light.unsquared ? 1 : 2);
            }
            if (light.kind === SPOT) {
                const [inner, outer] = [Math.cos(light.inner), Math.cos(light.outer)];
                factor *= clamped((-dot(l, unit(light.direction)) - outer) / (inner - outer)) ** 2;
            }
            const nDotL = dot(n, l);
            if (nDotL <= 0) continue;
            const highlight = Math.max(0, dot(n, unit([l[0] + v[0], l[1] + v[1], l[2] + v[2]]))) ** material.m;
            for (let c = 0; c < 3; c++)
                color[c] += light.intensity[c] * factor * (material.k_d[c] * nDotL + material.k_s[c] * highlight);
        }
        colors.set(color, i);
    }
    return colors;
}

function least(work) {
    const times = Array.from({ length: 20 }, () => {
        const start = performance.now();
        work();
        return performance.now() - start;
    });
    return Math.min(...times);
}

function demand(holds, what) {
    if (holds) return;
    console.error(`JavaScript: ${what}`);
    exit(1);
}

demand(argv.length === 4, "usage: node main.mjs MODULE FOLDER");
const floats = (name) => {
    const bytes = readFileSync(`${argv[3]}/${name}`);
    return new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
};
const shading = await Shading.load(argv[2]);
const scene = [floats("points"), floats("normals"), EYE, CLAY, AMBIENT, LIGHTS];
const colors = shading.shade(BLINN_PHONG, ...scene);
demand(Buffer.from(colors.buffer).equals(Buffer.from(floats("colors").buffer)), "other bits than the crate's");
const refused = (...wrong) => {
    try {
        shading.shade(...wrong);
    } catch (error) {
        return error instanceof RangeError;
    }
    return false;
};
demand(refused(7, ...scene), "no error for a model that does not exist");
demand(refused(BLINN_PHONG, ...scene.slice(0, 5), [{ kind: SPOT, intensity: NONE }]), "no error for a bad light");
demand(refused(BLINN_PHONG, scene[0].slice(3), ...scene.slice(1)), "no error for too few points");
const theirs = byHand(...scene);
demand(colors.every((channel, i) => Math.abs(channel - theirs[i]) <= 1e-4 * (1 + channel)), "by hand it is something else");
const [ours, by] = [least(() => shading.shade(BLINN_PHONG, ...scene)), least(() => byHand(...scene))];
console.log(`JavaScript: ${ours.toFixed(1)} ms, ${(ours / by).toFixed(2)} of the time by hand; all bits are the crate's`);
