// shading: Lambert, Phong and Blinn-Phong in linear light. MIT or Apache 2.0.
// Written by the package shading-languages from the source of the crate shading; do not edit it.
// All directions have length 1 and point away from the surface. A direction that does not exist is 0.
// Numbers are finite, and light, reflectances and the shininess m at least 0; then no result is NaN or negative light.
// Tried with 820,000 calls and numbers from 1e-45 to 1e38, compiled as C++, not by a compiler for Metal:
// with the crate's own power, 0.998 of the results were the crate's; with the language's, 0.995.

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
    float v_length;
};

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
    float scaled = c * 16777216.0f;
    float least = d * 11863283.0f;
    float z = significand(scaled, least);
    float one = d * 16777216.0f;
    float s = (z - one) / (z + one);
    float s2 = s * s;
    float log2 = exponent(scaled, least) + s * (2.8853905f + s2 * 0.9615518f + s2 * s2 * 0.59732693f);
    float y = max(min(m * log2, 0.0f), -126.0f);
    float shifted = y + 12583038.0f;
    float r = y - steps_above(shifted, 12583038.0f);
    float r2 = r * r;
    float q = 0.38629442f + 0.4804531f * r + r2 * (0.111006565f + 0.019235516f * r) + r2 * r2
            * (0.0026797508f + 0.00031013472f * r);
    return (2.0f + r + r * q) * two_to_low_bits(shifted);
}

// c^m for c within [0, 1] and m >= 0, within 2^-22.
inline float power(float c, float m) {
    float scaled = c * 16777216.0f;
    float z = significand(scaled, 11863283.0f);
    float s = (z - 16777216.0f) / (z + 16777216.0f);
    float s2 = s * s;
    float log2 = exponent(scaled, 11863283.0f) + s * (2.8853905f + s2 * 0.9615518f + s2 * s2 * 0.59732693f);
    float y = max(m * log2, -126.0f);
    float shifted = y + 12583038.0f;
    float r = y - steps_above(shifted, 12583038.0f);
    float r2 = r * r;
    float q = 0.38629442f + 0.4804531f * r + r2 * (0.111006565f + 0.019235516f * r) + r2 * r2
            * (0.0026797508f + 0.00031013472f * r);
    return (2.0f + r + r * q) * two_to_low_bits(shifted);
}

#else

// (c/d)^m for c/d within [0, 1] and m >= 0, by the language's own power.
inline float power_of_quotient(float c, float d, float m) {
    return pow(min(c / d, 1.0f), m);
}

// c^m for c within [0, 1] and m >= 0, by the language's own power.
inline float power(float c, float m) {
    return pow(c, m);
}

#endif

// Whether a square is so small or large that it is not exact.
inline bool is_extreme(float square) {
    return !(square >= 7.888609e-31f && square < 1.2676506e30f);
}

// The length of v, and w in its direction: v itself, or v times a power of 2 where its square is out of range.
inline Measured measured(float3 v) {
    float square = dot(v, v);
    if (is_extreme(square)) {
        float power = square < 1.2676506e30f ? (square < 7.888609e-31f ? 1.2676506e30f : 1.0f)
                : 7.888609e-31f;
        float3 w = v * min(power, 1.0f) * max(power, 1.0f);
        float w_square = dot(w, w);
        float root = sqrt(w_square);
        Measured result = {w, w_square > 0.0f && w_square < 3.4028234e38f ? root : 0.0f,
                w_square > 0.0f && w_square < 3.4028234e38f ? min(root / power, 3.4028234e38f) : root};
        return result;
    }
    float length = sqrt(square);
    Measured result = {v, length, length};
    return result;
}

// v/|v|; 0 where v is 0.
inline float3 unit(float3 v) {
    Measured way = measured(v);
    return way.w_length > 0.0f ? way.w / way.w_length : float3(0.0f);
}

// The vector from a point to another, times a power of 2 where its square is out of range.
inline float3 between(float3 origin, float3 p) {
    float3 v = p - origin;
    float square = dot(v, v);
    if (is_extreme(square)) {
        float power = square < 1.2676506e30f ? (square < 7.888609e-31f ? 1.2676506e30f : 1.0f)
                : 7.888609e-31f;
        float shrink = min(power, 1.0f);
        return (p * shrink - origin * shrink) * max(power, 1.0f);
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
    return clamp(1.0f / (a + q * (b + c * q)), 0.0f, 3.4028234e38f);
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
    float inner = cosines.x < -0.9999995f ? -2.0f : min(cosines.x, 0.9999995f);
    float outer = cosines.x < -0.9999995f ? -2.0f : min(cosines.y, 0.9999995f);
    return beam(dot(-axis, l), inner, outer);
}

// The same with a smoothstep between the edges.
inline float cone_smoothstep(float3 axis, float3 l, float2 cosines) {
    float cosine = dot(-axis, l);
    float inner = cosines.x < -0.9999995f ? -2.0f : min(cosines.x, 0.9999995f);
    float outer = cosines.x < -0.9999995f ? -2.0f : min(cosines.y, 0.9999995f);
    return beam_smoothstep(cosine, inner, outer);
}

// What dims a light after the distance q: its attenuation, at most its limit, and the window of its range.
inline float falloff(Light light, float q) {
    return clamp(1.0f / (light.coefficients.x + q * (light.coefficients.y + light.coefficients.z * q)), 0.0f,
            light.limit) * (light.range < 3.4028234e38f
            ? (light.is_gltf > 0.0f ? window_gltf(q, light.range) : window(q, light.range)) : 1.0f);
}

// The factor of a spot's cone, by the cosine between its axis and -L.
inline float spot(Light light, float cosine) {
    float inner = light.cosines.x < -0.9999995f ? -2.0f : min(light.cosines.x, 0.9999995f);
    float outer = light.cosines.x < -0.9999995f ? -2.0f : min(light.cosines.y, 0.9999995f);
    return light.is_smoothstep > 0.0f ? beam_smoothstep(cosine, inner, outer) : beam(cosine, inner, outer);
}

// What arrives at the point p: L, the distance q and I. Foley, van Dam et al. 16.1.
inline Arrival arrival(Light light, float3 p) {
    if (light.is_sun > 0.0f) {
        Arrival result = {light.position, 3.4028234e38f, light.intensity};
        return result;
    }
    Measured to_light = measured(light.position - p);
    if (!(to_light.w_length > 0.0f)) {
        Arrival result = {float3(0.0f, 0.0f, 1.0f), min(to_light.v_length, 3.4028234e38f), float3(0.0f)};
        return result;
    }
    float dimmed = falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0f ? spot(light, dot(-light.axis, to_light.w) / to_light.w_length)
            : 1.0f);
    Arrival result = {to_light.w / to_light.w_length, min(to_light.v_length, 3.4028234e38f),
            min(light.intensity * dimmed, float3(3.4028234e38f))};
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
    float3 diffuse = light.i * clamp(n_dot_l, 0.0f, 1.0f) * material.k_d;
    float3 r = n * (n_dot_l + n_dot_l) - light.l;
    float r_dot_v = dot(r, v);
    float highlight = r_dot_v > 0.0f ? power(clamp(r_dot_v, 0.0f, 1.0f), max(material.m, 0.0f)) : 0.0f;
    float3 specular = light.i * highlight * material.k_s;
    return diffuse + specular;
}

// What one light adds by Blinn and Phong's model: I (k_d N.L + k_s max(0, N.H)^m), where N.L > 0. Blinn 1977.
inline float3 shade_blinn_phong(float3 n, float3 v, Material material, Arrival light) {
    float n_dot_l = dot(n, light.l);
    if (!(n_dot_l > 0.0f)) {
        return float3(0.0f);
    }
    float3 diffuse = light.i * clamp(n_dot_l, 0.0f, 1.0f) * material.k_d;
    float3 h = light.l + v;
    float n_dot_h = dot(n, h);
    float highlight = n_dot_h > 0.0f
            ? power_of_quotient(n_dot_h * n_dot_h, dot(h, h), max(0.5f * material.m, 0.0f)) : 0.0f;
    float3 specular = light.i * highlight * material.k_s;
    return diffuse + specular;
}

// The sums over lights after one more, by Lambert's model. A light from behind adds nothing and costs no root.
inline Sums add_lambert(Sums sums, float3 n, Light light, float3 p) {
    if (light.is_sun > 0.0f) {
        float n_dot_l = dot(n, light.position);
        if (!(n_dot_l > 0.0f)) {
            return sums;
        }
        Sums result = {sums.diffuse + light.intensity * clamp(n_dot_l, 0.0f, 1.0f), sums.specular};
        return result;
    }
    float3 way = light.position - p;
    if (!(dot(n, way) > 0.0f)) {
        return sums;
    }
    Measured to_light = measured(way);
    float dimmed = falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0f ? spot(light, dot(-light.axis, to_light.w) / to_light.w_length)
            : 1.0f);
    Sums result = {sums.diffuse + light.intensity
            * (dimmed * clamp(dot(n, to_light.w) / to_light.w_length, 0.0f, 1.0f)), sums.specular};
    return result;
}

// The same by Phong's model.
inline Sums add_phong(Sums sums, float3 n, float3 v, float m, Light light, float3 p) {
    if (light.is_sun > 0.0f) {
        float n_dot_l = dot(n, light.position);
        if (!(n_dot_l > 0.0f)) {
            return sums;
        }
        float r_dot_v = dot(n * (n_dot_l + n_dot_l) - light.position, v);
        float highlight_of_sun = r_dot_v > 0.0f ? power(clamp(r_dot_v, 0.0f, 1.0f), max(m, 0.0f)) : 0.0f;
        Sums result = {sums.diffuse + light.intensity * clamp(n_dot_l, 0.0f, 1.0f),
                sums.specular + light.intensity * highlight_of_sun};
        return result;
    }
    float3 way = light.position - p;
    if (!(dot(n, way) > 0.0f)) {
        return sums;
    }
    Measured to_light = measured(way);
    float dimmed = falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0f ? spot(light, dot(-light.axis, to_light.w) / to_light.w_length)
            : 1.0f);
    float n_dot_w = dot(n, to_light.w);
    float cosine = dot(n * (n_dot_w + n_dot_w) - to_light.w, v) / to_light.w_length;
    float highlight = cosine > 0.0f ? power(clamp(cosine, 0.0f, 1.0f), max(m, 0.0f)) : 0.0f;
    Sums result = {sums.diffuse + light.intensity * (dimmed * clamp(n_dot_w / to_light.w_length, 0.0f, 1.0f)),
            sums.specular + light.intensity * (dimmed * highlight)};
    return result;
}

// The same by Blinn and Phong's model.
inline Sums add_blinn_phong(Sums sums, float3 n, float3 v, float m, Light light, float3 p) {
    if (light.is_sun > 0.0f) {
        float n_dot_l = dot(n, light.position);
        if (!(n_dot_l > 0.0f)) {
            return sums;
        }
        float3 h = light.position + v;
        float n_dot_h = dot(n, h);
        float highlight_of_sun = n_dot_h > 0.0f
                ? power_of_quotient(n_dot_h * n_dot_h, dot(h, h), max(0.5f * m, 0.0f)) : 0.0f;
        Sums result = {sums.diffuse + light.intensity * clamp(n_dot_l, 0.0f, 1.0f),
                sums.specular + light.intensity * highlight_of_sun};
        return result;
    }
    float3 way = light.position - p;
    if (!(dot(n, way) > 0.0f)) {
        return sums;
    }
    Measured to_light = measured(way);
    float dimmed = falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0f ? spot(light, dot(-light.axis, to_light.w) / to_light.w_length)
            : 1.0f);
    float3 halfway = to_light.w + v * to_light.w_length;
    float cosine = dot(n, halfway);
    float highlight = cosine > 0.0f
            ? power_of_quotient(cosine * cosine, dot(halfway, halfway), max(0.5f * m, 0.0f)) : 0.0f;
    Sums result = {sums.diffuse + light.intensity
            * (dimmed * clamp(dot(n, to_light.w) / to_light.w_length, 0.0f, 1.0f)),
            sums.specular + light.intensity * (dimmed * highlight)};
    return result;
}

// The light that the point reflects: k_a I_a + k_d times the diffuse sum + k_s times the specular one.
inline float3 total(Sums sums, Material material, float3 i_a) {
    return material.k_a * i_a + min(sums.diffuse, float3(3.4028234e38f)) * material.k_d
            + min(sums.specular, float3(3.4028234e38f)) * material.k_s;
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
        float3 along_b = unit(b) + b * 0.0f;
        float3 along_c = unit(c) + c * 0.0f;
        float abs_x = abs(n.x);
        Measured x = measured(a);
        float abs_y = abs(n.y);
        Measured y = measured(b);
        float abs_z = abs(n.z);
        Measured z = measured(c);
        float least = min(min(abs_x > 0.0f ? x.v_length : 3.4028234e38f,
                abs_y > 0.0f ? y.v_length : 3.4028234e38f), abs_z > 0.0f ? z.v_length : 3.4028234e38f);
        float n_x = abs_x > 0.0f ? n.x * (x.v_length > least ? least / x.v_length : 1.0f) : 0.0f;
        float3 along_a = unit(a) + a * 0.0f;
        float n_y = abs_y > 0.0f ? n.y * (y.v_length > least ? least / y.v_length : 1.0f) : 0.0f;
        float n_z = abs_z > 0.0f ? n.z * (z.v_length > least ? least / z.v_length : 1.0f) : 0.0f;
        return unit(cross(along_b, along_c) * n_x + cross(along_c, along_a) * n_y + cross(along_a, along_b)
                * n_z);
    }
    return unit(cross(b, c) * n.x + cross(c, a) * n.y + cross(a, b) * n.z);
}

// A triangle's normal times its angle at v1, to be summed over a mesh. Thuermer and Wuethrich 1998.
inline float3 normal_corner(float3 v1, float3 v2, float3 v3) {
    float3 e1 = between(v1, v2);
    float3 e2 = between(v1, v3);
    Measured c = measured(cross(e1, e2));
    float cosine = dot(e1, e2);
    float adjacent = abs(cosine);
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
    float angle = max(1.5707964f - x * (1.5707964f - y * 0.7853982f) + arctangent, 0.0f);
    return (c.w_length > 0.0f ? c.w / c.w_length : float3(0.0f)) * angle;
}

// The tangent of a triangle and its handedness, by the texture coordinates of its vertices. Lengyel 2001.
inline Tangent normal_tangent(float3 v1, float3 v2, float3 v3, float2 uv1, float2 uv2, float2 uv3) {
    float3 half_v1 = v1 * 0.5f;
    float3 e2 = v2 * 0.5f - half_v1;
    float3 e3 = v3 * 0.5f - half_v1;
    float edge = max(measured(e2).v_length, measured(e3).v_length);
    float half_y = uv1.y * 0.5f;
    float y3 = uv3.y * 0.5f - half_y;
    float y2 = uv2.y * 0.5f - half_y;
    float y_size = max(abs(y2), abs(y3));
    float y3_part = y3 / y_size;
    float y2_part = y2 / y_size;
    float half_x = uv1.x * 0.5f;
    float x2 = uv2.x * 0.5f - half_x;
    float x3 = uv3.x * 0.5f - half_x;
    float x_size = max(abs(x2), abs(x3));
    float d = x2 / x_size * y3_part - x3 / x_size * y2_part;
    float h = d > 0.0f ? 1.0f : -1.0f;
    Measured t = measured((e2 / edge * y3_part - e3 / edge * y2_part) * h);
    if (!(t.w_length > 0.0f && abs(d) > 0.0f)) {
        Tangent result = {float3(0.0f), 0.0f};
        return result;
    }
    Tangent result = {t.w / t.w_length, h};
    return result;
}

// A normal from a map: x t + y b + z N, length 1. glTF 2.0, 3.7.2.1.
inline float3 normal_mapped(float3 n, float3 tangent, float h, float3 s) {
    Measured across = measured(crossed(float3(0.0f), n, tangent));
    Measured texel = measured(s);
    if (!(across.w_length > 0.0f && texel.w_length > 0.0f)) {
        return float3(0.0f);
    }
    float3 side = across.w / across.w_length;
    return unit(cross(side, n) * (texel.w.x / texel.w_length) + side * (h > 0.0f ? 1.0f : -1.0f)
            * (texel.w.y / texel.w_length) + n * (texel.w.z / texel.w_length));
}

} // namespace shading
#endif
