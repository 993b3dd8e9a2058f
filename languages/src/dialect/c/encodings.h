/* The least light of each level but 0, in sRGB. IEC 61966-2-1. */
static const float shading_edges_of_5_bits[31] = {
{5_bits}};
static const float shading_edges_of_6_bits[63] = {
{6_bits}};
static const float shading_edges_of_8_bits[255] = {
{8_bits}};

/* The level of light. The bits of numbers rise as they do, and are faster to compare without an FPU. */
static inline uint32_t shading_level(const float *edges, uint32_t count, float light) {
    uint32_t level = 0, step;
    for (step = count / 2; step > 0; step /= 2) {
        if (shading_bits(light) >= shading_bits(edges[level + step - 1])) {
            level += step;
        }
    }
    return level;
}

/* One channel of a color as an sRGB byte, rounded once. */
static inline uint8_t shading_to_srgb8(float channel) {
    return (uint8_t)shading_level(shading_edges_of_8_bits, 256, channel);
}

/* A color in sRGB for a display of 16 bits: 5 bits red, 6 green, 5 blue, each rounded once. */
static inline uint16_t shading_to_rgb565(shading_vec3 color) {
    uint32_t r = shading_level(shading_edges_of_5_bits, 32, color.x);
    uint32_t g = shading_level(shading_edges_of_6_bits, 64, color.y);
    uint32_t b = shading_level(shading_edges_of_5_bits, 32, color.z);
    return (uint16_t)(r << 11 | g << 5 | b);
}

