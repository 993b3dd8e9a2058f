struct Point {
    p: vec3f,
    is_seen: f32,
    n: vec3f,
}

@group(0) @binding(0) var<storage, read> lights: array<shading_Light>;
@group(0) @binding(1) var<storage, read> material: shading_Material;
@group(0) @binding(2) var<storage, read> points: array<Point>;
@group(0) @binding(3) var<storage, read_write> colors: array<vec4f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let point = points[id.x];
    if point.is_seen == 0.0 {
        return;
    }
    var n = shading_normal_sphere(vec3f(0.0), point.p);
    if any(point.n != vec3f(0.0)) {
        n = shading_unit(point.n);
    }
    let v = shading_unit(vec3f(0.0, 0.0, 6.0) - point.p);
    var sums = shading_Sums();
    for (var i = 0u; i < arrayLength(&lights); i++) {
        sums = shading_add_blinn_phong(sums, n, v, material.m, lights[i], point.p);
    }
    colors[id.x] = vec4f(shading_total(sums, material, vec3f(0.2)), 1.0);
}
