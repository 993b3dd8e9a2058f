// Shades scenes as the laws ask for them.
struct Scene {
    p: vec3f,
    model: f32, // 0: Lambert, 1: Phong, 2: Blinn-Phong
    n: vec3f,
    count: f32,
    v: vec3f,
    material: shading_Material,
    i_a: vec3f,
    lights: array<shading_Light, 8>,
}

@group(0) @binding(0) var<storage, read> scenes: array<Scene>;
@group(0) @binding(1) var<storage, read_write> colors: array<vec4f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&scenes) {
        return;
    }
    let p = scenes[id.x].p;
    let n = shading_unit(scenes[id.x].n);
    let v = shading_unit(scenes[id.x].v);
    let material = scenes[id.x].material;
    var sums = shading_Sums();
    for (var i = 0u; i < u32(scenes[id.x].count); i++) {
        let light = scenes[id.x].lights[i];
        if scenes[id.x].model == 0.0 {
            sums = shading_add_lambert(sums, n, light, p);
        } else if scenes[id.x].model == 1.0 {
            sums = shading_add_phong(sums, n, v, material.m, light, p);
        } else {
            sums = shading_add_blinn_phong(sums, n, v, material.m, light, p);
        }
    }
    colors[id.x] = vec4f(shading_total(sums, material, scenes[id.x].i_a), 1.0);
}
