typedef struct {
    float x, y;
} shading_vec2;

/* A vector, or red, green and blue. */
typedef struct {
    float x, y, z;
} shading_vec3;

static inline shading_vec3 shading_vector(float x, float y, float z) {
    shading_vec3 v = {x, y, z};
    return v;
}
static inline shading_vec3 shading_add(shading_vec3 a, shading_vec3 b) {
    return shading_vector(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline shading_vec3 shading_sub(shading_vec3 a, shading_vec3 b) {
    return shading_vector(a.x - b.x, a.y - b.y, a.z - b.z);
}
static inline shading_vec3 shading_mul(shading_vec3 a, shading_vec3 b) {
    return shading_vector(a.x * b.x, a.y * b.y, a.z * b.z);
}
static inline shading_vec3 shading_neg(shading_vec3 a) {
    return shading_vector(-a.x, -a.y, -a.z);
}
static inline shading_vec3 shading_scale(shading_vec3 a, float s) {
    return shading_vector(a.x * s, a.y * s, a.z * s);
}
static inline shading_vec3 shading_over(shading_vec3 a, float s) {
    return shading_vector(a.x / s, a.y / s, a.z / s);
}
static inline float shading_dot(shading_vec3 a, shading_vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline shading_vec3 shading_cross(shading_vec3 a, shading_vec3 b) {
    return shading_vector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline float shading_max(float x, float least) {
    return x > least ? x : least;
}
static inline float shading_min(float x, float most) {
    return x > most ? most : x;
}
static inline float shading_clamp(float x, float least, float most) {
    return shading_min(shading_max(x, least), most);
}
static inline shading_vec3 shading_at_most(shading_vec3 a, float most) {
    return shading_vector(shading_min(a.x, most), shading_min(a.y, most), shading_min(a.z, most));
}

