/* shading_fixed.h: Lambert, Phong and Blinn-Phong shading in 16.16 fixed point, for processors without an FPU.
   C99 and C++11, integers alone, without libm and without memory of its own. MIT or Apache 2.0.

   Written by hand after the feature `fixed` of the Rust crate `shading`, and compared with it bit by bit: for any bits
   of any argument, each function gives the crate's bits, on every processor.

   A number is a count of steps of 2^-16, from -32,768 to 32,768 - 2^-16. Numbers saturate: nothing wraps, and there is
   neither an infinity nor a NaN. Choose the unit of length so that distances are from 0.01 to 200. Light is linear, and
   0 or more; encode it once, after the sum. All directions have length 1 and point away from the surface.

   How to use it:

       static const shading_fixed_light lamp = SHADING_FIXED_LAMP(2, 0, 2, 1.0, 0.8, 0.6, 1, 0, 0.25);
       static const shading_fixed_material clay = SHADING_FIXED_MATERIAL(0.1, 0.6, 0.3, 32);

       shading_fixed_sum sum = SHADING_FIXED_DARK;
       shading_fixed_add_blinn_phong(&sum, n, v, clay.m, &lamp, p);        once for each light
       shading_fixed_vec3 color = shading_fixed_total(&sum, &clay, ambient);
       uint16_t pixel = shading_fixed_to_rgb565(color); */
#ifndef SHADING_FIXED_H
#define SHADING_FIXED_H

#include <stdbool.h>
#include <stdint.h>
#ifdef __ARM_FEATURE_DSP
#include <arm_acle.h>
#endif

/* Tables stay in flash. */
#ifdef __AVR__
#include <avr/pgmspace.h>
#define SHADING_FIXED_TABLE static const uint16_t PROGMEM
#define SHADING_FIXED_BYTES static const uint8_t PROGMEM
#define SHADING_FIXED_READ(table, i) pgm_read_word(&(table)[i])
#define SHADING_FIXED_READ_BYTE(table, i) pgm_read_byte(&(table)[i])
#else
#define SHADING_FIXED_TABLE static const uint16_t
#define SHADING_FIXED_BYTES static const uint8_t
#define SHADING_FIXED_READ(table, i) ((table)[i])
#define SHADING_FIXED_READ_BYTE(table, i) ((table)[i])
#endif

/* A processor that multiplies 32 bits by 32 bits to no more than 32 bits: a Cortex-M0, M0+, M1 or M23. */
#ifndef SHADING_FIXED_NARROW_PRODUCT
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
#define SHADING_FIXED_NARROW_PRODUCT 1
#else
#define SHADING_FIXED_NARROW_PRODUCT 0
#endif
#endif

/* A function that a program should contain once, because it is long and rarely called; and one that only a program for
   a processor without long products should, because they make it long. */
#if defined(__GNUC__)
#define SHADING_FIXED_ONCE static __attribute__((noinline, unused))
#else
#define SHADING_FIXED_ONCE static
#endif
#if SHADING_FIXED_NARROW_PRODUCT
#define SHADING_FIXED_SHARED SHADING_FIXED_ONCE
#else
#define SHADING_FIXED_SHARED static inline
#endif

/* ---- Numbers, vectors and scenes ---- */

/* A number: a count of steps of 2^-16. */
typedef int32_t shading_fixed;

#define SHADING_FIXED_ONE ((shading_fixed)65536)
#define SHADING_FIXED_MAX ((shading_fixed)INT32_MAX)

/* The number nearest to a literal, for constants. */
#define SHADING_FIXED(x) ((shading_fixed)((x) * 65536.0 + ((x) < 0 ? -0.5 : 0.5)))

/* A vector, or red, green and blue. */
typedef struct {
    shading_fixed x, y, z;
} shading_fixed_vec3;

#define SHADING_FIXED_VEC3(x, y, z) {SHADING_FIXED(x), SHADING_FIXED(y), SHADING_FIXED(z)}

typedef enum { SHADING_FIXED_KIND_SUN, SHADING_FIXED_KIND_LAMP, SHADING_FIXED_KIND_SPOT } shading_fixed_kind;

typedef struct {
    uint8_t kind;                 /* a shading_fixed_kind */
    bool is_gltf;                 /* whether the window of the range is not squared, as in glTF */
    bool is_smooth;               /* whether the edge of the cone is a smoothstep, t²(3 − 2t) for t² */
    shading_fixed_vec3 position;  /* of a sun: the direction L to it, of length 1 */
    shading_fixed_vec3 intensity; /* 0 or more */
    shading_fixed a, b, c;        /* of the attenuation 1/(a + bq + cq²), 0 or more and not all 0 */
    shading_fixed limit;          /* the most that the attenuation is; SHADING_FIXED_MAX for no limit */
    shading_fixed range;          /* the distance from which on there is no light; SHADING_FIXED_MAX for no end */
    shading_fixed_vec3 axis;      /* of a spot: where it points, of length 1 */
    shading_fixed inner, outer;   /* cosines of the half-angles at which the edge begins and ends, inner >= outer */
} shading_fixed_light;

/* A sun in the direction L, of length 1. */
#define SHADING_FIXED_SUN(l_x, l_y, l_z, r, g, b) \
    {SHADING_FIXED_KIND_SUN, false, false, SHADING_FIXED_VEC3(l_x, l_y, l_z), SHADING_FIXED_VEC3(r, g, b), \
     SHADING_FIXED_ONE, 0, 0, SHADING_FIXED_MAX, SHADING_FIXED_MAX, SHADING_FIXED_VEC3(0, 0, 1), \
     -SHADING_FIXED_ONE, -SHADING_FIXED_ONE}

/* A lamp at a place, with the attenuation 1/(a + bq + cq²). */
#define SHADING_FIXED_LAMP(x, y, z, r, g, b, a_, b_, c_) \
    {SHADING_FIXED_KIND_LAMP, false, false, SHADING_FIXED_VEC3(x, y, z), SHADING_FIXED_VEC3(r, g, b), \
     SHADING_FIXED(a_), SHADING_FIXED(b_), SHADING_FIXED(c_), SHADING_FIXED_MAX, SHADING_FIXED_MAX, \
     SHADING_FIXED_VEC3(0, 0, 1), -SHADING_FIXED_ONE, -SHADING_FIXED_ONE}

typedef struct {
    shading_fixed_vec3 k_a, k_d, k_s; /* from 0 to 1 */
    uint32_t m;                       /* the shininess */
} shading_fixed_material;

/* A gray material. */
#define SHADING_FIXED_MATERIAL(k_a, k_d, k_s, m) \
    {SHADING_FIXED_VEC3(k_a, k_a, k_a), SHADING_FIXED_VEC3(k_d, k_d, k_d), SHADING_FIXED_VEC3(k_s, k_s, k_s), m}

/* The light of a sum, with 32 bits after the point: it is rounded once, whatever the order of the lights. */
typedef struct {
    uint64_t diffuse[3], specular[3];
} shading_fixed_sum;

#define SHADING_FIXED_DARK {{0, 0, 0}, {0, 0, 0}}

/* What arrives at a point: L, the distance q and the intensity I. */
typedef struct {
    shading_fixed_vec3 l;
    shading_fixed distance;
    shading_fixed_vec3 intensity;
} shading_fixed_arrival;

static inline shading_fixed_vec3 shading_fixed_vector(shading_fixed x, shading_fixed y, shading_fixed z) {
    shading_fixed_vec3 v = {x, y, z};
    return v;
}

/* ---- Products. Signed numbers wrap by way of unsigned ones, because C leaves their overflow undefined. ---- */

/* x · 2^n. */
static inline int32_t shading_fixed_shl(int32_t x, uint32_t n) { return (int32_t)((uint32_t)x << n); }

static inline int32_t shading_fixed_wrapping_add(int32_t x, int32_t y) {
    return (int32_t)((uint32_t)x + (uint32_t)y);
}

static inline int32_t shading_fixed_wrapping_mul(int32_t x, int32_t y) {
    return (int32_t)((uint32_t)x * (uint32_t)y);
}

static inline uint32_t shading_fixed_size(int32_t x) { return x < 0 ? 0 - (uint32_t)x : (uint32_t)x; }

/* How many of the highest bits are 0; 31 for 0, which no caller passes. */
static inline uint32_t shading_fixed_leading_zeros(uint32_t x) {
#if defined(__GNUC__) && !defined(__AVR__)
    return (uint32_t)__builtin_clz(x | 1);
#else
    uint32_t zeros = 0;
    while (zeros < 31 && !(x >> 31)) {
        x <<= 1;
        zeros++;
    }
    return zeros;
#endif
}

#if SHADING_FIXED_NARROW_PRODUCT
/* The upper half of a product, rounded down, by products of 16 bits by 16 bits. */
static inline int32_t shading_fixed_upper(int32_t a, int32_t b) {
    int32_t a_1 = a >> 16, a_0 = a & 0xFFFF, b_1 = b >> 16, b_0 = b & 0xFFFF;
    uint32_t low = ((uint32_t)a_0 * (uint32_t)b_0) >> 16;
    int32_t middle = a_1 * b_0 + (int32_t)low;
    int32_t other = shading_fixed_wrapping_add(a_0 * b_1, middle & 0xFFFF);
    return a_1 * b_1 + (middle >> 16) + (other >> 16);
}

/* The same of unsigned numbers, the second below 2^31. The sign of a stands for 2^32. */
static inline uint32_t shading_fixed_upper_unsigned(uint32_t a, uint32_t b) {
    uint32_t product = (uint32_t)shading_fixed_upper((int32_t)a, (int32_t)b);
    return product + ((uint32_t)((int32_t)a >> 31) & b);
}

/* The upper half of a product of unsigned numbers, rounded to the nearest. */
static inline uint32_t shading_fixed_upper_rounded(uint32_t a, uint32_t b) {
    uint32_t a_1 = a >> 16, a_0 = a & 0xFFFF, b_1 = b >> 16, b_0 = b & 0xFFFF;
    uint32_t middle = a_1 * b_0 + ((a_0 * b_0) >> 16);
    uint32_t other = a_0 * b_1 + (middle & 0xFFFF) + ((uint32_t)1 << 15);
    return a_1 * b_1 + (middle >> 16) + (other >> 16);
}

SHADING_FIXED_SHARED int64_t shading_fixed_product(int32_t a, int32_t b) {
    uint32_t low = (uint32_t)a * (uint32_t)b;
    return (int64_t)((uint64_t)(int64_t)shading_fixed_upper(a, b) << 32 | low);
}

/* The product of unsigned numbers, the second below 2^31. */
SHADING_FIXED_SHARED uint64_t shading_fixed_product_unsigned(uint32_t a, uint32_t b) {
    return (uint64_t)shading_fixed_upper_unsigned(a, b) << 32 | (uint32_t)(a * b);
}

/* The product with a number of at most 2^16. */
static inline uint64_t shading_fixed_product_by_fraction(uint32_t a, uint32_t fraction) {
    return ((uint64_t)((a >> 16) * fraction) << 16) + (a & 0xFFFF) * fraction;
}
#else
static inline int64_t shading_fixed_product(int32_t a, int32_t b) { return (int64_t)a * b; }

static inline uint64_t shading_fixed_product_unsigned(uint32_t a, uint32_t b) { return (uint64_t)a * b; }

/* The product with a number of at most 2^16. */
static inline uint64_t shading_fixed_product_by_fraction(uint32_t a, uint32_t fraction) {
    return (uint64_t)a * fraction;
}

/* The upper half of a product, rounded down. */
static inline int32_t shading_fixed_upper(int32_t a, int32_t b) { return (int32_t)(shading_fixed_product(a, b) >> 32); }

/* The same of unsigned numbers, the second below 2^31. */
static inline uint32_t shading_fixed_upper_unsigned(uint32_t a, uint32_t b) {
    return (uint32_t)(shading_fixed_product_unsigned(a, b) >> 32);
}

/* The upper half of a product of unsigned numbers, rounded to the nearest. */
static inline uint32_t shading_fixed_upper_rounded(uint32_t a, uint32_t b) {
    return (uint32_t)((shading_fixed_product_unsigned(a, b) + ((uint64_t)1 << 31)) >> 32);
}
#endif

/* x/2^bits, rounded to the nearest step. The sign is negative if x is. */
static inline shading_fixed shading_fixed_rounded(int64_t x, uint32_t bits, int32_t sign) {
    int64_t sum = x + ((int64_t)1 << (bits - 1));
    int32_t upper = (int32_t)(sum >> 32);
    if (shading_fixed_shl(upper, 32 - bits) >> (32 - bits) != upper) return sign >> 31 ^ INT32_MAX;
    return (int32_t)(sum >> bits);
}

/* ---- Arithmetic ---- */

#ifdef __ARM_FEATURE_DSP
static inline shading_fixed shading_fixed_add(shading_fixed x, shading_fixed y) { return __qadd(x, y); }

static inline shading_fixed shading_fixed_sub(shading_fixed x, shading_fixed y) { return __qsub(x, y); }
#else
static inline shading_fixed shading_fixed_add(shading_fixed x, shading_fixed y) {
    int32_t sum = shading_fixed_wrapping_add(x, y);
    return ((x ^ sum) & (y ^ sum)) < 0 ? x >> 31 ^ INT32_MAX : sum;
}

static inline shading_fixed shading_fixed_sub(shading_fixed x, shading_fixed y) {
    int32_t difference = (int32_t)((uint32_t)x - (uint32_t)y);
    return ((x ^ y) & (x ^ difference)) < 0 ? x >> 31 ^ INT32_MAX : difference;
}
#endif

static inline shading_fixed shading_fixed_neg(shading_fixed x) { return x == INT32_MIN ? INT32_MAX : -x; }

SHADING_FIXED_SHARED shading_fixed shading_fixed_mul(shading_fixed x, shading_fixed y) {
#if SHADING_FIXED_NARROW_PRODUCT
    /* As most reflectances are; it cannot leave the range. */
    if ((uint32_t)y <= (uint32_t)SHADING_FIXED_ONE) {
        return (x >> 16) * y + (int32_t)((((uint32_t)x & 0xFFFF) * (uint32_t)y + ((uint32_t)1 << 15)) >> 16);
    }
#endif
    return shading_fixed_rounded(shading_fixed_product(x, y), 16, x ^ y);
}

static inline shading_fixed shading_fixed_clamp(shading_fixed x, shading_fixed least, shading_fixed most) {
    return x < least ? least : x > most ? most : x;
}

static inline shading_fixed_vec3 shading_fixed_add3(shading_fixed_vec3 a, shading_fixed_vec3 b) {
    return shading_fixed_vector(shading_fixed_add(a.x, b.x), shading_fixed_add(a.y, b.y), shading_fixed_add(a.z, b.z));
}

static inline shading_fixed_vec3 shading_fixed_sub3(shading_fixed_vec3 a, shading_fixed_vec3 b) {
    return shading_fixed_vector(shading_fixed_sub(a.x, b.x), shading_fixed_sub(a.y, b.y), shading_fixed_sub(a.z, b.z));
}

static inline shading_fixed_vec3 shading_fixed_neg3(shading_fixed_vec3 v) {
    return shading_fixed_vector(shading_fixed_neg(v.x), shading_fixed_neg(v.y), shading_fixed_neg(v.z));
}

static inline shading_fixed_vec3 shading_fixed_mul3(shading_fixed_vec3 a, shading_fixed_vec3 b) {
    return shading_fixed_vector(shading_fixed_mul(a.x, b.x), shading_fixed_mul(a.y, b.y), shading_fixed_mul(a.z, b.z));
}

static inline shading_fixed_vec3 shading_fixed_scale3(shading_fixed_vec3 v, shading_fixed s) {
    return shading_fixed_vector(shading_fixed_mul(v.x, s), shading_fixed_mul(v.y, s), shading_fixed_mul(v.z, s));
}

/* The dot product. It is rounded once, and above 0 if the exact one is. */
SHADING_FIXED_SHARED shading_fixed shading_fixed_dot(shading_fixed_vec3 a, shading_fixed_vec3 b) {
    int64_t x = shading_fixed_product(a.x, b.x), y = shading_fixed_product(a.y, b.y), z = shading_fixed_product(a.z, b.z);
    int64_t sum = (x >> 1) + (y >> 1) + (z >> 1); /* of halves, which cannot overflow */
    shading_fixed steps = shading_fixed_rounded(sum, 15, (int32_t)(sum >> 32));
    return steps == 0 && sum > 0 ? 1 : steps;
}

/* ---- Reciprocals, roots and lengths ---- */

/* 2^8/√x for the middle x of each 128th, from 1/4 to 1; 0 below, where only vectors that are no directions lead. */
SHADING_FIXED_TABLE shading_fixed_roots[128] = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 508, 500, 493, 486,
    479, 472, 466, 460, 455, 449, 444, 439, 434, 429, 424, 420,
    415, 411, 407, 403, 399, 395, 392, 388, 385, 381, 378, 375,
    372, 369, 366, 363, 360, 357, 355, 352, 349, 347, 344, 342,
    340, 337, 335, 333, 331, 328, 326, 324, 322, 320, 318, 316,
    315, 313, 311, 309, 307, 306, 304, 302, 301, 299, 297, 296,
    294, 293, 291, 290, 288, 287, 286, 284, 283, 281, 280, 279,
    278, 276, 275, 274, 273, 271, 270, 269, 268, 267, 266, 264,
    263, 262, 261, 260, 259, 258, 257, 256,
};

static inline int32_t shading_fixed_first_root(uint32_t bits) {
    return (int32_t)SHADING_FIXED_READ(shading_fixed_roots, bits >> 25);
}

/* 2^27/√x for x = bits/2^32 from 1/4 on, by two steps of Newton's method. */
SHADING_FIXED_SHARED int32_t shading_fixed_reciprocal_root(uint32_t bits) {
    int32_t first = shading_fixed_first_root(bits);
    int32_t e = shading_fixed_wrapping_mul(first * first, (int32_t)(bits >> 16)); /* xy² − 1 */
    int32_t second = shading_fixed_shl(first, 6) - ((first * (e >> 12)) >> 15);
    e = ((int32_t)1 << 28) - (int32_t)shading_fixed_upper_unsigned(bits, (uint32_t)(second * second));
    return shading_fixed_shl(second, 13) + (shading_fixed_wrapping_mul(second, e >> 1) >> 15);
}

/* 2^28/x for x = bits/2^32 from 1/2 on, by two steps of Newton's method. It never rises with x, so that light never rises
   with distance: with the last bits of x, its rounding would take it up by a few units. */
SHADING_FIXED_SHARED uint32_t shading_fixed_reciprocal(uint32_t bits) {
    bits = bits >> 6 << 6;
    int32_t root = shading_fixed_first_root(bits), first = root * root;
    int32_t e = shading_fixed_wrapping_mul(first, (int32_t)(bits >> 16)); /* xy² − 1 */
    int32_t second = first - ((first * (e >> 12)) >> 20);
    e = ((int32_t)1 << 30) - (int32_t)shading_fixed_upper_unsigned(bits, (uint32_t)second << 14);
    return (uint32_t)shading_fixed_wrapping_add(shading_fixed_shl(second, 12),
                                                shading_fixed_wrapping_mul(second, e >> 4) >> 14);
}

/* The square root, rounded to the nearest step; 0 for a negative number. */
SHADING_FIXED_SHARED shading_fixed shading_fixed_sqrt(shading_fixed x) {
    if (x <= 0) return 0;
    uint32_t even = shading_fixed_leading_zeros((uint32_t)x) & ~(uint32_t)1, normal = (uint32_t)x << even;
    uint32_t upper = shading_fixed_upper_unsigned(normal, (uint32_t)shading_fixed_reciprocal_root(normal));
    int32_t root = (int32_t)(upper >> (3 + even / 2)); /* or a step less than the root */
    int32_t rest = (int32_t)(((uint32_t)x << 16) - (uint32_t)root * (uint32_t)root);
    return rest > root ? root + 1 : root;
}

/* A vector times 2^shift, with a component from 2^30 to 2^31 unless it is 0, |v|²/2^32 and 2^59/|v|. */
typedef struct {
    int32_t x, y, z;
    uint32_t shift, square;
    int32_t root;
} shading_fixed_scaled;

static inline uint32_t shading_fixed_square(int32_t x, int32_t y, int32_t z) {
    return (uint32_t)shading_fixed_upper(x, x) + (uint32_t)shading_fixed_upper(y, y) + (uint32_t)shading_fixed_upper(z, z);
}

/* n·v/2^20, less up to three roundings down. */
static inline int32_t shading_fixed_dot_scaled(shading_fixed_vec3 n, int32_t x, int32_t y, int32_t z) {
    int32_t sum = shading_fixed_wrapping_add(shading_fixed_upper(shading_fixed_shl(n.x, 12), x),
                                             shading_fixed_upper(shading_fixed_shl(n.y, 12), y));
    return shading_fixed_wrapping_add(sum, shading_fixed_upper(shading_fixed_shl(n.z, 12), z));
}

SHADING_FIXED_SHARED shading_fixed_scaled shading_fixed_scale_up(shading_fixed_vec3 v) {
    shading_fixed_scaled s;
    uint32_t bits = shading_fixed_size(v.x) | shading_fixed_size(v.y) | shading_fixed_size(v.z);
    s.shift = shading_fixed_leading_zeros(bits | bits << 1 | 1); /* 0 for −2^31, too */
    s.x = shading_fixed_shl(v.x, s.shift);
    s.y = shading_fixed_shl(v.y, s.shift);
    s.z = shading_fixed_shl(v.z, s.shift);
    s.square = shading_fixed_square(s.x, s.y, s.z); /* from 2^28 on */
    uint32_t pair = s.square >> 30 == 0;
    s.root = (bits == 0) ? 0 : shading_fixed_shl(shading_fixed_reciprocal_root(s.square << (2 * pair)), pair);
    return s;
}

/* The cosine of the angle to a direction, with 25 bits after the point. */
static inline int32_t shading_fixed_cosine(const shading_fixed_scaled *s, shading_fixed_vec3 n) {
    return shading_fixed_upper(shading_fixed_shl(shading_fixed_dot_scaled(n, s->x, s->y, s->z), 2), s->root);
}

static inline shading_fixed shading_fixed_component(int32_t x, int32_t root) {
    return (shading_fixed_upper(x, root) + ((int32_t)1 << 10)) >> 11;
}

/* The direction of a vector; 0 for the zero vector. */
static inline shading_fixed_vec3 shading_fixed_direction(const shading_fixed_scaled *s) {
    return shading_fixed_vector(shading_fixed_component(s->x, s->root), shading_fixed_component(s->y, s->root),
                                shading_fixed_component(s->z, s->root));
}

static inline shading_fixed shading_fixed_scaled_length(const shading_fixed_scaled *s) {
    uint32_t length = shading_fixed_upper_unsigned(s->square, (uint32_t)s->root), shift = s->shift;
    if (shift > 5) return (shading_fixed)(((length >> (shift - 6)) + 1) >> 1);
    if (length >> (26 + shift)) return SHADING_FIXED_MAX;
    return (shading_fixed)(length << (5 - shift));
}

/* The direction v/|v|; 0 where v is 0. */
static inline shading_fixed_vec3 shading_fixed_unit(shading_fixed_vec3 v) {
    shading_fixed_scaled s = shading_fixed_scale_up(v);
    return shading_fixed_direction(&s);
}

/* The length |v|. */
static inline shading_fixed shading_fixed_length(shading_fixed_vec3 v) {
    shading_fixed_scaled s = shading_fixed_scale_up(v);
    return shading_fixed_scaled_length(&s);
}

/* ---- Terms ---- */

/* The reflection vector R = 2(N·L)N − L. Phong 1975; Foley, van Dam et al. §16.1. */
static inline shading_fixed_vec3 shading_fixed_reflection(shading_fixed_vec3 n, shading_fixed_vec3 l) {
    shading_fixed n_dot_l = shading_fixed_dot(n, l);
    return shading_fixed_sub3(shading_fixed_scale3(n, shading_fixed_add(n_dot_l, n_dot_l)), l);
}

/* The half vector H = (L + V)/|L + V|; 0 where L = −V. Blinn 1977. */
static inline shading_fixed_vec3 shading_fixed_half_vector(shading_fixed_vec3 l, shading_fixed_vec3 v) {
    return shading_fixed_unit(shading_fixed_add3(l, v));
}

static inline uint32_t shading_fixed_fraction_product(uint32_t a, uint32_t b) {
    return (a * b + ((uint32_t)1 << 15)) >> 16;
}

/* max(0, min(1, cosine))ᵐ, by squaring; 0 where the cosine is not above 0, also for m = 0. */
SHADING_FIXED_SHARED shading_fixed shading_fixed_power(shading_fixed cosine, uint32_t m) {
    uint32_t base = (uint32_t)cosine, power;
    if (cosine <= 0) return 0;
    if (cosine >= SHADING_FIXED_ONE || m == 0) return SHADING_FIXED_ONE;
    for (; !(m & 1); m >>= 1) base = shading_fixed_fraction_product(base, base);
    for (power = base; m > 1;) {
        base = shading_fixed_fraction_product(base, base);
        m >>= 1;
        if (m & 1) power = shading_fixed_fraction_product(power, base);
    }
    return (shading_fixed)power;
}

/* Lambert's factor max(0, N·L). Lambert 1760. */
static inline shading_fixed shading_fixed_term_lambert(shading_fixed_vec3 n, shading_fixed_vec3 l) {
    shading_fixed n_dot_l = shading_fixed_dot(n, l);
    return n_dot_l > 0 ? n_dot_l : 0;
}

/* Phong's highlight max(0, R·V)ᵐ. Phong 1975. */
static inline shading_fixed shading_fixed_term_phong(shading_fixed_vec3 r, shading_fixed_vec3 v, uint32_t m) {
    return shading_fixed_power(shading_fixed_dot(r, v), m);
}

/* Blinn's highlight max(0, N·H)ᵐ. Blinn 1977. */
static inline shading_fixed shading_fixed_term_blinn(shading_fixed_vec3 n, shading_fixed_vec3 h, uint32_t m) {
    return shading_fixed_power(shading_fixed_dot(n, h), m);
}

/* The cosine of the angle between n and the sum of two directions; 0 if there is no sum. */
SHADING_FIXED_SHARED shading_fixed shading_fixed_halfway_cosine(shading_fixed_vec3 n, shading_fixed_vec3 a,
                                                              shading_fixed_vec3 b) {
    int32_t x = shading_fixed_shl(shading_fixed_wrapping_add(a.x, b.x), 12);
    int32_t y = shading_fixed_shl(shading_fixed_wrapping_add(a.y, b.y), 12);
    int32_t z = shading_fixed_shl(shading_fixed_wrapping_add(a.z, b.z), 12);
    uint32_t square;
    int32_t root;
    /* As a rule, the angle between the two is less than 120°, so that the first sum is long enough. */
    while ((square = shading_fixed_square(x, y, z)) >> 24 == 0) {
        if ((x | y | z) == 0) return 0;
        x *= 2;
        y *= 2;
        z *= 2;
    }
    if (square >> 26 == 0) {
        root = shading_fixed_shl(shading_fixed_reciprocal_root(square << 6), 1);
    } else {
        root = shading_fixed_reciprocal_root(square << 4);
    }
    int32_t cosine = shading_fixed_upper(shading_fixed_shl(shading_fixed_dot_scaled(n, x, y, z), 4), root);
    return (cosine + ((int32_t)1 << 8)) >> 9;
}

/* ---- What arrives ---- */

/* A light times a factor with 32 bits after the point. */
static inline shading_fixed_vec3 shading_fixed_dimmed(shading_fixed_vec3 light, uint32_t by) {
    return shading_fixed_vector((shading_fixed)shading_fixed_upper_rounded(by, light.x > 0 ? (uint32_t)light.x : 0),
                                (shading_fixed)shading_fixed_upper_rounded(by, light.y > 0 ? (uint32_t)light.y : 0),
                                (shading_fixed)shading_fixed_upper_rounded(by, light.z > 0 ? (uint32_t)light.z : 0));
}

static inline uint64_t shading_fixed_size_of_64(int64_t x) { return x < 0 ? 0 - (uint64_t)x : (uint64_t)x; }

/* A light times significand/2^shift, rounded. */
SHADING_FIXED_ONCE shading_fixed shading_fixed_times_factor(shading_fixed x, uint32_t significand, uint32_t shift) {
    uint64_t product = shading_fixed_product_unsigned(significand, x > 0 ? (uint32_t)x : 0);
    uint64_t steps = ((product << 1 >> shift) + 1) >> 1;
    return steps >> 31 ? SHADING_FIXED_MAX : (shading_fixed)steps;
}

/* The intensity times 1/(a + bq + cq²), at most the limit, where that is above 1 or its denominator d leaves 32 bits.
   It never rises with q or a coefficient. From 1 on, d has the slope that short products have, rounded to a step. Below
   1, where `is_near`, d has all the digits of the slope, and is limited to 1, because the two slopes differ. */
SHADING_FIXED_ONCE shading_fixed_vec3 shading_fixed_attenuated_rarely(const shading_fixed_light *light, shading_fixed q,
                                                                      bool is_near) {
    int64_t slope = shading_fixed_product(light->c, q) + (int64_t)light->b * SHADING_FIXED_ONE, denominator;
    int64_t constant = (int64_t)light->a * ((int64_t)1 << 32);
    uint64_t excess, in_steps, bits;
    int32_t shift = 44;
    uint32_t significand;
    const shading_fixed_vec3 i = light->intensity;
    if (!is_near) slope = ((slope + ((int32_t)1 << 15)) >> 16) * SHADING_FIXED_ONE;
    excess = shading_fixed_size_of_64(slope) >> 31 | shading_fixed_size_of_64(constant) >> 62;
    for (; excess; excess >>= 1, shift++) {
        slope >>= 1;
        constant >>= 1;
    }
    denominator = slope * q + constant;
    if (denominator < 0) return shading_fixed_vector(0, 0, 0);
    for (bits = (uint64_t)denominator | 1; !(bits >> 63); bits <<= 1) shift--;
    significand = shading_fixed_reciprocal((uint32_t)(bits >> 32)) << shading_fixed_clamp(-shift, 0, 3);
    shift = shading_fixed_clamp(shift, 0, 62);
    if (shift > 32) {
        significand >>= shift - 32;
        shift = 32;
    }
    in_steps = (uint64_t)significand << 16 >> shift;
    if (light->limit != SHADING_FIXED_MAX && in_steps >= (uint64_t)(int64_t)light->limit) {
        significand = light->limit > 0 ? (uint32_t)light->limit : 0;
        shift = 16;
    } else if (is_near && in_steps < (uint64_t)SHADING_FIXED_ONE) {
        significand = 1;
        shift = 0;
    }
    return shading_fixed_vector(shading_fixed_times_factor(i.x, significand, (uint32_t)shift),
                                shading_fixed_times_factor(i.y, significand, (uint32_t)shift),
                                shading_fixed_times_factor(i.z, significand, (uint32_t)shift));
}

/* The intensity of a lamp times 1/(a + bq + cq²), at most the limit. Foley, van Dam et al. §16.1; OpenGL 2.1 §2.14.1. */
static inline shading_fixed_vec3 shading_fixed_attenuated(const shading_fixed_light *light, shading_fixed q) {
    uint64_t product = shading_fixed_product_unsigned((uint32_t)light->c, (uint32_t)q);
    product += (uint64_t)(uint32_t)light->b << 16 | (uint32_t)1 << 15;
    uint32_t slope = (uint32_t)(product >> 16), slope_above = (uint32_t)(product >> 47);
    product = shading_fixed_product_unsigned(slope, (uint32_t)q);
    uint32_t d = (uint32_t)(product >> 16) + (uint32_t)light->a;
    uint32_t d_above = (uint32_t)(product >> 47) | (uint32_t)light->a >> 31;
    bool is_near = !(slope_above | d_above) && d < (uint32_t)SHADING_FIXED_ONE;
    if (is_near || (slope_above | d_above) || light->limit < SHADING_FIXED_ONE || light->c < 0) {
        return shading_fixed_attenuated_rarely(light, q, is_near);
    }
    if (d == (uint32_t)SHADING_FIXED_ONE) return light->intensity;
    uint32_t zeros = shading_fixed_leading_zeros(d);
    return shading_fixed_dimmed(light->intensity, shading_fixed_reciprocal(d << zeros) << 3 >> (15 - zeros));
}

/* The window max(0, 1 − (q/r)⁴)² of a range r, or without the square as in glTF, with 32 bits after the point.
   1 − (q/r)⁴ = rest (2 − rest) with rest = (r² − q²)/r². Karis 2013; KHR_lights_punctual. */
SHADING_FIXED_ONCE uint32_t shading_fixed_window(shading_fixed_vec3 v, shading_fixed range, bool is_gltf) {
    uint64_t q_squared = (uint64_t)shading_fixed_product(v.x, v.x) + (uint64_t)shading_fixed_product(v.y, v.y) +
                         (uint64_t)shading_fixed_product(v.z, v.z);
    uint64_t r_squared = (uint64_t)shading_fixed_product(range, range), difference = r_squared - q_squared;
    if (q_squared >= r_squared) return 0;
    uint32_t zeros = r_squared >> 32 ? shading_fixed_leading_zeros((uint32_t)(r_squared >> 32))
                                     : 32 + shading_fixed_leading_zeros((uint32_t)r_squared);
    uint32_t rest = shading_fixed_upper_unsigned((uint32_t)(difference << zeros >> 32),
                                                 shading_fixed_reciprocal((uint32_t)(r_squared << zeros >> 32)));
    rest = rest >> 28 ? UINT32_MAX >> 1 : rest << 3; /* 31 bits after the point, where 2 is 2^32 */
    uint32_t root = shading_fixed_upper_unsigned(0 - rest, rest);
    return (is_gltf ? root : shading_fixed_upper_unsigned(2 * root, 2 * root)) << 2;
}

/* The factor of the cone of a spot: t² or t²(3 − 2t), t from 0 at the outer edge to 1 at the inner one, with 32 bits
   after the point. v leads to the light. KHR_lights_punctual; POV-Ray 3.7. */
SHADING_FIXED_ONCE uint32_t shading_fixed_cone(const shading_fixed_light *light, shading_fixed_vec3 v) {
    const shading_fixed narrowest = SHADING_FIXED_ONE - 4;
    /* The axis is lit and a cone of every direction lights every direction, although cosines are rounded. */
    shading_fixed inner = light->inner < -narrowest ? -2 * SHADING_FIXED_ONE : light->inner;
    shading_fixed outer = shading_fixed_clamp(light->outer, -SHADING_FIXED_ONE, narrowest);
    shading_fixed_scaled s = shading_fixed_scale_up(v);
    int32_t cosine = shading_fixed_cosine(&s, shading_fixed_neg3(light->axis)); /* 25 bits after the point */
    if (inner > narrowest) inner = narrowest;
    if (cosine >= shading_fixed_shl(inner, 9)) return UINT32_MAX; /* which rounds to 1 */
    if (cosine <= shading_fixed_shl(outer, 9)) return 0;
    uint32_t width = (uint32_t)inner - (uint32_t)outer;
    uint32_t zeros = shading_fixed_leading_zeros(width);
    uint32_t beyond = ((uint32_t)cosine - ((uint32_t)outer << 9)) << (zeros - 9);
    uint32_t t = shading_fixed_upper_unsigned(beyond, shading_fixed_reciprocal(width << zeros));
    t <<= 3; /* 31 bits after the point, below 1 for each width */
    uint32_t square = shading_fixed_upper_unsigned(t, t);
    return light->is_smooth ? shading_fixed_upper_unsigned(((uint32_t)3 << 30) - t, square) << 4 : square << 2;
}

/* What is left of the intensity of a lamp or a spot at the end of the vector v, of length q. */
static inline shading_fixed_vec3 shading_fixed_arriving(const shading_fixed_light *light, shading_fixed_vec3 v,
                                                             shading_fixed q) {
    shading_fixed_vec3 i = shading_fixed_attenuated(light, q);
    if (light->range < SHADING_FIXED_MAX) i = shading_fixed_dimmed(i, shading_fixed_window(v, light->range, light->is_gltf));
    if (light->kind == SHADING_FIXED_KIND_SPOT) i = shading_fixed_dimmed(i, shading_fixed_cone(light, v));
    return i;
}

/* What arrives at p: L, the distance and I. Nothing arrives at the place of a lamp itself. */
static inline shading_fixed_arrival shading_fixed_arrival_at(const shading_fixed_light *light, shading_fixed_vec3 p) {
    shading_fixed_arrival arrival = {light->position, SHADING_FIXED_MAX, light->intensity};
    if (light->kind != SHADING_FIXED_KIND_SUN) {
        shading_fixed_vec3 v = shading_fixed_sub3(light->position, p);
        shading_fixed_scaled s = shading_fixed_scale_up(v);
        arrival.l = shading_fixed_direction(&s);
        arrival.distance = shading_fixed_scaled_length(&s);
        arrival.intensity = shading_fixed_arriving(light, v, arrival.distance);
        if ((v.x | v.y | v.z) == 0) {
            arrival.l = shading_fixed_vector(0, 0, SHADING_FIXED_ONE);
            arrival.distance = 0;
            arrival.intensity = shading_fixed_vector(0, 0, 0);
        }
    }
    return arrival;
}

/* ---- The sum over lights: I_r = k_a I_a + Σ I (k_d max(0, N·L) + k_s highlight) ---- */

static inline void shading_fixed_add_to(uint64_t *sum, shading_fixed_vec3 light, shading_fixed cosine) {
    uint32_t factor = (uint32_t)shading_fixed_clamp(cosine, 0, SHADING_FIXED_ONE);
    sum[0] += shading_fixed_product_by_fraction(light.x > 0 ? (uint32_t)light.x : 0, factor);
    sum[1] += shading_fixed_product_by_fraction(light.y > 0 ? (uint32_t)light.y : 0, factor);
    sum[2] += shading_fixed_product_by_fraction(light.z > 0 ? (uint32_t)light.z : 0, factor);
}

/* Adds the diffuse light of one light at p. Gives whether the light is in front of the surface, its direction w and
   its intensity. A light with N·L ≤ 0 is behind and adds nothing. */
static inline bool shading_fixed_add_diffuse(shading_fixed_sum *sum, shading_fixed_vec3 n,
                                                  const shading_fixed_light *light, shading_fixed_vec3 p,
                                                  shading_fixed_vec3 *w, shading_fixed_vec3 *intensity) {
    bool is_sun = light->kind == SHADING_FIXED_KIND_SUN;
    shading_fixed_vec3 v = is_sun ? light->position : shading_fixed_sub3(light->position, p);
    uint64_t x = (uint64_t)shading_fixed_product(n.x, v.x), y = (uint64_t)shading_fixed_product(n.y, v.y);
    shading_fixed n_dot_l;
    if ((int64_t)(x + y + (uint64_t)shading_fixed_product(n.z, v.z)) <= 0) return false;
    if (is_sun) {
        *w = v;
        *intensity = light->intensity;
        n_dot_l = shading_fixed_dot(n, v);
    } else {
        shading_fixed_scaled s = shading_fixed_scale_up(v);
        *w = shading_fixed_direction(&s);
        *intensity = shading_fixed_arriving(light, v, shading_fixed_scaled_length(&s));
        n_dot_l = (shading_fixed_cosine(&s, n) + ((int32_t)1 << 8)) >> 9;
    }
    shading_fixed_add_to(sum->diffuse, *intensity, n_dot_l);
    return true;
}

/* Adds one light by Lambert's model: I k_d max(0, N·L). */
static inline void shading_fixed_add_lambert(shading_fixed_sum *sum, shading_fixed_vec3 n,
                                             const shading_fixed_light *light, shading_fixed_vec3 p) {
    shading_fixed_vec3 w, intensity;
    shading_fixed_add_diffuse(sum, n, light, p, &w, &intensity);
}

/* Adds one light by Phong's model: I (k_d N·L + k_s max(0, R·V)ᵐ), where N·L > 0. Phong 1975. */
static inline void shading_fixed_add_phong(shading_fixed_sum *sum, shading_fixed_vec3 n, shading_fixed_vec3 v,
                                           uint32_t m, const shading_fixed_light *light, shading_fixed_vec3 p) {
    shading_fixed_vec3 w, intensity;
    if (shading_fixed_add_diffuse(sum, n, light, p, &w, &intensity)) {
        shading_fixed_vec3 r = shading_fixed_reflection(n, w);
        shading_fixed_add_to(sum->specular, intensity, shading_fixed_term_phong(r, v, m));
    }
}

/* Adds one light by Blinn and Phong's model: I (k_d N·L + k_s max(0, N·H)ᵐ), where N·L > 0. Blinn 1977. */
static inline void shading_fixed_add_blinn_phong(shading_fixed_sum *sum, shading_fixed_vec3 n, shading_fixed_vec3 v,
                                                 uint32_t m, const shading_fixed_light *light, shading_fixed_vec3 p) {
    shading_fixed_vec3 w, intensity;
    if (shading_fixed_add_diffuse(sum, n, light, p, &w, &intensity)) {
        shading_fixed n_dot_h = shading_fixed_halfway_cosine(n, w, v);
        shading_fixed_add_to(sum->specular, intensity, shading_fixed_power(n_dot_h, m));
    }
}

static inline shading_fixed shading_fixed_channel(uint64_t sum) {
    uint64_t steps = (sum + ((uint64_t)1 << 15)) >> 16;
    return steps >> 31 ? SHADING_FIXED_MAX : (shading_fixed)steps;
}

static inline shading_fixed_vec3 shading_fixed_color(const uint64_t *sum) {
    return shading_fixed_vector(shading_fixed_channel(sum[0]), shading_fixed_channel(sum[1]),
                                shading_fixed_channel(sum[2]));
}

/* The light that leaves the surface: k_a I_a, and the diffuse and the specular sum by k_d and k_s. */
static inline shading_fixed_vec3 shading_fixed_total(const shading_fixed_sum *sum,
                                                          const shading_fixed_material *material,
                                                          shading_fixed_vec3 i_a) {
    shading_fixed_vec3 ambient = shading_fixed_mul3(material->k_a, i_a);
    shading_fixed_vec3 diffuse = shading_fixed_mul3(shading_fixed_color(sum->diffuse), material->k_d);
    shading_fixed_vec3 specular = shading_fixed_mul3(shading_fixed_color(sum->specular), material->k_s);
    return shading_fixed_add3(shading_fixed_add3(ambient, diffuse), specular);
}

/* ---- Normals; each is 0 where there is none ---- */

/* The vector between two points times a power of two, with a component from 2^30 to 2^31 unless it is 0. */
SHADING_FIXED_ONCE void shading_fixed_edge(shading_fixed_vec3 from, shading_fixed_vec3 to, int32_t *edge) {
    int64_t x = (int64_t)to.x - from.x, y = (int64_t)to.y - from.y, z = (int64_t)to.z - from.z;
    uint32_t bits, shift;
    if (x != (int32_t)x || y != (int32_t)y || z != (int32_t)z) {
        x = (to.x >> 1) - (from.x >> 1);
        y = (to.y >> 1) - (from.y >> 1);
        z = (to.z >> 1) - (from.z >> 1);
    }
    bits = shading_fixed_size((int32_t)x) | shading_fixed_size((int32_t)y) | shading_fixed_size((int32_t)z);
    shift = shading_fixed_leading_zeros(bits | bits << 1 | 1); /* 0 for −2^31, too */
    edge[0] = shading_fixed_shl((int32_t)x, shift);
    edge[1] = shading_fixed_shl((int32_t)y, shift);
    edge[2] = shading_fixed_shl((int32_t)z, shift);
}

static inline shading_fixed shading_fixed_of_21_bits(int64_t x, uint32_t left) {
    int32_t size = ((int32_t)(shading_fixed_size_of_64(x) << left >> 42) + 1) >> 1;
    return x < 0 ? -size : size;
}

/* The direction of a vector, by way of one with a component from 16 to 32. */
SHADING_FIXED_ONCE shading_fixed_vec3 shading_fixed_unit_of_64(int64_t x, int64_t y, int64_t z) {
    uint64_t bits = shading_fixed_size_of_64(x) | shading_fixed_size_of_64(y) | shading_fixed_size_of_64(z) | 1;
    uint32_t left = bits >> 32 ? shading_fixed_leading_zeros((uint32_t)(bits >> 32))
                               : 32 + shading_fixed_leading_zeros((uint32_t)bits);
    return shading_fixed_unit(shading_fixed_vector(
        shading_fixed_of_21_bits(x, left), shading_fixed_of_21_bits(y, left), shading_fixed_of_21_bits(z, left)));
}

/* The normal of the plane ax + by + cz + d = 0: (a, b, c)/|(a, b, c)|. Foley, van Dam et al. §11.1.3. */
static inline shading_fixed_vec3 shading_fixed_normal_plane(shading_fixed a, shading_fixed b, shading_fixed c) {
    return shading_fixed_unit(shading_fixed_vector(a, b, c));
}

/* The normal of a sphere: (p − center)/|p − center|. Foley, van Dam et al. §15.10.1. */
static inline shading_fixed_vec3 shading_fixed_normal_sphere(shading_fixed_vec3 center, shading_fixed_vec3 p) {
    int32_t e[3];
    shading_fixed_edge(center, p, e);
    return shading_fixed_unit_of_64(e[0], e[1], e[2]);
}

/* ad − bc. */
static inline int64_t shading_fixed_minor(int32_t a, int32_t d, int32_t b, int32_t c) {
    return shading_fixed_product(a, d) - shading_fixed_product(b, c);
}

/* The normal of a counterclockwise triangle: (v₂ − v₁) × (v₃ − v₁), length 1. Foley, van Dam et al. §11.1.3. */
SHADING_FIXED_ONCE shading_fixed_vec3 shading_fixed_normal_triangle(shading_fixed_vec3 v1, shading_fixed_vec3 v2,
                                                                    shading_fixed_vec3 v3) {
    int32_t a[3], b[3];
    shading_fixed_edge(v1, v2, a);
    shading_fixed_edge(v1, v3, b);
    return shading_fixed_unit_of_64(shading_fixed_minor(a[1], b[2], a[2], b[1]),
                                    shading_fixed_minor(a[2], b[0], a[0], b[2]),
                                    shading_fixed_minor(a[0], b[1], a[1], b[0]));
}

/* The side of a two-sided surface that faces the eye: N if F·V ≥ 0, else −N. F is the normal of the face. */
static inline shading_fixed_vec3 shading_fixed_normal_facing(shading_fixed_vec3 n, shading_fixed_vec3 v,
                                                             shading_fixed_vec3 f) {
    return shading_fixed_dot(shading_fixed_neg3(f), v) > 0 ? shading_fixed_neg3(n) : n;
}

/* ---- Encodings: linear light to the levels of displays and pictures, each rounded once ---- */

/* The level at which each 64th of the light begins, and the least light of each next level, in steps. */
SHADING_FIXED_BYTES shading_fixed_first_of_5_bits[64] = {
    0, 4, 6, 7, 9, 10, 10, 11, 12, 13, 13, 14, 15, 15, 16, 16,
    17, 17, 18, 18, 18, 19, 19, 20, 20, 20, 21, 21, 21, 22, 22, 22,
    23, 23, 23, 24, 24, 24, 25, 25, 25, 25, 26, 26, 26, 27, 27, 27,
    27, 28, 28, 28, 28, 29, 29, 29, 29, 29, 30, 30, 30, 30, 31, 31,
};
SHADING_FIXED_TABLE shading_fixed_next_of_5_bits[32] = {
    82, 249, 477, 796, 1214, 1737, 2373, 3127, 4005, 5012, 6154, 7434,
    8857, 10428, 12150, 14028, 16065, 18265, 20631, 23167, 25876, 28761, 31826, 35074,
    38506, 42128, 45940, 49947, 54150, 58553, 63158, 65535,
};
SHADING_FIXED_BYTES shading_fixed_first_of_6_bits[64] = {
    0, 8, 12, 15, 17, 20, 21, 23, 24, 26, 27, 28, 30, 31, 32, 33,
    34, 35, 36, 37, 37, 38, 39, 40, 41, 41, 42, 43, 44, 44, 45, 46,
    46, 47, 48, 48, 49, 49, 50, 51, 51, 52, 52, 53, 53, 54, 54, 55,
    55, 56, 57, 57, 57, 58, 58, 59, 59, 60, 60, 61, 61, 62, 62, 63,
};
SHADING_FIXED_TABLE shading_fixed_next_of_6_bits[64] = {
    41, 121, 202, 292, 403, 536, 690, 868, 1070, 1297, 1551, 1830,
    2138, 2473, 2838, 3232, 3656, 4111, 4597, 5115, 5666, 6250, 6868, 7520,
    8207, 8928, 9686, 10480, 11311, 12179, 13084, 14028, 15010, 16031, 17092, 18192,
    19333, 20514, 21737, 23001, 24307, 25655, 27045, 28479, 29956, 31477, 33042, 34651,
    36305, 38005, 39749, 41540, 43377, 45261, 47191, 49169, 51194, 53267, 55388, 57557,
    59775, 62043, 64359, 65535,
};
SHADING_FIXED_BYTES shading_fixed_first_of_8_bits[64] = {
    0, 34, 49, 61, 71, 79, 86, 93, 99, 105, 110, 115, 120, 124, 129, 133,
    137, 141, 145, 148, 152, 155, 158, 162, 165, 168, 171, 174, 177, 179, 182, 185,
    188, 190, 193, 195, 198, 200, 202, 205, 207, 209, 212, 214, 216, 218, 220, 223,
    225, 227, 229, 231, 233, 235, 237, 239, 240, 242, 244, 246, 248, 250, 251, 253,
};
SHADING_FIXED_TABLE shading_fixed_next_of_8_bits[256] = {
    10, 30, 50, 70, 90, 110, 130, 150, 170, 189, 209, 230,
    253, 276, 301, 327, 354, 382, 412, 443, 475, 509, 544, 580,
    618, 657, 698, 740, 783, 828, 875, 923, 972, 1023, 1075, 1129,
    1185, 1242, 1300, 1360, 1422, 1486, 1551, 1617, 1685, 1755, 1827, 1900,
    1975, 2052, 2130, 2210, 2292, 2376, 2461, 2548, 2637, 2727, 2820, 2914,
    3010, 3108, 3208, 3309, 3412, 3518, 3625, 3734, 3844, 3957, 4072, 4188,
    4307, 4427, 4550, 4674, 4800, 4929, 5059, 5191, 5325, 5461, 5600, 5740,
    5882, 6026, 6173, 6321, 6471, 6624, 6779, 6935, 7094, 7255, 7418, 7583,
    7750, 7920, 8091, 8265, 8440, 8618, 8798, 8981, 9165, 9352, 9541, 9732,
    9925, 10121, 10318, 10518, 10721, 10925, 11132, 11341, 11552, 11766, 11981, 12200,
    12420, 12643, 12868, 13095, 13325, 13557, 13791, 14028, 14267, 14508, 14752, 14998,
    15247, 15498, 15751, 16007, 16265, 16525, 16788, 17054, 17322, 17592, 17864, 18140,
    18417, 18697, 18980, 19265, 19552, 19842, 20135, 20430, 20727, 21027, 21330, 21635,
    21942, 22252, 22565, 22880, 23198, 23518, 23841, 24166, 24494, 24825, 25158, 25494,
    25832, 26173, 26517, 26863, 27212, 27563, 27917, 28274, 28633, 28995, 29360, 29727,
    30097, 30470, 30845, 31223, 31604, 31987, 32373, 32762, 33154, 33548, 33945, 34345,
    34747, 35152, 35560, 35971, 36384, 36800, 37219, 37641, 38065, 38493, 38923, 39355,
    39791, 40229, 40671, 41115, 41562, 42011, 42464, 42919, 43377, 43838, 44302, 44769,
    45238, 45711, 46186, 46664, 47145, 47629, 48116, 48605, 49098, 49593, 50092, 50593,
    51097, 51604, 52114, 52627, 53143, 53662, 54184, 54709, 55236, 55767, 56300, 56837,
    57377, 57919, 58465, 59013, 59564, 60119, 60676, 61237, 61800, 62367, 62936, 63509,
    64084, 64663, 65245, 65535,
};

/* The last level that begins at or below the light. */
static inline uint32_t shading_fixed_level(const uint8_t *first, const uint16_t *next, shading_fixed channel) {
    uint32_t light = (uint32_t)shading_fixed_clamp(channel, 0, 65534);
    uint32_t level = SHADING_FIXED_READ_BYTE(first, light >> 10);
    while (light >= SHADING_FIXED_READ(next, level)) level++;
    return level;
}

/* The color as sRGB for a display of 16 bits: 5 bits red, 6 green, 5 blue. IEC 61966-2-1. */
static inline uint16_t shading_fixed_to_rgb565(shading_fixed_vec3 color) {
    uint32_t r = shading_fixed_level(shading_fixed_first_of_5_bits, shading_fixed_next_of_5_bits, color.x);
    uint32_t g = shading_fixed_level(shading_fixed_first_of_6_bits, shading_fixed_next_of_6_bits, color.y);
    uint32_t b = shading_fixed_level(shading_fixed_first_of_5_bits, shading_fixed_next_of_5_bits, color.z);
    return (uint16_t)(r << 11 | g << 5 | b);
}

/* One channel of the color as an sRGB byte. IEC 61966-2-1. */
static inline uint8_t shading_fixed_to_srgb8(shading_fixed channel) {
    return (uint8_t)shading_fixed_level(shading_fixed_first_of_8_bits, shading_fixed_next_of_8_bits, channel);
}

#endif
