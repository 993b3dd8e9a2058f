/* shading: Lambert, Phong and Blinn-Phong in linear light. MIT or Apache 2.0. */
/* Written by the package shading-languages from the source of the crate shading; do not edit it. */
/* All directions have length 1 and point away from the surface. A direction that does not exist is 0. */
/* Numbers are finite, and light, reflectances and the shininess m at least 0; then no result is NaN or negative light. */
/* Every bit is the crate's, also for numbers from 1e-45 to 1e38; GCC needs -ffp-contract=off. */

#ifndef SHADING_H
#define SHADING_H

#include <math.h>
#include <stdint.h>
#include <string.h>

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

/* A light of any kind. A sun has its direction L for a position; a lamp has the cosines -1. */
typedef struct {
    shading_vec3 position;
    float is_sun;
    shading_vec3 intensity;
    float limit;
    shading_vec3 coefficients;
    float range;
    shading_vec3 axis;
    float is_smoothstep;
    shading_vec2 cosines;
    float is_gltf;
} shading_Light;

/* The reflectances of a surface, and its shininess m. */
typedef struct {
    shading_vec3 k_a;
    float m;
    shading_vec3 k_d;
    shading_vec3 k_s;
} shading_Material;

/* What arrives at a point from one light: L, the distance q and I. */
typedef struct {
    shading_vec3 l;
    float q;
    shading_vec3 i;
} shading_Arrival;

/* The sums over lights of I max(0, N.L) and of I times the highlight. They begin as 0. */
typedef struct {
    shading_vec3 diffuse;
    shading_vec3 specular;
} shading_Sums;

/* The tangent t of a triangle with texture coordinates, and its handedness h. */
typedef struct {
    shading_vec3 t;
    float h;
} shading_Tangent;

/* A vector w of the direction of another, whose square is in range, |w|, and the length of the other. */
typedef struct {
    shading_vec3 w;
    float w_length;
    float v_length;
} shading_Measured;

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

/* (c/d)^m for c/d within [0, 1] and m >= 0, by the crate's own logarithm: within 2^-22. */
static inline float shading_power_of_quotient(float c, float d, float m) {
    float scaled = c * 16777216.0f;
    float least = d * 11863283.0f;
    float z = shading_significand(scaled, least);
    float one = d * 16777216.0f;
    float s = (z - one) / (z + one);
    float s2 = s * s;
    float log2 = shading_exponent(scaled, least) + s * (2.8853905f + s2 * 0.9615518f + s2 * s2 * 0.59732693f);
    float y = shading_max(shading_min(m * log2, 0.0f), -126.0f);
    float shifted = y + 12583038.0f;
    float r = y - shading_steps_above(shifted, 12583038.0f);
    float r2 = r * r;
    float q = 0.38629442f + 0.4804531f * r + r2 * (0.111006565f + 0.019235516f * r) + r2 * r2
            * (0.0026797508f + 0.00031013472f * r);
    return (2.0f + r + r * q) * shading_two_to_low_bits(shifted);
}

/* c^m for c within [0, 1] and m >= 0, within 2^-22. */
static inline float shading_power(float c, float m) {
    float scaled = c * 16777216.0f;
    float z = shading_significand(scaled, 11863283.0f);
    float s = (z - 16777216.0f) / (z + 16777216.0f);
    float s2 = s * s;
    float log2 = shading_exponent(scaled, 11863283.0f) + s
            * (2.8853905f + s2 * 0.9615518f + s2 * s2 * 0.59732693f);
    float y = shading_max(m * log2, -126.0f);
    float shifted = y + 12583038.0f;
    float r = y - shading_steps_above(shifted, 12583038.0f);
    float r2 = r * r;
    float q = 0.38629442f + 0.4804531f * r + r2 * (0.111006565f + 0.019235516f * r) + r2 * r2
            * (0.0026797508f + 0.00031013472f * r);
    return (2.0f + r + r * q) * shading_two_to_low_bits(shifted);
}

/* Whether a square is so small or large that it is not exact. */
static inline int shading_is_extreme(float square) {
    return (uint32_t)shading_bits(square) - 0x0D800000u >= 0x64000000u;
}

/* The length of v, and w in its direction: v itself, or v times a power of 2 where its square is out of range. */
static inline shading_Measured shading_measured(shading_vec3 v) {
    float square = shading_dot(v, v);
    if (shading_is_extreme(square)) {
        float power = square < 1.2676506e30f ? (square < 7.888609e-31f ? 1.2676506e30f : 1.0f)
                : 7.888609e-31f;
        shading_vec3 w = shading_scale(shading_scale(v, shading_min(power, 1.0f)), shading_max(power, 1.0f));
        float w_square = shading_dot(w, w);
        float root = sqrtf(w_square);
        shading_Measured result = {w, w_square > 0.0f && w_square < 3.4028234e38f ? root : 0.0f,
                w_square > 0.0f && w_square < 3.4028234e38f ? shading_min(root / power, 3.4028234e38f)
                : root};
        return result;
    }
    float length = sqrtf(square);
    shading_Measured result = {v, length, length};
    return result;
}

/* v/|v|; 0 where v is 0. */
static inline shading_vec3 shading_unit(shading_vec3 v) {
    shading_Measured way = shading_measured(v);
    return way.w_length > 0.0f ? shading_over(way.w, way.w_length) : shading_vector(0.0f, 0.0f, 0.0f);
}

/* The vector from a point to another, times a power of 2 where its square is out of range. */
static inline shading_vec3 shading_between(shading_vec3 origin, shading_vec3 p) {
    shading_vec3 v = shading_sub(p, origin);
    float square = shading_dot(v, v);
    if (shading_is_extreme(square)) {
        float power = square < 1.2676506e30f ? (square < 7.888609e-31f ? 1.2676506e30f : 1.0f)
                : 7.888609e-31f;
        float shrink = shading_min(power, 1.0f);
        return shading_scale(shading_sub(shading_scale(p, shrink), shading_scale(origin, shrink)),
                shading_max(power, 1.0f));
    }
    return v;
}

/* (a - origin) x (b - origin), in the right direction even where its square is out of range. */
static inline shading_vec3 shading_crossed(shading_vec3 origin, shading_vec3 a, shading_vec3 b) {
    shading_vec3 c = shading_cross(shading_sub(a, origin), shading_sub(b, origin));
    if (shading_is_extreme(shading_dot(c, c))) {
        return shading_cross(shading_between(origin, a), shading_between(origin, b));
    }
    return c;
}

/* The reflection vector R = 2(N.L)N - L. Phong 1975; Foley, van Dam et al. 16.1. */
static inline shading_vec3 shading_reflection(shading_vec3 n, shading_vec3 l) {
    float n_dot_l = shading_dot(n, l);
    return shading_sub(shading_scale(n, n_dot_l + n_dot_l), l);
}

/* The half vector H = (L + V)/|L + V|; 0 where L = -V. Blinn 1977. */
static inline shading_vec3 shading_half_vector(shading_vec3 l, shading_vec3 v) {
    return shading_unit(shading_add(l, v));
}

/* The ambient term k_a I_a. Foley, van Dam et al. 16.1. */
static inline shading_vec3 shading_term_ambient(shading_vec3 k_a, shading_vec3 i_a) {
    return shading_mul(k_a, i_a);
}

/* Lambert's factor max(0, N.L). Lambert 1760. */
static inline float shading_term_lambert(shading_vec3 n, shading_vec3 l) {
    return shading_max(shading_dot(n, l), 0.0f);
}

/* Phong's highlight max(0, R.V)^m. Phong 1975. */
static inline float shading_term_phong(shading_vec3 r, shading_vec3 v, float m) {
    float r_dot_v = shading_dot(r, v);
    return r_dot_v > 0.0f ? shading_power(shading_clamp(r_dot_v, 0.0f, 1.0f), shading_max(m, 0.0f)) : 0.0f;
}

/* Blinn's highlight max(0, N.H)^m. Blinn 1977. */
static inline float shading_term_blinn(shading_vec3 n, shading_vec3 h, float m) {
    float n_dot_h = shading_dot(n, h);
    return n_dot_h > 0.0f ? shading_power(shading_clamp(n_dot_h, 0.0f, 1.0f), shading_max(m, 0.0f)) : 0.0f;
}

/* What makes Phong's highlight reflect at most k_s: (m + 2)/(2 pi). Lafortune and Willems 1994. */
static inline float shading_term_phong_normalization(float m) {
    return (shading_max(m, 0.0f) + 2.0f) * 0.15915494f;
}

/* The same of Blinn's: (m + 2)(m + 4)/(8 pi (2^(-m/2) + m)). Giesen 2009. */
static inline float shading_term_blinn_normalization(float m) {
    float exponent = shading_max(m, 0.0f);
    return (exponent + 2.0f) * 0.039788734f
            * ((exponent + 4.0f) / (exponent + shading_power(0.70710677f, shading_max(exponent, 0.0f))));
}

/* The attenuation 1/(a + bq + cq^2). Foley, van Dam et al. 16.1; OpenGL 2.1, 2.14.1. */
static inline float shading_attenuation(float a, float b, float c, float q) {
    return shading_clamp(1.0f / (a + q * (b + c * q)), 0.0f, 3.4028234e38f);
}

/* What ends a light at the range r: max(0, 1 - (q/r)^4)^2. Karis 2013. */
static inline float shading_window(float q, float r) {
    float fraction = q / r;
    float square = fraction * fraction;
    float root = shading_max(1.0f - square * square, 0.0f);
    return root * root;
}

/* The same without the square: KHR_lights_punctual. */
static inline float shading_window_gltf(float q, float r) {
    float fraction = q / r;
    float square = fraction * fraction;
    return shading_max(1.0f - square * square, 0.0f);
}

/* t^2, where t rises from 0 at the cosine of the outer edge to 1 at that of the inner. KHR_lights_punctual. */
static inline float shading_beam(float cosine, float inner, float outer) {
    if (!(inner > outer)) {
        return inner > cosine ? 0.0f : 1.0f;
    }
    float t = shading_clamp((cosine - outer) / (inner - outer), 0.0f, 1.0f);
    return inner > cosine ? t * t : 1.0f;
}

/* The same with t^2(3 - 2t). POV-Ray 3.7. */
static inline float shading_beam_smoothstep(float cosine, float inner, float outer) {
    if (!(inner > outer)) {
        return inner > cosine ? 0.0f : 1.0f;
    }
    float t = shading_clamp((cosine - outer) / (inner - outer), 0.0f, 1.0f);
    return inner > cosine ? shading_min(t * t * (3.0f - (t + t)), 1.0f) : 1.0f;
}

/* The factor of a spot's cone, given the cosines of its inner and its outer half-angle. */
static inline float shading_cone(shading_vec3 axis, shading_vec3 l, shading_vec2 cosines) {
    float inner = cosines.x < -0.9999995f ? -2.0f : shading_min(cosines.x, 0.9999995f);
    float outer = cosines.x < -0.9999995f ? -2.0f : shading_min(cosines.y, 0.9999995f);
    return shading_beam(shading_dot(shading_neg(axis), l), inner, outer);
}

/* The same with a smoothstep between the edges. */
static inline float shading_cone_smoothstep(shading_vec3 axis, shading_vec3 l, shading_vec2 cosines) {
    float cosine = shading_dot(shading_neg(axis), l);
    float inner = cosines.x < -0.9999995f ? -2.0f : shading_min(cosines.x, 0.9999995f);
    float outer = cosines.x < -0.9999995f ? -2.0f : shading_min(cosines.y, 0.9999995f);
    return shading_beam_smoothstep(cosine, inner, outer);
}

/* What dims a light after the distance q: its attenuation, at most its limit, and the window of its range. */
static inline float shading_falloff(const shading_Light *light, float q) {
    return shading_clamp(1.0f
            / (light->coefficients.x + q * (light->coefficients.y + light->coefficients.z * q)), 0.0f,
            light->limit) * (light->range < 3.4028234e38f
            ? (light->is_gltf > 0.0f ? shading_window_gltf(q, light->range) : shading_window(q, light->range))
            : 1.0f);
}

/* The factor of a spot's cone, by the cosine between its axis and -L. */
static inline float shading_spot(const shading_Light *light, float cosine) {
    float inner = light->cosines.x < -0.9999995f ? -2.0f : shading_min(light->cosines.x, 0.9999995f);
    float outer = light->cosines.x < -0.9999995f ? -2.0f : shading_min(light->cosines.y, 0.9999995f);
    return light->is_smoothstep > 0.0f ? shading_beam_smoothstep(cosine, inner, outer)
            : shading_beam(cosine, inner, outer);
}

/* What arrives at the point p: L, the distance q and I. Foley, van Dam et al. 16.1. */
static inline shading_Arrival shading_arrival(const shading_Light *light, shading_vec3 p) {
    if (light->is_sun > 0.0f) {
        shading_Arrival result = {light->position, 3.4028234e38f, light->intensity};
        return result;
    }
    shading_Measured to_light = shading_measured(shading_sub(light->position, p));
    if (!(to_light.w_length > 0.0f)) {
        shading_Arrival result = {shading_vector(0.0f, 0.0f, 1.0f),
                shading_min(to_light.v_length, 3.4028234e38f), shading_vector(0.0f, 0.0f, 0.0f)};
        return result;
    }
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light->cosines.x > -1.0f
            ? shading_spot(light, shading_dot(shading_neg(light->axis), to_light.w) / to_light.w_length)
            : 1.0f);
    shading_Arrival result = {shading_over(to_light.w, to_light.w_length),
            shading_min(to_light.v_length, 3.4028234e38f),
            shading_at_most(shading_scale(light->intensity, dimmed), 3.4028234e38f)};
    return result;
}

/* What one light adds by Lambert's model: I k_d max(0, N.L). */
static inline shading_vec3 shading_shade_lambert(shading_vec3 n, const shading_Material *material,
        const shading_Arrival *light) {
    float n_dot_l = shading_dot(n, light->l);
    if (!(n_dot_l > 0.0f)) {
        return shading_vector(0.0f, 0.0f, 0.0f);
    }
    return shading_mul(shading_scale(light->i, shading_clamp(n_dot_l, 0.0f, 1.0f)), material->k_d);
}

/* What one light adds by Phong's model: I (k_d N.L + k_s max(0, R.V)^m), where N.L > 0. Phong 1975. */
static inline shading_vec3 shading_shade_phong(shading_vec3 n, shading_vec3 v,
        const shading_Material *material, const shading_Arrival *light) {
    float n_dot_l = shading_dot(n, light->l);
    if (!(n_dot_l > 0.0f)) {
        return shading_vector(0.0f, 0.0f, 0.0f);
    }
    shading_vec3 diffuse = shading_mul(shading_scale(light->i, shading_clamp(n_dot_l, 0.0f, 1.0f)),
            material->k_d);
    shading_vec3 r = shading_sub(shading_scale(n, n_dot_l + n_dot_l), light->l);
    float r_dot_v = shading_dot(r, v);
    float highlight = r_dot_v > 0.0f
            ? shading_power(shading_clamp(r_dot_v, 0.0f, 1.0f), shading_max(material->m, 0.0f)) : 0.0f;
    shading_vec3 specular = shading_mul(shading_scale(light->i, highlight), material->k_s);
    return shading_add(diffuse, specular);
}

/* What one light adds by Blinn and Phong's model: I (k_d N.L + k_s max(0, N.H)^m), where N.L > 0. Blinn 1977. */
static inline shading_vec3 shading_shade_blinn_phong(shading_vec3 n, shading_vec3 v,
        const shading_Material *material, const shading_Arrival *light) {
    float n_dot_l = shading_dot(n, light->l);
    if (!(n_dot_l > 0.0f)) {
        return shading_vector(0.0f, 0.0f, 0.0f);
    }
    shading_vec3 diffuse = shading_mul(shading_scale(light->i, shading_clamp(n_dot_l, 0.0f, 1.0f)),
            material->k_d);
    shading_vec3 h = shading_add(light->l, v);
    float n_dot_h = shading_dot(n, h);
    float highlight = n_dot_h > 0.0f
            ? shading_power_of_quotient(n_dot_h * n_dot_h, shading_dot(h, h),
            shading_max(0.5f * material->m, 0.0f)) : 0.0f;
    shading_vec3 specular = shading_mul(shading_scale(light->i, highlight), material->k_s);
    return shading_add(diffuse, specular);
}

/* The sums over lights after one more, by Lambert's model. A light from behind adds nothing and costs no root. */
static inline void shading_add_lambert(shading_Sums *sums, shading_vec3 n, const shading_Light *light,
        shading_vec3 p) {
    if (light->is_sun > 0.0f) {
        float n_dot_l = shading_dot(n, light->position);
        if (!(n_dot_l > 0.0f)) {
            return;
        }
        sums->diffuse = shading_add(sums->diffuse,
                shading_scale(light->intensity, shading_clamp(n_dot_l, 0.0f, 1.0f)));
        return;
    }
    shading_vec3 way = shading_sub(light->position, p);
    if (!(shading_dot(n, way) > 0.0f)) {
        return;
    }
    shading_Measured to_light = shading_measured(way);
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light->cosines.x > -1.0f
            ? shading_spot(light, shading_dot(shading_neg(light->axis), to_light.w) / to_light.w_length)
            : 1.0f);
    sums->diffuse = shading_add(sums->diffuse,
            shading_scale(light->intensity,
            dimmed * shading_clamp(shading_dot(n, to_light.w) / to_light.w_length, 0.0f, 1.0f)));
}

/* The same by Phong's model. */
static inline void shading_add_phong(shading_Sums *sums, shading_vec3 n, shading_vec3 v, float m,
        const shading_Light *light, shading_vec3 p) {
    if (light->is_sun > 0.0f) {
        float n_dot_l = shading_dot(n, light->position);
        if (!(n_dot_l > 0.0f)) {
            return;
        }
        float r_dot_v = shading_dot(shading_sub(shading_scale(n, n_dot_l + n_dot_l), light->position), v);
        float highlight_of_sun = r_dot_v > 0.0f
                ? shading_power(shading_clamp(r_dot_v, 0.0f, 1.0f), shading_max(m, 0.0f)) : 0.0f;
        sums->diffuse = shading_add(sums->diffuse,
                shading_scale(light->intensity, shading_clamp(n_dot_l, 0.0f, 1.0f)));
        sums->specular = shading_add(sums->specular, shading_scale(light->intensity, highlight_of_sun));
        return;
    }
    shading_vec3 way = shading_sub(light->position, p);
    if (!(shading_dot(n, way) > 0.0f)) {
        return;
    }
    shading_Measured to_light = shading_measured(way);
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light->cosines.x > -1.0f
            ? shading_spot(light, shading_dot(shading_neg(light->axis), to_light.w) / to_light.w_length)
            : 1.0f);
    float n_dot_w = shading_dot(n, to_light.w);
    float cosine = shading_dot(shading_sub(shading_scale(n, n_dot_w + n_dot_w), to_light.w), v)
            / to_light.w_length;
    float highlight = cosine > 0.0f ? shading_power(shading_clamp(cosine, 0.0f, 1.0f), shading_max(m, 0.0f))
            : 0.0f;
    sums->diffuse = shading_add(sums->diffuse,
            shading_scale(light->intensity, dimmed * shading_clamp(n_dot_w / to_light.w_length, 0.0f, 1.0f)));
    sums->specular = shading_add(sums->specular, shading_scale(light->intensity, dimmed * highlight));
}

/* The same by Blinn and Phong's model. */
static inline void shading_add_blinn_phong(shading_Sums *sums, shading_vec3 n, shading_vec3 v, float m,
        const shading_Light *light, shading_vec3 p) {
    if (light->is_sun > 0.0f) {
        float n_dot_l = shading_dot(n, light->position);
        if (!(n_dot_l > 0.0f)) {
            return;
        }
        shading_vec3 h = shading_add(light->position, v);
        float n_dot_h = shading_dot(n, h);
        float highlight_of_sun = n_dot_h > 0.0f
                ? shading_power_of_quotient(n_dot_h * n_dot_h, shading_dot(h, h), shading_max(0.5f * m, 0.0f))
                : 0.0f;
        sums->diffuse = shading_add(sums->diffuse,
                shading_scale(light->intensity, shading_clamp(n_dot_l, 0.0f, 1.0f)));
        sums->specular = shading_add(sums->specular, shading_scale(light->intensity, highlight_of_sun));
        return;
    }
    shading_vec3 way = shading_sub(light->position, p);
    if (!(shading_dot(n, way) > 0.0f)) {
        return;
    }
    shading_Measured to_light = shading_measured(way);
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light->cosines.x > -1.0f
            ? shading_spot(light, shading_dot(shading_neg(light->axis), to_light.w) / to_light.w_length)
            : 1.0f);
    shading_vec3 halfway = shading_add(to_light.w, shading_scale(v, to_light.w_length));
    float cosine = shading_dot(n, halfway);
    float highlight = cosine > 0.0f
            ? shading_power_of_quotient(cosine * cosine, shading_dot(halfway, halfway),
            shading_max(0.5f * m, 0.0f)) : 0.0f;
    sums->diffuse = shading_add(sums->diffuse,
            shading_scale(light->intensity,
            dimmed * shading_clamp(shading_dot(n, to_light.w) / to_light.w_length, 0.0f, 1.0f)));
    sums->specular = shading_add(sums->specular, shading_scale(light->intensity, dimmed * highlight));
}

/* The light that the point reflects: k_a I_a + k_d times the diffuse sum + k_s times the specular one. */
static inline shading_vec3 shading_total(const shading_Sums *sums, const shading_Material *material,
        shading_vec3 i_a) {
    return shading_add(shading_add(shading_mul(material->k_a, i_a),
            shading_mul(shading_at_most(sums->diffuse, 3.4028234e38f), material->k_d)),
            shading_mul(shading_at_most(sums->specular, 3.4028234e38f), material->k_s));
}

/* The normal of the plane ax + by + cz + d = 0: (a, b, c)/|(a, b, c)|. Foley, van Dam et al. 11.1.3. */
static inline shading_vec3 shading_normal_plane(float a, float b, float c) {
    return shading_unit(shading_vector(a, b, c));
}

/* The normal of a triangle, counter-clockwise: (v2 - v1) x (v3 - v1), length 1. Foley, van Dam et al. 11.1.3. */
static inline shading_vec3 shading_normal_triangle(shading_vec3 v1, shading_vec3 v2, shading_vec3 v3) {
    return shading_unit(shading_crossed(v1, v2, v3));
}

/* The normal of a sphere: (p - center)/|p - center|. Foley, van Dam et al. 15.10.1. */
static inline shading_vec3 shading_normal_sphere(shading_vec3 center, shading_vec3 p) {
    return shading_unit(shading_between(center, p));
}

/* The normal of f(p) = 0 by the gradient of f, length 1. Foley, van Dam et al. 11.4. */
static inline shading_vec3 shading_normal_from_gradient(shading_vec3 gradient) {
    return shading_unit(gradient);
}

/* The normal of s(u, v): ds/du x ds/dv, length 1. Foley, van Dam et al. 11.3.4. */
static inline shading_vec3 shading_normal_from_tangents(shading_vec3 s_u, shading_vec3 s_v) {
    return shading_unit(shading_crossed(shading_vector(0.0f, 0.0f, 0.0f), s_u, s_v));
}

/* N toward the eye: N if F.V >= 0, else -N, where F is the normal of the face. GLSL 4.60, 8.5. */
static inline shading_vec3 shading_normal_facing(shading_vec3 n, shading_vec3 v, shading_vec3 f) {
    return shading_dot(shading_neg(f), v) > 0.0f ? shading_neg(n) : n;
}

/* A normal transformed by the matrix of the columns a, b, c: cof(M) N, length 1. Lengyel 2024. */
static inline shading_vec3 shading_normal_transformed(shading_vec3 n, shading_vec3 a, shading_vec3 b,
        shading_vec3 c) {
    if (shading_is_extreme(shading_dot(a, a)) || shading_is_extreme(shading_dot(b, b))
            || shading_is_extreme(shading_dot(c, c))) {
        shading_vec3 along_b = shading_add(shading_unit(b), shading_scale(b, 0.0f));
        shading_vec3 along_c = shading_add(shading_unit(c), shading_scale(c, 0.0f));
        float abs_x = fabsf(n.x);
        shading_Measured x = shading_measured(a);
        float abs_y = fabsf(n.y);
        shading_Measured y = shading_measured(b);
        float abs_z = fabsf(n.z);
        shading_Measured z = shading_measured(c);
        float least = shading_min(shading_min(abs_x > 0.0f ? x.v_length : 3.4028234e38f,
                abs_y > 0.0f ? y.v_length : 3.4028234e38f), abs_z > 0.0f ? z.v_length : 3.4028234e38f);
        float n_x = abs_x > 0.0f ? n.x * (x.v_length > least ? least / x.v_length : 1.0f) : 0.0f;
        shading_vec3 along_a = shading_add(shading_unit(a), shading_scale(a, 0.0f));
        float n_y = abs_y > 0.0f ? n.y * (y.v_length > least ? least / y.v_length : 1.0f) : 0.0f;
        float n_z = abs_z > 0.0f ? n.z * (z.v_length > least ? least / z.v_length : 1.0f) : 0.0f;
        return shading_unit(shading_add(shading_add(shading_scale(shading_cross(along_b, along_c), n_x),
                shading_scale(shading_cross(along_c, along_a), n_y)),
                shading_scale(shading_cross(along_a, along_b), n_z)));
    }
    return shading_unit(shading_add(shading_add(shading_scale(shading_cross(b, c), n.x),
            shading_scale(shading_cross(c, a), n.y)), shading_scale(shading_cross(a, b), n.z)));
}

/* A triangle's normal times its angle at v1, to be summed over a mesh. Thuermer and Wuethrich 1998. */
static inline shading_vec3 shading_normal_corner(shading_vec3 v1, shading_vec3 v2, shading_vec3 v3) {
    shading_vec3 e1 = shading_between(v1, v2);
    shading_vec3 e2 = shading_between(v1, v3);
    shading_Measured c = shading_measured(shading_cross(e1, e2));
    float cosine = shading_dot(e1, e2);
    float adjacent = fabsf(cosine);
    float x = adjacent * 2.4142137f > c.v_length ? (cosine > 0.0f ? 1.0f : -1.0f) : 0.0f;
    float y = c.v_length > adjacent * 0.41421357f ? 1.0f : 0.0f;
    float t = (x * c.v_length - y * cosine) / (x * cosine + y * c.v_length);
    float z = t * t;
    float z2 = z * z;
    float z4 = z2 * z2;
    float series = -0.33333334f + z * 0.2f + z2 * (-0.14285715f + z * 0.111111104f) + z4
            * (-0.0909089f + z * 0.07691945f + z2 * (-0.06661951f + z * 0.05840374f) + z4
            * (-0.050085507f + z * 0.03734732f + z2 * -0.01718003f));
    float arctangent = t + t * (z * series);
    float angle = shading_max(1.5707964f - x * (1.5707964f - y * 0.7853982f) + arctangent, 0.0f);
    return shading_scale(c.w_length > 0.0f ? shading_over(c.w, c.w_length) : shading_vector(0.0f, 0.0f, 0.0f),
            angle);
}

/* The tangent of a triangle and its handedness, by the texture coordinates of its vertices. Lengyel 2001. */
static inline shading_Tangent shading_normal_tangent(shading_vec3 v1, shading_vec3 v2, shading_vec3 v3,
        shading_vec2 uv1, shading_vec2 uv2, shading_vec2 uv3) {
    shading_vec3 half_v1 = shading_scale(v1, 0.5f);
    shading_vec3 e2 = shading_sub(shading_scale(v2, 0.5f), half_v1);
    shading_vec3 e3 = shading_sub(shading_scale(v3, 0.5f), half_v1);
    float edge = shading_max(shading_measured(e2).v_length, shading_measured(e3).v_length);
    float half_y = uv1.y * 0.5f;
    float y3 = uv3.y * 0.5f - half_y;
    float y2 = uv2.y * 0.5f - half_y;
    float y_size = shading_max(fabsf(y2), fabsf(y3));
    float y3_part = y3 / y_size;
    float y2_part = y2 / y_size;
    float half_x = uv1.x * 0.5f;
    float x2 = uv2.x * 0.5f - half_x;
    float x3 = uv3.x * 0.5f - half_x;
    float x_size = shading_max(fabsf(x2), fabsf(x3));
    float d = x2 / x_size * y3_part - x3 / x_size * y2_part;
    float h = d > 0.0f ? 1.0f : -1.0f;
    shading_Measured t = shading_measured(shading_scale(shading_sub(shading_scale(shading_over(e2, edge),
            y3_part), shading_scale(shading_over(e3, edge), y2_part)), h));
    if (!(t.w_length > 0.0f && fabsf(d) > 0.0f)) {
        shading_Tangent result = {shading_vector(0.0f, 0.0f, 0.0f), 0.0f};
        return result;
    }
    shading_Tangent result = {shading_over(t.w, t.w_length), h};
    return result;
}

/* A normal from a map: x t + y b + z N, length 1. glTF 2.0, 3.7.2.1. */
static inline shading_vec3 shading_normal_mapped(shading_vec3 n, shading_vec3 tangent, float h,
        shading_vec3 s) {
    shading_Measured across = shading_measured(shading_crossed(shading_vector(0.0f, 0.0f, 0.0f), n, tangent));
    shading_Measured texel = shading_measured(s);
    if (!(across.w_length > 0.0f && texel.w_length > 0.0f)) {
        return shading_vector(0.0f, 0.0f, 0.0f);
    }
    shading_vec3 side = shading_over(across.w, across.w_length);
    return shading_unit(shading_add(shading_add(shading_scale(shading_cross(side, n),
            texel.w.x / texel.w_length),
            shading_scale(shading_scale(side, h > 0.0f ? 1.0f : -1.0f), texel.w.y / texel.w_length)),
            shading_scale(n, texel.w.z / texel.w_length)));
}

/* The least light of each level but 0, in sRGB. IEC 61966-2-1. */
static const float shading_edges_of_5_bits[31] = {
    0.0012483771f, 0.003792393f, 0.0072772023f, 0.012143275f, 0.018514259f, 0.026500106f, 0.03620051f,
    0.047707114f, 0.061105072f, 0.07647412f, 0.09388944f, 0.11342224f, 0.13514034f, 0.15910853f,
    0.18538891f, 0.21404114f, 0.24512279f, 0.27868935f, 0.31479463f, 0.35349065f, 0.39482796f,
    0.43885577f, 0.4856219f, 0.53517294f, 0.58755434f, 0.6428106f, 0.70098495f, 0.76212f,
    0.8262572f, 0.8934373f, 0.96370023f,
};
static const float shading_edges_of_6_bits[63] = {
    0.0006142808f, 0.0018428424f, 0.003071404f, 0.004454382f, 0.0061464263f, 0.008163896f, 0.010522583f,
    0.013237243f, 0.01632177f, 0.01978932f, 0.023652392f, 0.027922926f, 0.03261236f, 0.037731674f,
    0.04329145f, 0.049301896f, 0.05577289f, 0.062713996f, 0.0701345f, 0.078043416f, 0.08644953f,
    0.09536139f, 0.10478733f, 0.1147355f, 0.12521385f, 0.13623017f, 0.14779206f, 0.15990697f,
    0.17258224f, 0.18582502f, 0.19964236f, 0.21404114f, 0.2290282f, 0.24461016f, 0.26079363f,
    0.27758503f, 0.29499072f, 0.31301698f, 0.33166996f, 0.35095575f, 0.3708803f, 0.39144957f,
    0.41266936f, 0.43454543f, 0.45708343f, 0.48028898f, 0.5041676f, 0.5287248f, 0.5539659f,
    0.57989633f, 0.60652125f, 0.633846f, 0.66187567f, 0.69061536f, 0.7200702f, 0.75024503f,
    0.7811449f, 0.8127747f, 0.84513927f, 0.8782434f, 0.91209185f, 0.94668925f, 0.9820404f,
};
static const float shading_edges_of_8_bits[255] = {
    0.0001517635f, 0.0004552905f, 0.0007588175f, 0.0010623445f, 0.0013658715f, 0.0016693985f, 0.0019729256f,
    0.0022764525f, 0.0025799794f, 0.0028835065f, 0.003188301f, 0.0035092595f, 0.003848315f, 0.0042057484f,
    0.004581833f, 0.0049768374f, 0.0053910245f, 0.005824651f, 0.0062779696f, 0.0067512277f, 0.0072446684f,
    0.007758531f, 0.0082930485f, 0.008848454f, 0.009424971f, 0.0100228265f, 0.010642237f, 0.011283422f,
    0.0119465925f, 0.01263196f, 0.013339732f, 0.014070112f, 0.014823304f, 0.015599503f, 0.01639891f,
    0.017221717f, 0.018068116f, 0.018938296f, 0.019832443f, 0.020750746f, 0.021693384f, 0.022660539f,
    0.023652392f, 0.024669116f, 0.025710888f, 0.026777884f, 0.027870271f, 0.028988222f, 0.030131903f,
    0.031301484f, 0.032497123f, 0.03371899f, 0.034967244f, 0.036242045f, 0.037543554f, 0.03887193f,
    0.04022732f, 0.04160989f, 0.043019786f, 0.044457164f, 0.045922175f, 0.047414966f, 0.04893569f,
    0.050484486f, 0.05206151f, 0.0536669f, 0.055300802f, 0.05696336f, 0.058654718f, 0.060375012f,
    0.062124386f, 0.063902974f, 0.06571092f, 0.06754836f, 0.06941541f, 0.07131224f, 0.07323896f,
    0.07519571f, 0.07718262f, 0.07919982f, 0.08124745f, 0.083325624f, 0.08543449f, 0.08757416f,
    0.08974477f, 0.091946445f, 0.0941793f, 0.09644348f, 0.098739095f, 0.10106628f, 0.10342514f,
    0.105815805f, 0.10823841f, 0.11069305f, 0.11317987f, 0.11569897f, 0.11825049f, 0.12083452f,
    0.1234512f, 0.12610064f, 0.12878296f, 0.13149826f, 0.13424668f, 0.1370283f, 0.13984329f,
    0.14269169f, 0.14557366f, 0.14848931f, 0.15143874f, 0.15442206f, 0.1574394f, 0.16049084f,
    0.1635765f, 0.1666965f, 0.16985095f, 0.17303993f, 0.17626357f, 0.17952198f, 0.18281525f,
    0.1861435f, 0.18950684f, 0.19290535f, 0.19633916f, 0.19980836f, 0.20331305f, 0.20685335f,
    0.21042934f, 0.21404114f, 0.21768886f, 0.22137257f, 0.2250924f, 0.22884843f, 0.23264077f,
    0.23646952f, 0.24033478f, 0.24423665f, 0.24817522f, 0.2521506f, 0.25616285f, 0.26021212f,
    0.2642985f, 0.26842204f, 0.2725829f, 0.2767811f, 0.28101683f, 0.2852901f, 0.28960103f,
    0.29394975f, 0.2983363f, 0.3027608f, 0.30722338f, 0.31172407f, 0.31626296f, 0.3208402f,
    0.32545584f, 0.33011f, 0.33480275f, 0.3395342f, 0.34430438f, 0.34911346f, 0.3539615f,
    0.35884857f, 0.3637748f, 0.36874023f, 0.373745f, 0.37878916f, 0.38387278f, 0.388996f,
    0.3941589f, 0.39936155f, 0.40460402f, 0.40988642f, 0.41520885f, 0.42057136f, 0.42597407f,
    0.43141705f, 0.43690038f, 0.44242412f, 0.44798842f, 0.45359334f, 0.45923892f, 0.46492532f,
    0.47065255f, 0.47642073f, 0.48222995f, 0.48808026f, 0.49397177f, 0.49990457f, 0.50587875f,
    0.51189435f, 0.5179514f, 0.5240502f, 0.5301906f, 0.5363727f, 0.54259676f, 0.5488627f,
    0.55517066f, 0.5615207f, 0.56791294f, 0.5743474f, 0.58082414f, 0.58734334f, 0.59390503f,
    0.6005093f, 0.60715616f, 0.61384577f, 0.62057817f, 0.6273534f, 0.63417166f, 0.64103293f,
    0.6479373f, 0.6548849f, 0.66187567f, 0.66890985f, 0.6759874f, 0.68310845f, 0.6902731f,
    0.6974814f, 0.7047334f, 0.71202916f, 0.7193689f, 0.72675246f, 0.7341801f, 0.74165183f,
    0.74916774f, 0.7567279f, 0.7643323f, 0.7719812f, 0.7796745f, 0.78741235f, 0.7951948f,
    0.8030219f, 0.81089383f, 0.8188106f, 0.8267722f, 0.83477885f, 0.84283054f, 0.8509273f,
    0.8590693f, 0.8672565f, 0.8754891f, 0.8837671f, 0.89209056f, 0.9004596f, 0.9088742f,
    0.91733456f, 0.9258407f, 0.9343926f, 0.9429904f, 0.9516342f, 0.96032405f, 0.96906f,
    0.97784215f, 0.98667055f, 0.99554527f,
};

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

#endif
