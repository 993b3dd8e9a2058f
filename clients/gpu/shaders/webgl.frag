uniform sampler2D points; // for each point two texels: p and whether it is seen, and a normal
uniform shading_Light lights[3];
uniform shading_Material material;
out vec4 color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 point = texelFetch(points, ivec2(2 * at.x, at.y), 0);
    vec3 normal = texelFetch(points, ivec2(2 * at.x + 1, at.y), 0).xyz;
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (point.w == 0.0) {
        return;
    }
    vec3 p = point.xyz;
    vec3 n = normal == vec3(0.0) ? shading_normal_sphere(vec3(0.0), p) : shading_unit(normal);
    vec3 v = shading_unit(vec3(0.0, 0.0, 6.0) - p);
    shading_Sums sums = shading_Sums(vec3(0.0), vec3(0.0));
    for (int i = 0; i < 3; i++) {
        sums = shading_add_blinn_phong(sums, n, v, material.m, lights[i], p);
    }
    color.rgb = shading_total(sums, material, vec3(0.2));
}
