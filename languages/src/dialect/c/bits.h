static inline int32_t shading_bits(float x) {
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}
static inline float shading_from_bits(int32_t bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline int32_t shading_above(float x, float least) {
    return (int32_t)((uint32_t)shading_bits(x) - (uint32_t)shading_bits(least));
}

/* e of x = 2^e z, where z is within [least, 2 least). */
static inline float shading_exponent(float x, float least) {
    int32_t above = shading_above(x, least);
    return (float)((above - (above & 0x7FFFFF)) / 0x800000);
}
/* z of x = 2^e z. */
static inline float shading_significand(float x, float least) {
    int32_t above = shading_above(x, least);
    return shading_from_bits(shading_bits(x) - (above - (above & 0x7FFFFF)));
}
/* 2^(n - 127) for the low byte n of the bits of x. */
static inline float shading_two_to_low_bits(float x) {
    return shading_from_bits((int32_t)((uint32_t)shading_bits(x) << 23));
}
/* How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart. */
static inline float shading_steps_above(float x, float shift) {
    return (float)shading_above(x, shift);
}

