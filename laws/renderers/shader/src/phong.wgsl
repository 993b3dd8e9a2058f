// The shader under test, as one writes it for a fragment; `main` shades each scene of a buffer.
struct Light {
    intensity: vec3f, kind: u32, // 0 directional, 1 point, 2 spot
    position: vec3f, cos_angle: f32, // of a directional light, the direction to it
    axis: vec3f,
    attenuation: vec3f,
}

struct Scene {
    p: vec3f, model: u32, // 0 Lambert, 1 Phong, 2 Blinn-Phong
    n: vec3f, count: u32,
    v: vec3f, m: f32,
    k_a: vec3f, k_d: vec3f, k_s: vec3f, i_a: vec3f,
    lights: array<Light, 8>,
}

@group(0) @binding(0) var<storage, read> scenes: array<Scene>;
@group(0) @binding(1) var<storage, read_write> colors: array<vec3f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&scenes) { return; }
    let scene = &scenes[id.x];
    let n = normalize(scene.n);
    let v = normalize(scene.v);
    var color = scene.k_a * scene.i_a;
    for (var i = 0u; i < scene.count; i++) {
        let light = scene.lights[i];
        var l = light.position;
        var intensity = light.intensity;
        if light.kind > 0 {
            let to_light = light.position - scene.p;
            let q = length(to_light);
            l = to_light / q;
            intensity /= light.attenuation.x + (light.attenuation.y + light.attenuation.z * q) * q;
            if light.kind == 2 && dot(-l, light.axis) < light.cos_angle { continue; }
        }
        let n_dot_l = dot(n, l);
        if n_dot_l <= 0 { continue; }
        color += scene.k_d * intensity * n_dot_l;
        let r_dot_v = dot(reflect(-l, n), v);
        let n_dot_h = dot(n, normalize(l + v));
        let cosine = select(n_dot_h, r_dot_v, scene.model == 1);
        if scene.model > 0 { color += scene.k_s * intensity * pow(max(cosine, 0), scene.m); }
    }
    colors[id.x] = color;
}
