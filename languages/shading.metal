// shading: Lambert, Phong and Blinn-Phong in linear light. MIT or Apache 2.0.
// Written by the package shading-languages from the source of the crate shading; do not edit it.
// All directions have length 1 and point away from the surface. A direction that does not exist is 0.
// Numbers are finite, and light, reflectances and the shininess m at least 0; then no result is NaN or negative light.

#ifndef SHADING_METAL
#define SHADING_METAL

#include <metal_stdlib>

namespace shading {
using namespace metal;

// A light of any kind. A sun has its direction L for a position; a lamp has the cosines -1.
struct Light {
    packed_float3 position;
    float is_sun;
    packed_float3 intensity;
    float limit;
    packed_float3 coefficients;
    float range;
    packed_float3 axis;
    float is_smoothstep;
    float2 cosines;
    float is_gltf;
    float padding_is_gltf;
};

// The reflectances of a surface, and its shininess m.
struct Material {
    packed_float3 k_a;
    float m;
    packed_float3 k_d;
    float padding_k_d;
    packed_float3 k_s;
    float padding_k_s;
};

// What arrives at a point from one light: L, the distance q and I.
struct Arrival {
    float3 l;
    float q;
    float3 i;
};

// The sums over lights of I max(0, N.L) and of I times the highlight. They begin as 0.
struct Sums {
    float3 diffuse;
    float3 specular;
};

// The tangent t of a triangle with texture coordinates, and its handedness h.
struct Tangent {
    float3 t;
    float h;
};

// A vector w of the direction of another, whose square is in range, |w|, and the length of the other.
struct Measured {
    float3 w;
    float w_length;
    float length;
};

// Whether a square is so small or large that it is not exact.
inline bool is_extreme(float square) {
    return !(square >= 7.888609e-31f && square < 1.2676506e30f);
}

#ifdef SHADING_EXACT_POWER

// e of x = 2^e z, where z is within [least, 2 least).
inline float exponent(float x, float least) {
    return float((as_type<int>(x) - as_type<int>(least)) >> 23);
}

// z of x = 2^e z.
inline float significand(float x, float least) {
    int above = as_type<int>(x) - as_type<int>(least);
    return as_type<float>(as_type<int>(x) - (above & -0x800000));
}

// 2^(n - 127) for the low byte n of the bits of x.
inline float two_to_low_bits(float x) {
    return as_type<float>(as_type<int>(x) << 23);
}

// How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart.
inline float steps_above(float x, float shift) {
    return float(as_type<int>(x) - as_type<int>(shift));
}

// (c/d)^m for c/d within [0, 1] and m >= 0, by the crate's own logarithm: within 2^-22.
inline float power_of_quotient(float c, float d, float m) {
    float t1 = c * 16777216.0f;
    float t2 = d * 11863283.0f;
    float t3 = significand(t1, t2);
    float t4 = d * 16777216.0f;
    float t5 = (t3 - t4) / (t3 + t4);
    float t6 = t5 * t5;
    float t7 = max(min(m * (exponent(t1, t2) + t5 * (2.8853905f + t6 * 0.9615518f + t6 * t6 * 0.59732693f)),
            0.0f), -126.0f);
    float t8 = t7 + 12583038.0f;
    float t9 = t7 - steps_above(t8, 12583038.0f);
    float t10 = t9 * t9;
    return (2.0f + t9 + t9 * (0.38629442f + 0.4804531f * t9 + t10 * (0.111006565f + 0.019235516f * t9) + t10
            * t10 * (0.0026797508f + 0.00031013472f * t9))) * two_to_low_bits(t8);
}

// c^m for c within [0, 1] and m >= 0, within 2^-22.
inline float power(float c, float m) {
    float t1 = c * 16777216.0f;
    float t2 = significand(t1, 11863283.0f);
    float t3 = (t2 - 16777216.0f) / (t2 + 16777216.0f);
    float t4 = t3 * t3;
    float t5 = max(m * (exponent(t1, 11863283.0f) + t3
            * (2.8853905f + t4 * 0.9615518f + t4 * t4 * 0.59732693f)), -126.0f);
    float t6 = t5 + 12583038.0f;
    float t7 = t5 - steps_above(t6, 12583038.0f);
    float t8 = t7 * t7;
    return (2.0f + t7 + t7 * (0.38629442f + 0.4804531f * t7 + t8 * (0.111006565f + 0.019235516f * t7) + t8
            * t8 * (0.0026797508f + 0.00031013472f * t7))) * two_to_low_bits(t6);
}

#else

// (c/d)^m for c/d within [0, by the language's own power.
inline float power_of_quotient(float c, float d, float m) {
    return pow(min(c / d, 1.0f), m);
}

// c^m for c within [0, by the language's own power.
inline float power(float c, float m) {
    return pow(c, m);
}

#endif

// The length of v, and w in its direction: v itself, or v times a power of 2 where its square is out of range.
inline Measured measured(float3 v) {
    float square = dot(v, v);
    if (is_extreme(square)) {
        float t1 = square < 1.2676506e30f ? (square < 7.888609e-31f ? 1.2676506e30f : 1.0f) : 7.888609e-31f;
        float3 t2 = v * min(t1, 1.0f) * max(t1, 1.0f);
        float t2_dot_t2 = dot(t2, t2);
        float t3 = sqrt(t2_dot_t2);
        Measured result = {t2, t2_dot_t2 > 0.0f && t2_dot_t2 < 3.4028235e38f ? t3 : 0.0f,
                t2_dot_t2 > 0.0f && t2_dot_t2 < 3.4028235e38f ? min(t3 / t1, 3.4028235e38f) : t3};
        return result;
    }
    float t1 = sqrt(square);
    Measured result = {v, t1, t1};
    return result;
}

// v/|v|; 0 where v is 0.
inline float3 unit(float3 v) {
    Measured of = measured(v);
    return of.w_length > 0.0f ? of.w / of.w_length : float3(0.0f);
}

// The vector from a point to another, times a power of 2 where its square is out of range.
inline float3 between(float3 origin, float3 p) {
    float3 v = p - origin;
    float square = dot(v, v);
    if (is_extreme(square)) {
        float t1 = square < 1.2676506e30f ? (square < 7.888609e-31f ? 1.2676506e30f : 1.0f) : 7.888609e-31f;
        float t2 = min(t1, 1.0f);
        return (p * t2 - origin * t2) * max(t1, 1.0f);
    }
    return v;
}

// (a - origin) x (b - origin), in the right direction even where its square is out of range.
inline float3 crossed(float3 origin, float3 a, float3 b) {
    float3 c = cross(a - origin, b - origin);
    if (is_extreme(dot(c, c))) {
        return cross(between(origin, a), between(origin, b));
    }
    return c;
}

// The reflection vector R = 2(N.L)N - L. Phong 1975; Foley, van Dam et al. 16.1.
inline float3 reflection(float3 n, float3 l) {
    float n_dot_l = dot(n, l);
    return n * (n_dot_l + n_dot_l) - l;
}

// The half vector H = (L + V)/|L + V|; 0 where L = -V. Blinn 1977.
inline float3 half_vector(float3 l, float3 v) {
    return unit(l + v);
}

// The ambient term k_a I_a. Foley, van Dam et al. 16.1.
inline float3 term_ambient(float3 k_a, float3 i_a) {
    return k_a * i_a;
}

// Lambert's factor max(0, N.L). Lambert 1760.
inline float term_lambert(float3 n, float3 l) {
    return max(dot(n, l), 0.0f);
}

// Phong's highlight max(0, R.V)^m. Phong 1975.
inline float term_phong(float3 r, float3 v, float m) {
    float r_dot_v = dot(r, v);
    return r_dot_v > 0.0f ? power(clamp(r_dot_v, 0.0f, 1.0f), max(m, 0.0f)) : 0.0f;
}

// Blinn's highlight max(0, N.H)^m. Blinn 1977.
inline float term_blinn(float3 n, float3 h, float m) {
    float n_dot_h = dot(n, h);
    return n_dot_h > 0.0f ? power(clamp(n_dot_h, 0.0f, 1.0f), max(m, 0.0f)) : 0.0f;
}

// What makes Phong's highlight reflect at most k_s: (m + 2)/(2 pi). Lafortune and Willems 1994.
inline float term_phong_normalization(float m) {
    return (max(m, 0.0f) + 2.0f) * 0.15915494f;
}

// The same of Blinn's: (m + 2)(m + 4)/(8 pi (2^(-m/2) + m)). Giesen 2009.
inline float term_blinn_normalization(float m) {
    float exponent = max(m, 0.0f);
    return (exponent + 2.0f) * 0.039788734f
            * ((exponent + 4.0f) / (exponent + power(0.70710677f, max(exponent, 0.0f))));
}

// The attenuation 1/(a + bq + cq^2). Foley, van Dam et al. 16.1; OpenGL 2.1, 2.14.1.
inline float attenuation(float a, float b, float c, float q) {
    return clamp(1.0f / (a + q * (b + c * q)), 0.0f, 3.4028235e38f);
}

// What ends a light at the range r: max(0, 1 - (q/r)^4)^2. Karis 2013.
inline float window(float q, float r) {
    float fraction = q / r;
    float square = fraction * fraction;
    float root = max(1.0f - square * square, 0.0f);
    return root * root;
}

// The same without the square: KHR_lights_punctual.
inline float window_gltf(float q, float r) {
    float fraction = q / r;
    float square = fraction * fraction;
    return max(1.0f - square * square, 0.0f);
}

// t^2, where t rises from 0 at the cosine of the outer edge to 1 at that of the inner. KHR_lights_punctual.
inline float beam(float cosine, float inner, float outer) {
    if (!(inner > outer)) {
        return inner > cosine ? 0.0f : 1.0f;
    }
    float t = clamp((cosine - outer) / (inner - outer), 0.0f, 1.0f);
    return inner > cosine ? t * t : 1.0f;
}

// The same with t^2(3 - 2t). POV-Ray 3.7.
inline float beam_smoothstep(float cosine, float inner, float outer) {
    if (!(inner > outer)) {
        return inner > cosine ? 0.0f : 1.0f;
    }
    float t = clamp((cosine - outer) / (inner - outer), 0.0f, 1.0f);
    return inner > cosine ? min(t * t * (3.0f - (t + t)), 1.0f) : 1.0f;
}

// The factor of a spot's cone, given the cosines of its inner and its outer half-angle.
inline float cone(float3 axis, float3 l, float2 cosines) {
    return beam(dot(-axis, l), cosines.x < -0.9999995f ? -2.0f : min(cosines.x, 0.9999995f),
            cosines.x < -0.9999995f ? -2.0f : min(cosines.y, 0.9999995f));
}

// The same with a smoothstep between the edges.
inline float cone_smoothstep(float3 axis, float3 l, float2 cosines) {
    return beam_smoothstep(dot(-axis, l), cosines.x < -0.9999995f ? -2.0f : min(cosines.x, 0.9999995f),
            cosines.x < -0.9999995f ? -2.0f : min(cosines.y, 0.9999995f));
}

// What arrives at the point p: L, the distance q and I. Foley, van Dam et al. 16.1.
inline Arrival arrival(Light light, float3 p) {
    if (light.is_sun > 0.0f) {
        Arrival result = {light.position, 3.4028235e38f, light.intensity};
        return result;
    }
    Measured to_light = measured(light.position - p);
    float t1 = dot(-light.axis, to_light.w) / to_light.w_length;
    float t2 = light.cosines.x < -0.9999995f ? -2.0f : min(light.cosines.x, 0.9999995f);
    float t3 = light.cosines.x < -0.9999995f ? -2.0f : min(light.cosines.y, 0.9999995f);
    Arrival result = {to_light.w_length > 0.0f ? to_light.w / to_light.w_length : float3(0.0f, 0.0f, 1.0f),
            min(to_light.length, 3.4028235e38f),
            min(light.intensity * (to_light.w_length > 0.0f
            ? clamp(1.0f / (light.coefficients.x + to_light.length
            * (light.coefficients.y + light.coefficients.z * to_light.length)), 0.0f, light.limit)
            * (light.range < 3.4028235e38f
            ? (light.is_gltf > 0.0f ? window_gltf(to_light.length, light.range)
            : window(to_light.length, light.range)) : 1.0f)
            * (light.cosines.x > -1.0f
            ? (light.is_smoothstep > 0.0f ? beam_smoothstep(t1, t2, t3) : beam(t1, t2, t3)) : 1.0f) : 0.0f),
            float3(3.4028235e38f))};
    return result;
}

// What one light adds by Lambert's model: I k_d max(0, N.L).
inline float3 shade_lambert(float3 n, Material material, Arrival light) {
    float n_dot_l = dot(n, light.l);
    if (!(n_dot_l > 0.0f)) {
        return float3(0.0f);
    }
    return light.i * clamp(n_dot_l, 0.0f, 1.0f) * material.k_d;
}

// What one light adds by Phong's model: I (k_d N.L + k_s max(0, R.V)^m), where N.L > 0. Phong 1975.
inline float3 shade_phong(float3 n, float3 v, Material material, Arrival light) {
    float n_dot_l = dot(n, light.l);
    if (!(n_dot_l > 0.0f)) {
        return float3(0.0f);
    }
    float3 r = n * (n_dot_l + n_dot_l) - light.l;
    float r_dot_v = dot(r, v);
    return light.i * clamp(n_dot_l, 0.0f, 1.0f) * material.k_d + light.i
            * (r_dot_v > 0.0f ? power(clamp(r_dot_v, 0.0f, 1.0f), max(material.m, 0.0f)) : 0.0f)
            * material.k_s;
}

// What one light adds by Blinn and Phong's model: I (k_d N.L + k_s max(0, N.H)^m), where N.L > 0. Blinn 1977.
inline float3 shade_blinn_phong(float3 n, float3 v, Material material, Arrival light) {
    float n_dot_l = dot(n, light.l);
    if (!(n_dot_l > 0.0f)) {
        return float3(0.0f);
    }
    float3 h = light.l + v;
    float n_dot_h = dot(n, h);
    return light.i * clamp(n_dot_l, 0.0f, 1.0f) * material.k_d + light.i
            * (n_dot_h > 0.0f ? power_of_quotient(n_dot_h * n_dot_h, dot(h, h), max(0.5f * material.m, 0.0f))
            : 0.0f) * material.k_s;
}

// The sums over lights after one more, by Lambert's model. A light from behind adds nothing and costs no root.
inline Sums add_lambert(Sums sums, float3 n, Light light, float3 p) {
    if (light.is_sun > 0.0f) {
        float t1 = dot(n, light.position);
        if (!(t1 > 0.0f)) {
            Sums result = {sums.diffuse, sums.specular};
            return result;
        }
        Sums result = {sums.diffuse + light.intensity * clamp(t1, 0.0f, 1.0f), sums.specular};
        return result;
    }
    float3 t1 = light.position - p;
    if (!(dot(n, t1) > 0.0f)) {
        Sums result = {sums.diffuse, sums.specular};
        return result;
    }
    Measured t2 = measured(t1);
    float t3 = dot(-light.axis, t2.w) / t2.w_length;
    float t4 = light.cosines.x < -0.9999995f ? -2.0f : min(light.cosines.x, 0.9999995f);
    float t5 = light.cosines.x < -0.9999995f ? -2.0f : min(light.cosines.y, 0.9999995f);
    Sums result = {sums.diffuse + light.intensity
            * (clamp(1.0f / (light.coefficients.x + t2.length
            * (light.coefficients.y + light.coefficients.z * t2.length)), 0.0f, light.limit)
            * (light.range < 3.4028235e38f
            ? (light.is_gltf > 0.0f ? window_gltf(t2.length, light.range) : window(t2.length, light.range))
            : 1.0f) * (light.cosines.x > -1.0f
            ? (light.is_smoothstep > 0.0f ? beam_smoothstep(t3, t4, t5) : beam(t3, t4, t5)) : 1.0f)
            * clamp(dot(n, t2.w) / t2.w_length, 0.0f, 1.0f)), sums.specular};
    return result;
}

// The same by Phong's model.
inline Sums add_phong(Sums sums, float3 n, float3 v, float m, Light light, float3 p) {
    if (light.is_sun > 0.0f) {
        float t1 = dot(n, light.position);
        if (!(t1 > 0.0f)) {
            Sums result = {sums.diffuse, sums.specular};
            return result;
        }
        float t2 = dot(n * (t1 + t1) - light.position, v);
        Sums result = {sums.diffuse + light.intensity * clamp(t1, 0.0f, 1.0f), sums.specular + light.intensity
                * (t2 > 0.0f ? power(clamp(t2, 0.0f, 1.0f), max(m, 0.0f)) : 0.0f)};
        return result;
    }
    float3 t1 = light.position - p;
    if (!(dot(n, t1) > 0.0f)) {
        Sums result = {sums.diffuse, sums.specular};
        return result;
    }
    Measured t2 = measured(t1);
    float t3 = dot(-light.axis, t2.w) / t2.w_length;
    float t4 = light.cosines.x < -0.9999995f ? -2.0f : min(light.cosines.x, 0.9999995f);
    float t5 = light.cosines.x < -0.9999995f ? -2.0f : min(light.cosines.y, 0.9999995f);
    float t6 = clamp(1.0f / (light.coefficients.x + t2.length
            * (light.coefficients.y + light.coefficients.z * t2.length)), 0.0f, light.limit)
            * (light.range < 3.4028235e38f
            ? (light.is_gltf > 0.0f ? window_gltf(t2.length, light.range) : window(t2.length, light.range))
            : 1.0f) * (light.cosines.x > -1.0f
            ? (light.is_smoothstep > 0.0f ? beam_smoothstep(t3, t4, t5) : beam(t3, t4, t5)) : 1.0f);
    float t7 = dot(n, t2.w);
    float t8 = dot(n * (t7 + t7) - t2.w, v) / t2.w_length;
    Sums result = {sums.diffuse + light.intensity * (t6 * clamp(t7 / t2.w_length, 0.0f, 1.0f)), sums.specular
            + light.intensity * (t6 * (t8 > 0.0f ? power(clamp(t8, 0.0f, 1.0f), max(m, 0.0f)) : 0.0f))};
    return result;
}

// The same by Blinn and Phong's model.
inline Sums add_blinn_phong(Sums sums, float3 n, float3 v, float m, Light light, float3 p) {
    if (light.is_sun > 0.0f) {
        float t1 = dot(n, light.position);
        if (!(t1 > 0.0f)) {
            Sums result = {sums.diffuse, sums.specular};
            return result;
        }
        float3 t2 = light.position + v;
        float n_dot_t2 = dot(n, t2);
        Sums result = {sums.diffuse + light.intensity * clamp(t1, 0.0f, 1.0f), sums.specular + light.intensity
                * (n_dot_t2 > 0.0f ? power_of_quotient(n_dot_t2 * n_dot_t2, dot(t2, t2), max(0.5f * m, 0.0f))
                : 0.0f)};
        return result;
    }
    float3 t1 = light.position - p;
    if (!(dot(n, t1) > 0.0f)) {
        Sums result = {sums.diffuse, sums.specular};
        return result;
    }
    Measured t2 = measured(t1);
    float t3 = dot(-light.axis, t2.w) / t2.w_length;
    float t4 = light.cosines.x < -0.9999995f ? -2.0f : min(light.cosines.x, 0.9999995f);
    float t5 = light.cosines.x < -0.9999995f ? -2.0f : min(light.cosines.y, 0.9999995f);
    float t6 = clamp(1.0f / (light.coefficients.x + t2.length
            * (light.coefficients.y + light.coefficients.z * t2.length)), 0.0f, light.limit)
            * (light.range < 3.4028235e38f
            ? (light.is_gltf > 0.0f ? window_gltf(t2.length, light.range) : window(t2.length, light.range))
            : 1.0f) * (light.cosines.x > -1.0f
            ? (light.is_smoothstep > 0.0f ? beam_smoothstep(t3, t4, t5) : beam(t3, t4, t5)) : 1.0f);
    float3 t7 = t2.w + v * t2.w_length;
    float n_dot_t7 = dot(n, t7);
    Sums result = {sums.diffuse + light.intensity * (t6 * clamp(dot(n, t2.w) / t2.w_length, 0.0f, 1.0f)),
            sums.specular + light.intensity
            * (t6 * (n_dot_t7 > 0.0f ? power_of_quotient(n_dot_t7 * n_dot_t7, dot(t7, t7),
            max(0.5f * m, 0.0f)) : 0.0f))};
    return result;
}

// The light that the point reflects: k_a I_a + k_d times the diffuse sum + k_s times the specular one.
inline float3 total(Sums sums, Material material, float3 i_a) {
    return material.k_a * i_a + min(sums.diffuse, float3(3.4028235e38f)) * material.k_d
            + min(sums.specular, float3(3.4028235e38f)) * material.k_s;
}

// The normal of the plane ax + by + cz + d = 0: (a, b, c)/|(a, b, c)|. Foley, van Dam et al. 11.1.3.
inline float3 normal_plane(float a, float b, float c) {
    return unit(float3(a, b, c));
}

// The normal of a triangle, counter-clockwise: (v2 - v1) x (v3 - v1), length 1. Foley, van Dam et al. 11.1.3.
inline float3 normal_triangle(float3 v1, float3 v2, float3 v3) {
    return unit(crossed(v1, v2, v3));
}

// The normal of a sphere: (p - center)/|p - center|. Foley, van Dam et al. 15.10.1.
inline float3 normal_sphere(float3 center, float3 p) {
    return unit(between(center, p));
}

// The normal of f(p) = 0 by the gradient of f, length 1. Foley, van Dam et al. 11.4.
inline float3 normal_from_gradient(float3 gradient) {
    return unit(gradient);
}

// The normal of s(u, v): ds/du x ds/dv, length 1. Foley, van Dam et al. 11.3.4.
inline float3 normal_from_tangents(float3 s_u, float3 s_v) {
    return unit(crossed(float3(0.0f), s_u, s_v));
}

// N toward the eye: N if F.V >= 0, else -N, where F is the normal of the face. GLSL 4.60, 8.5.
inline float3 normal_facing(float3 n, float3 v, float3 f) {
    return dot(-f, v) > 0.0f ? -n : n;
}

// A normal transformed by the matrix of the columns a, b, c: cof(M) N, length 1. Lengyel 2024.
inline float3 normal_transformed(float3 n, float3 a, float3 b, float3 c) {
    if (is_extreme(dot(a, a)) || is_extreme(dot(b, b)) || is_extreme(dot(c, c))) {
        float3 t1 = unit(b) + b * 0.0f;
        float3 t2 = unit(c) + c * 0.0f;
        float t3 = abs(n.x);
        Measured t4 = measured(a);
        float t5 = abs(n.y);
        Measured t6 = measured(b);
        float t7 = abs(n.z);
        Measured t8 = measured(c);
        float t9 = min(min(t3 > 0.0f ? t4.length : 3.4028235e38f, t5 > 0.0f ? t6.length : 3.4028235e38f),
                t7 > 0.0f ? t8.length : 3.4028235e38f);
        float3 t10 = unit(a) + a * 0.0f;
        return unit(cross(t1, t2) * (t3 > 0.0f ? n.x * (t4.length > t9 ? t9 / t4.length : 1.0f) : 0.0f)
                + cross(t2, t10) * (t5 > 0.0f ? n.y * (t6.length > t9 ? t9 / t6.length : 1.0f) : 0.0f)
                + cross(t10, t1) * (t7 > 0.0f ? n.z * (t8.length > t9 ? t9 / t8.length : 1.0f) : 0.0f));
    }
    return unit(cross(b, c) * n.x + cross(c, a) * n.y + cross(a, b) * n.z);
}

// A triangle's normal times its angle at v1, to be summed over a mesh. Thuermer and Wuethrich 1998.
inline float3 normal_corner(float3 v1, float3 v2, float3 v3) {
    float3 t1 = between(v1, v2);
    float3 t2 = between(v1, v3);
    Measured t3 = measured(cross(t1, t2));
    float t1_dot_t2 = dot(t1, t2);
    float t4 = abs(t1_dot_t2);
    float t5 = t4 * 2.4142137f > t3.length ? (t1_dot_t2 > 0.0f ? 1.0f : -1.0f) : 0.0f;
    float t6 = t3.length > t4 * 0.41421357f ? 1.0f : 0.0f;
    float t7 = (t5 * t3.length - t6 * t1_dot_t2) / (t5 * t1_dot_t2 + t6 * t3.length);
    float t8 = t7 * t7;
    float t9 = t8 * t8;
    float t10 = t9 * t9;
    return (t3.w_length > 0.0f ? t3.w / t3.w_length : float3(0.0f))
            * max(1.5707964f - t5 * (1.5707964f - t6 * 0.7853982f)
            + (t7 + t7 * (t8 * (-0.33333334f + t8 * 0.2f + t9 * (-0.14285715f + t8 * 0.111111104f) + t10
            * (-0.0909089f + t8 * 0.07691945f + t9 * (-0.06661951f + t8 * 0.05840374f) + t10
            * (-0.050085507f + t8 * 0.03734732f + t9 * -0.01718003f))))), 0.0f);
}

// The tangent of a triangle and its handedness, by the texture coordinates of its vertices. Lengyel 2001.
inline Tangent normal_tangent(float3 v1, float3 v2, float3 v3, float2 uv1, float2 uv2, float2 uv3) {
    float3 t1 = v1 * 0.5f;
    float3 t2 = v2 * 0.5f - t1;
    float3 t3 = v3 * 0.5f - t1;
    float t4 = max(measured(t2).length, measured(t3).length);
    float t5 = uv1.y * 0.5f;
    float t6 = uv3.y * 0.5f - t5;
    float t7 = uv2.y * 0.5f - t5;
    float t8 = max(abs(t7), abs(t6));
    float t9 = t6 / t8;
    float t10 = t7 / t8;
    float t11 = uv1.x * 0.5f;
    float t12 = uv2.x * 0.5f - t11;
    float t13 = uv3.x * 0.5f - t11;
    float t14 = max(abs(t12), abs(t13));
    float t15 = t12 / t14 * t9 - t13 / t14 * t10;
    float t16 = t15 > 0.0f ? 1.0f : -1.0f;
    Measured t17 = measured((t2 / t4 * t9 - t3 / t4 * t10) * t16);
    if (!(t17.w_length > 0.0f && abs(t15) > 0.0f)) {
        Tangent result = {float3(0.0f), 0.0f};
        return result;
    }
    Tangent result = {t17.w / t17.w_length, t16};
    return result;
}

// A normal from a map: x t + y b + z N, length 1. glTF 2.0, 3.7.2.1.
inline float3 normal_mapped(float3 n, float3 tangent, float h, float3 s) {
    Measured t1 = measured(crossed(float3(0.0f), n, tangent));
    Measured t2 = measured(s);
    if (!(t1.w_length > 0.0f && t2.w_length > 0.0f)) {
        return float3(0.0f);
    }
    float3 t3 = t1.w / t1.w_length;
    return unit(cross(t3, n) * (t2.w.x / t2.w_length) + t3 * (h > 0.0f ? 1.0f : -1.0f)
            * (t2.w.y / t2.w_length) + n * (t2.w.z / t2.w_length));
}

} // namespace shading
#endif
