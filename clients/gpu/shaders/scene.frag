in vec3 p;
out vec4 color;

void main() {
    vec3 n = shading_normal_sphere(vec3(0.0), p);
    vec3 v = shading_unit(vec3(0.0, 0.0, 6.0) - p);
    shading_Light lamp = shading_Light(vec3(2.0, 1.0, 2.0), 0.0, vec3(1.0, 0.8, 0.6), 3.4e38, vec3(1.0, 0.0, 0.25), 6.0,
                                       vec3(0.0), 0.0, vec2(-1.0), 0.0);
    shading_Material clay = shading_Material(vec3(0.1), 32.0, vec3(0.6), vec3(0.3));
    color = vec4(shading_shade_blinn_phong(n, v, clay, shading_arrival(lamp, p)), 1.0);
}
