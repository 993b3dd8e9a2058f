/* shading: Lambert, Phong and Blinn-Phong in linear light. MIT or Apache 2.0. */
/* Written by the package shading-languages from the source of the crate shading; do not edit it. */
/* All directions have length 1 and point away from the surface. A direction that does not exist is 0. */
/* Numbers are finite, and light, reflectances and the shininess m at least 0; then no result is NaN or negative light. */

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

/* Whether a square is so small or large that it is not exact. */
static inline int shading_is_extreme(float square) {
    return !(square >= 7.888609e-31f && square < 1.2676506e30f);
}

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

/* The length of v, and w in its direction: v itself, or v times a power of 2 where its square is out of range. */
static inline shading_Measured shading_measured(shading_vec3 v) {
    float square = shading_dot(v, v);
    if (shading_is_extreme(square)) {
        float power = square < 1.2676506e30f ? (square < 7.888609e-31f ? 1.2676506e30f : 1.0f)
                : 7.888609e-31f;
        shading_vec3 w = shading_scale(shading_scale(v, shading_min(power, 1.0f)), shading_max(power, 1.0f));
        float w_square = shading_dot(w, w);
        float root = sqrtf(w_square);
        shading_Measured result = {w, w_square > 0.0f && w_square < 3.4028235e38f ? root : 0.0f,
                w_square > 0.0f && w_square < 3.4028235e38f ? shading_min(root / power, 3.4028235e38f)
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
    return shading_clamp(1.0f / (a + q * (b + c * q)), 0.0f, 3.4028235e38f);
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
static inline float shading_falloff(shading_Light light, float q) {
    return shading_clamp(1.0f
            / (light.coefficients.x + q * (light.coefficients.y + light.coefficients.z * q)), 0.0f,
            light.limit) * (light.range < 3.4028235e38f
            ? (light.is_gltf > 0.0f ? shading_window_gltf(q, light.range) : shading_window(q, light.range))
            : 1.0f);
}

/* The factor of a spot's cone, by the cosine between its axis and -L. */
static inline float shading_spot(shading_Light light, float cosine) {
    float inner = light.cosines.x < -0.9999995f ? -2.0f : shading_min(light.cosines.x, 0.9999995f);
    float outer = light.cosines.x < -0.9999995f ? -2.0f : shading_min(light.cosines.y, 0.9999995f);
    return light.is_smoothstep > 0.0f ? shading_beam_smoothstep(cosine, inner, outer)
            : shading_beam(cosine, inner, outer);
}

/* What arrives at the point p: L, the distance q and I. Foley, van Dam et al. 16.1. */
static inline shading_Arrival shading_arrival(shading_Light light, shading_vec3 p) {
    if (light.is_sun > 0.0f) {
        shading_Arrival result = {light.position, 3.4028235e38f, light.intensity};
        return result;
    }
    shading_Measured to_light = shading_measured(shading_sub(light.position, p));
    float dimmed = to_light.w_length > 0.0f ? shading_falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0f
            ? shading_spot(light, shading_dot(shading_neg(light.axis), to_light.w) / to_light.w_length)
            : 1.0f) : 0.0f;
    shading_Arrival result = {to_light.w_length > 0.0f ? shading_over(to_light.w, to_light.w_length)
            : shading_vector(0.0f, 0.0f, 1.0f), shading_min(to_light.v_length, 3.4028235e38f),
            shading_at_most(shading_scale(light.intensity, dimmed), 3.4028235e38f)};
    return result;
}

/* What one light adds by Lambert's model: I k_d max(0, N.L). */
static inline shading_vec3 shading_shade_lambert(shading_vec3 n, shading_Material material,
        shading_Arrival light) {
    float n_dot_l = shading_dot(n, light.l);
    if (!(n_dot_l > 0.0f)) {
        return shading_vector(0.0f, 0.0f, 0.0f);
    }
    return shading_mul(shading_scale(light.i, shading_clamp(n_dot_l, 0.0f, 1.0f)), material.k_d);
}

/* What one light adds by Phong's model: I (k_d N.L + k_s max(0, R.V)^m), where N.L > 0. Phong 1975. */
static inline shading_vec3 shading_shade_phong(shading_vec3 n, shading_vec3 v, shading_Material material,
        shading_Arrival light) {
    float n_dot_l = shading_dot(n, light.l);
    if (!(n_dot_l > 0.0f)) {
        return shading_vector(0.0f, 0.0f, 0.0f);
    }
    shading_vec3 diffuse = shading_mul(shading_scale(light.i, shading_clamp(n_dot_l, 0.0f, 1.0f)),
            material.k_d);
    shading_vec3 r = shading_sub(shading_scale(n, n_dot_l + n_dot_l), light.l);
    float r_dot_v = shading_dot(r, v);
    float highlight = r_dot_v > 0.0f
            ? shading_power(shading_clamp(r_dot_v, 0.0f, 1.0f), shading_max(material.m, 0.0f)) : 0.0f;
    shading_vec3 specular = shading_mul(shading_scale(light.i, highlight), material.k_s);
    return shading_add(diffuse, specular);
}

/* What one light adds by Blinn and Phong's model: I (k_d N.L + k_s max(0, N.H)^m), where N.L > 0. Blinn 1977. */
static inline shading_vec3 shading_shade_blinn_phong(shading_vec3 n, shading_vec3 v,
        shading_Material material, shading_Arrival light) {
    float n_dot_l = shading_dot(n, light.l);
    if (!(n_dot_l > 0.0f)) {
        return shading_vector(0.0f, 0.0f, 0.0f);
    }
    shading_vec3 diffuse = shading_mul(shading_scale(light.i, shading_clamp(n_dot_l, 0.0f, 1.0f)),
            material.k_d);
    shading_vec3 h = shading_add(light.l, v);
    float n_dot_h = shading_dot(n, h);
    float highlight = n_dot_h > 0.0f
            ? shading_power_of_quotient(n_dot_h * n_dot_h, shading_dot(h, h),
            shading_max(0.5f * material.m, 0.0f)) : 0.0f;
    shading_vec3 specular = shading_mul(shading_scale(light.i, highlight), material.k_s);
    return shading_add(diffuse, specular);
}

/* The sums over lights after one more, by Lambert's model. A light from behind adds nothing and costs no root. */
static inline shading_Sums shading_add_lambert(shading_Sums sums, shading_vec3 n, shading_Light light,
        shading_vec3 p) {
    if (light.is_sun > 0.0f) {
        float n_dot_l = shading_dot(n, light.position);
        if (!(n_dot_l > 0.0f)) {
            return sums;
        }
        shading_Sums result = {shading_add(sums.diffuse,
                shading_scale(light.intensity, shading_clamp(n_dot_l, 0.0f, 1.0f))), sums.specular};
        return result;
    }
    shading_vec3 way = shading_sub(light.position, p);
    if (!(shading_dot(n, way) > 0.0f)) {
        return sums;
    }
    shading_Measured to_light = shading_measured(way);
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0f
            ? shading_spot(light, shading_dot(shading_neg(light.axis), to_light.w) / to_light.w_length)
            : 1.0f);
    shading_Sums result = {shading_add(sums.diffuse,
            shading_scale(light.intensity,
            dimmed * shading_clamp(shading_dot(n, to_light.w) / to_light.w_length, 0.0f, 1.0f))),
            sums.specular};
    return result;
}

/* The same by Phong's model. */
static inline shading_Sums shading_add_phong(shading_Sums sums, shading_vec3 n, shading_vec3 v, float m,
        shading_Light light, shading_vec3 p) {
    if (light.is_sun > 0.0f) {
        float n_dot_l = shading_dot(n, light.position);
        if (!(n_dot_l > 0.0f)) {
            return sums;
        }
        float r_dot_v = shading_dot(shading_sub(shading_scale(n, n_dot_l + n_dot_l), light.position), v);
        float highlight_of_sun = r_dot_v > 0.0f
                ? shading_power(shading_clamp(r_dot_v, 0.0f, 1.0f), shading_max(m, 0.0f)) : 0.0f;
        shading_Sums result = {shading_add(sums.diffuse,
                shading_scale(light.intensity, shading_clamp(n_dot_l, 0.0f, 1.0f))),
                shading_add(sums.specular, shading_scale(light.intensity, highlight_of_sun))};
        return result;
    }
    shading_vec3 way = shading_sub(light.position, p);
    if (!(shading_dot(n, way) > 0.0f)) {
        return sums;
    }
    shading_Measured to_light = shading_measured(way);
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0f
            ? shading_spot(light, shading_dot(shading_neg(light.axis), to_light.w) / to_light.w_length)
            : 1.0f);
    float n_dot_w = shading_dot(n, to_light.w);
    float cosine = shading_dot(shading_sub(shading_scale(n, n_dot_w + n_dot_w), to_light.w), v)
            / to_light.w_length;
    float highlight = cosine > 0.0f ? shading_power(shading_clamp(cosine, 0.0f, 1.0f), shading_max(m, 0.0f))
            : 0.0f;
    shading_Sums result = {shading_add(sums.diffuse,
            shading_scale(light.intensity, dimmed * shading_clamp(n_dot_w / to_light.w_length, 0.0f, 1.0f))),
            shading_add(sums.specular, shading_scale(light.intensity, dimmed * highlight))};
    return result;
}

/* The same by Blinn and Phong's model. */
static inline shading_Sums shading_add_blinn_phong(shading_Sums sums, shading_vec3 n, shading_vec3 v, float m,
        shading_Light light, shading_vec3 p) {
    if (light.is_sun > 0.0f) {
        float n_dot_l = shading_dot(n, light.position);
        if (!(n_dot_l > 0.0f)) {
            return sums;
        }
        shading_vec3 h = shading_add(light.position, v);
        float n_dot_h = shading_dot(n, h);
        float highlight_of_sun = n_dot_h > 0.0f
                ? shading_power_of_quotient(n_dot_h * n_dot_h, shading_dot(h, h), shading_max(0.5f * m, 0.0f))
                : 0.0f;
        shading_Sums result = {shading_add(sums.diffuse,
                shading_scale(light.intensity, shading_clamp(n_dot_l, 0.0f, 1.0f))),
                shading_add(sums.specular, shading_scale(light.intensity, highlight_of_sun))};
        return result;
    }
    shading_vec3 way = shading_sub(light.position, p);
    if (!(shading_dot(n, way) > 0.0f)) {
        return sums;
    }
    shading_Measured to_light = shading_measured(way);
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0f
            ? shading_spot(light, shading_dot(shading_neg(light.axis), to_light.w) / to_light.w_length)
            : 1.0f);
    shading_vec3 halfway = shading_add(to_light.w, shading_scale(v, to_light.w_length));
    float cosine = shading_dot(n, halfway);
    float highlight = cosine > 0.0f
            ? shading_power_of_quotient(cosine * cosine, shading_dot(halfway, halfway),
            shading_max(0.5f * m, 0.0f)) : 0.0f;
    shading_Sums result = {shading_add(sums.diffuse,
            shading_scale(light.intensity,
            dimmed * shading_clamp(shading_dot(n, to_light.w) / to_light.w_length, 0.0f, 1.0f))),
            shading_add(sums.specular, shading_scale(light.intensity, dimmed * highlight))};
    return result;
}

/* The light that the point reflects: k_a I_a + k_d times the diffuse sum + k_s times the specular one. */
static inline shading_vec3 shading_total(shading_Sums sums, shading_Material material, shading_vec3 i_a) {
    return shading_add(shading_add(shading_mul(material.k_a, i_a),
            shading_mul(shading_at_most(sums.diffuse, 3.4028235e38f), material.k_d)),
            shading_mul(shading_at_most(sums.specular, 3.4028235e38f), material.k_s));
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
        float least = shading_min(shading_min(abs_x > 0.0f ? x.v_length : 3.4028235e38f,
                abs_y > 0.0f ? y.v_length : 3.4028235e38f), abs_z > 0.0f ? z.v_length : 3.4028235e38f);
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

#endif
