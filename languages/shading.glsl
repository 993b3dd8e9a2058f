// shading: Lambert, Phong and Blinn-Phong in linear light. MIT or Apache 2.0.
// Written by the package shading-languages from the source of the crate shading; do not edit it.
// All directions have length 1 and point away from the surface. A direction that does not exist is 0.
// Numbers are finite, and light, reflectances and the shininess m at least 0; then no result is NaN or negative light.
// Tried with 860,000 calls and numbers from 1e-45 to 1e38, in WGSL on Mesa's llvmpipe and in GLSL in Chromium's SwiftShader:
// with the crate's own power, 0.998 and 0.963 of the results were the crate's; with the language's, 0.950 and 0.957.

#ifndef SHADING_GLSL
#define SHADING_GLSL

// A light of any kind. A sun has its direction L for a position; a lamp has the cosines -1.
struct shading_Light {
    vec3 position;
    float is_sun;
    vec3 intensity;
    float limit;
    vec3 coefficients;
    float range;
    vec3 axis;
    float is_smoothstep;
    vec2 cosines;
    float is_gltf;
};

// The reflectances of a surface, and its shininess m.
struct shading_Material {
    vec3 k_a;
    float m;
    vec3 k_d;
    vec3 k_s;
};

// What arrives at a point from one light: L, the distance q and I.
struct shading_Arrival {
    vec3 l;
    float q;
    vec3 i;
};

// The sums over lights of I max(0, N.L) and of I times the highlight. They begin as 0.
struct shading_Sums {
    vec3 diffuse;
    vec3 specular;
};

// The tangent t of a triangle with texture coordinates, and its handedness h.
struct shading_Tangent {
    vec3 t;
    float h;
};

// A vector w of the direction of another, whose square is in range, |w|, and the length of the other.
struct shading_Measured {
    vec3 w;
    float w_length;
    float v_length;
};

#ifdef SHADING_EXACT_POWER

// e of x = 2^e z, where z is within [least, 2 least).
float shading_exponent(float x, float least) {
    return float((floatBitsToInt(x) - floatBitsToInt(least)) >> 23);
}

// z of x = 2^e z.
float shading_significand(float x, float least) {
    int above = floatBitsToInt(x) - floatBitsToInt(least);
    return intBitsToFloat(floatBitsToInt(x) - (above & -0x800000));
}

// 2^(n - 127) for the low byte n of the bits of x.
float shading_two_to_low_bits(float x) {
    return intBitsToFloat(floatBitsToInt(x) << 23);
}

// How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart.
float shading_steps_above(float x, float shift) {
    return float(floatBitsToInt(x) - floatBitsToInt(shift));
}

// (c/d)^m for c/d within [0, 1] and m >= 0, by the crate's own logarithm: within 2^-22.
float shading_power_of_quotient(float c, float d, float m) {
    float scaled = c * 16777216.0;
    float least = d * 11863283.0;
    float z = shading_significand(scaled, least);
    float one = d * 16777216.0;
    float s = (z - one) / (z + one);
    float s2 = s * s;
    float log2 = shading_exponent(scaled, least) + s * (2.8853905 + s2 * 0.9615518 + s2 * s2 * 0.59732693);
    float y = max(min(m * log2, 0.0), -126.0);
    float shifted = y + 12583038.0;
    float r = y - shading_steps_above(shifted, 12583038.0);
    float r2 = r * r;
    float q = 0.38629442 + 0.4804531 * r + r2 * (0.111006565 + 0.019235516 * r) + r2 * r2
            * (0.0026797508 + 0.00031013472 * r);
    return (2.0 + r + r * q) * shading_two_to_low_bits(shifted);
}

// c^m for c within [0, 1] and m >= 0, within 2^-22.
float shading_power(float c, float m) {
    float scaled = c * 16777216.0;
    float z = shading_significand(scaled, 11863283.0);
    float s = (z - 16777216.0) / (z + 16777216.0);
    float s2 = s * s;
    float log2 = shading_exponent(scaled, 11863283.0) + s
            * (2.8853905 + s2 * 0.9615518 + s2 * s2 * 0.59732693);
    float y = max(m * log2, -126.0);
    float shifted = y + 12583038.0;
    float r = y - shading_steps_above(shifted, 12583038.0);
    float r2 = r * r;
    float q = 0.38629442 + 0.4804531 * r + r2 * (0.111006565 + 0.019235516 * r) + r2 * r2
            * (0.0026797508 + 0.00031013472 * r);
    return (2.0 + r + r * q) * shading_two_to_low_bits(shifted);
}

#else

// (c/d)^m for c/d within [0, 1] and m >= 0, by the language's own power.
float shading_power_of_quotient(float c, float d, float m) {
    return pow(min(c / d, 1.0), m);
}

// c^m for c within [0, 1] and m >= 0, by the language's own power.
float shading_power(float c, float m) {
    return pow(c, m);
}

#endif

// Whether a square is so small or large that it is not exact.
bool shading_is_extreme(float square) {
    return !(square >= 7.888609e-31 && square < 1.2676506e30);
}

// The length of v, and w in its direction: v itself, or v times a power of 2 where its square is out of range.
shading_Measured shading_measured(vec3 v) {
    float square = dot(v, v);
    if (shading_is_extreme(square)) {
        float power = square < 1.2676506e30 ? (square < 7.888609e-31 ? 1.2676506e30 : 1.0) : 7.888609e-31;
        vec3 w = v * min(power, 1.0) * max(power, 1.0);
        float w_square = dot(w, w);
        float root = sqrt(w_square);
        return shading_Measured(w, w_square > 0.0 && w_square < 3.4028234e38 ? root : 0.0,
                w_square > 0.0 && w_square < 3.4028234e38 ? min(root / power, 3.4028234e38) : root);
    }
    float length = sqrt(square);
    return shading_Measured(v, length, length);
}

// v/|v|; 0 where v is 0.
vec3 shading_unit(vec3 v) {
    shading_Measured way = shading_measured(v);
    return way.w_length > 0.0 ? way.w / way.w_length : vec3(0.0);
}

// The vector from a point to another, times a power of 2 where its square is out of range.
vec3 shading_between(vec3 origin, vec3 p) {
    vec3 v = p - origin;
    float square = dot(v, v);
    if (shading_is_extreme(square)) {
        float power = square < 1.2676506e30 ? (square < 7.888609e-31 ? 1.2676506e30 : 1.0) : 7.888609e-31;
        float shrink = min(power, 1.0);
        return (p * shrink - origin * shrink) * max(power, 1.0);
    }
    return v;
}

// (a - origin) x (b - origin), in the right direction even where its square is out of range.
vec3 shading_crossed(vec3 origin, vec3 a, vec3 b) {
    vec3 c = cross(a - origin, b - origin);
    if (shading_is_extreme(dot(c, c))) {
        return cross(shading_between(origin, a), shading_between(origin, b));
    }
    return c;
}

// The reflection vector R = 2(N.L)N - L. Phong 1975; Foley, van Dam et al. 16.1.
vec3 shading_reflection(vec3 n, vec3 l) {
    float n_dot_l = dot(n, l);
    return n * (n_dot_l + n_dot_l) - l;
}

// The half vector H = (L + V)/|L + V|; 0 where L = -V. Blinn 1977.
vec3 shading_half_vector(vec3 l, vec3 v) {
    return shading_unit(l + v);
}

// The ambient term k_a I_a. Foley, van Dam et al. 16.1.
vec3 shading_term_ambient(vec3 k_a, vec3 i_a) {
    return k_a * i_a;
}

// Lambert's factor max(0, N.L). Lambert 1760.
float shading_term_lambert(vec3 n, vec3 l) {
    return max(dot(n, l), 0.0);
}

// Phong's highlight max(0, R.V)^m. Phong 1975.
float shading_term_phong(vec3 r, vec3 v, float m) {
    float r_dot_v = dot(r, v);
    return r_dot_v > 0.0 ? shading_power(clamp(r_dot_v, 0.0, 1.0), max(m, 0.0)) : 0.0;
}

// Blinn's highlight max(0, N.H)^m. Blinn 1977.
float shading_term_blinn(vec3 n, vec3 h, float m) {
    float n_dot_h = dot(n, h);
    return n_dot_h > 0.0 ? shading_power(clamp(n_dot_h, 0.0, 1.0), max(m, 0.0)) : 0.0;
}

// What makes Phong's highlight reflect at most k_s: (m + 2)/(2 pi). Lafortune and Willems 1994.
float shading_term_phong_normalization(float m) {
    return (max(m, 0.0) + 2.0) * 0.15915494;
}

// The same of Blinn's: (m + 2)(m + 4)/(8 pi (2^(-m/2) + m)). Giesen 2009.
float shading_term_blinn_normalization(float m) {
    float exponent = max(m, 0.0);
    return (exponent + 2.0) * 0.039788734
            * ((exponent + 4.0) / (exponent + shading_power(0.70710677, max(exponent, 0.0))));
}

// The attenuation 1/(a + bq + cq^2). Foley, van Dam et al. 16.1; OpenGL 2.1, 2.14.1.
float shading_attenuation(float a, float b, float c, float q) {
    return clamp(1.0 / (a + q * (b + c * q)), 0.0, 3.4028234e38);
}

// What ends a light at the range r: max(0, 1 - (q/r)^4)^2. Karis 2013.
float shading_window(float q, float r) {
    float fraction = q / r;
    float square = fraction * fraction;
    float root = max(1.0 - square * square, 0.0);
    return root * root;
}

// The same without the square: KHR_lights_punctual.
float shading_window_gltf(float q, float r) {
    float fraction = q / r;
    float square = fraction * fraction;
    return max(1.0 - square * square, 0.0);
}

// t^2, where t rises from 0 at the cosine of the outer edge to 1 at that of the inner. KHR_lights_punctual.
float shading_beam(float cosine, float inner, float outer) {
    if (!(inner > outer)) {
        return inner > cosine ? 0.0 : 1.0;
    }
    float t = clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    return inner > cosine ? t * t : 1.0;
}

// The same with t^2(3 - 2t). POV-Ray 3.7.
float shading_beam_smoothstep(float cosine, float inner, float outer) {
    if (!(inner > outer)) {
        return inner > cosine ? 0.0 : 1.0;
    }
    float t = clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    return inner > cosine ? min(t * t * (3.0 - (t + t)), 1.0) : 1.0;
}

// The factor of a spot's cone, given the cosines of its inner and its outer half-angle.
float shading_cone(vec3 axis, vec3 l, vec2 cosines) {
    float inner = cosines.x < -0.9999995 ? -2.0 : min(cosines.x, 0.9999995);
    float outer = cosines.x < -0.9999995 ? -2.0 : min(cosines.y, 0.9999995);
    return shading_beam(dot(-axis, l), inner, outer);
}

// The same with a smoothstep between the edges.
float shading_cone_smoothstep(vec3 axis, vec3 l, vec2 cosines) {
    float cosine = dot(-axis, l);
    float inner = cosines.x < -0.9999995 ? -2.0 : min(cosines.x, 0.9999995);
    float outer = cosines.x < -0.9999995 ? -2.0 : min(cosines.y, 0.9999995);
    return shading_beam_smoothstep(cosine, inner, outer);
}

// What dims a light after the distance q: its attenuation, at most its limit, and the window of its range.
float shading_falloff(shading_Light light, float q) {
    return clamp(1.0 / (light.coefficients.x + q * (light.coefficients.y + light.coefficients.z * q)), 0.0,
            light.limit) * (light.range < 3.4028234e38
            ? (light.is_gltf > 0.0 ? shading_window_gltf(q, light.range) : shading_window(q, light.range))
            : 1.0);
}

// The factor of a spot's cone, by the cosine between its axis and -L.
float shading_spot(shading_Light light, float cosine) {
    float inner = light.cosines.x < -0.9999995 ? -2.0 : min(light.cosines.x, 0.9999995);
    float outer = light.cosines.x < -0.9999995 ? -2.0 : min(light.cosines.y, 0.9999995);
    return light.is_smoothstep > 0.0 ? shading_beam_smoothstep(cosine, inner, outer)
            : shading_beam(cosine, inner, outer);
}

// What arrives at the point p: L, the distance q and I. Foley, van Dam et al. 16.1.
shading_Arrival shading_arrival(shading_Light light, vec3 p) {
    if (light.is_sun > 0.0) {
        return shading_Arrival(light.position, 3.4028234e38, light.intensity);
    }
    shading_Measured to_light = shading_measured(light.position - p);
    if (!(to_light.w_length > 0.0)) {
        return shading_Arrival(vec3(0.0, 0.0, 1.0), min(to_light.v_length, 3.4028234e38), vec3(0.0));
    }
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0 ? shading_spot(light, dot(-light.axis, to_light.w) / to_light.w_length)
            : 1.0);
    return shading_Arrival(to_light.w / to_light.w_length, min(to_light.v_length, 3.4028234e38),
            min(light.intensity * dimmed, vec3(3.4028234e38)));
}

// What one light adds by Lambert's model: I k_d max(0, N.L).
vec3 shading_shade_lambert(vec3 n, shading_Material material, shading_Arrival light) {
    float n_dot_l = dot(n, light.l);
    if (!(n_dot_l > 0.0)) {
        return vec3(0.0);
    }
    return light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d;
}

// What one light adds by Phong's model: I (k_d N.L + k_s max(0, R.V)^m), where N.L > 0. Phong 1975.
vec3 shading_shade_phong(vec3 n, vec3 v, shading_Material material, shading_Arrival light) {
    float n_dot_l = dot(n, light.l);
    if (!(n_dot_l > 0.0)) {
        return vec3(0.0);
    }
    vec3 diffuse = light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d;
    vec3 r = n * (n_dot_l + n_dot_l) - light.l;
    float r_dot_v = dot(r, v);
    float highlight = r_dot_v > 0.0 ? shading_power(clamp(r_dot_v, 0.0, 1.0), max(material.m, 0.0)) : 0.0;
    vec3 specular = light.i * highlight * material.k_s;
    return diffuse + specular;
}

// What one light adds by Blinn and Phong's model: I (k_d N.L + k_s max(0, N.H)^m), where N.L > 0. Blinn 1977.
vec3 shading_shade_blinn_phong(vec3 n, vec3 v, shading_Material material, shading_Arrival light) {
    float n_dot_l = dot(n, light.l);
    if (!(n_dot_l > 0.0)) {
        return vec3(0.0);
    }
    vec3 diffuse = light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d;
    vec3 h = light.l + v;
    float n_dot_h = dot(n, h);
    float highlight = n_dot_h > 0.0
            ? shading_power_of_quotient(n_dot_h * n_dot_h, dot(h, h), max(0.5 * material.m, 0.0)) : 0.0;
    vec3 specular = light.i * highlight * material.k_s;
    return diffuse + specular;
}

// The sums over lights after one more, by Lambert's model. A light from behind adds nothing and costs no root.
shading_Sums shading_add_lambert(shading_Sums sums, vec3 n, shading_Light light, vec3 p) {
    if (light.is_sun > 0.0) {
        float n_dot_l = dot(n, light.position);
        if (!(n_dot_l > 0.0)) {
            return sums;
        }
        return shading_Sums(sums.diffuse + light.intensity * clamp(n_dot_l, 0.0, 1.0), sums.specular);
    }
    vec3 way = light.position - p;
    if (!(dot(n, way) > 0.0)) {
        return sums;
    }
    shading_Measured to_light = shading_measured(way);
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0 ? shading_spot(light, dot(-light.axis, to_light.w) / to_light.w_length)
            : 1.0);
    return shading_Sums(sums.diffuse + light.intensity
            * (dimmed * clamp(dot(n, to_light.w) / to_light.w_length, 0.0, 1.0)), sums.specular);
}

// The same by Phong's model.
shading_Sums shading_add_phong(shading_Sums sums, vec3 n, vec3 v, float m, shading_Light light, vec3 p) {
    if (light.is_sun > 0.0) {
        float n_dot_l = dot(n, light.position);
        if (!(n_dot_l > 0.0)) {
            return sums;
        }
        float r_dot_v = dot(n * (n_dot_l + n_dot_l) - light.position, v);
        float highlight_of_sun = r_dot_v > 0.0 ? shading_power(clamp(r_dot_v, 0.0, 1.0), max(m, 0.0)) : 0.0;
        return shading_Sums(sums.diffuse + light.intensity * clamp(n_dot_l, 0.0, 1.0),
                sums.specular + light.intensity * highlight_of_sun);
    }
    vec3 way = light.position - p;
    if (!(dot(n, way) > 0.0)) {
        return sums;
    }
    shading_Measured to_light = shading_measured(way);
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0 ? shading_spot(light, dot(-light.axis, to_light.w) / to_light.w_length)
            : 1.0);
    float n_dot_w = dot(n, to_light.w);
    float cosine = dot(n * (n_dot_w + n_dot_w) - to_light.w, v) / to_light.w_length;
    float highlight = cosine > 0.0 ? shading_power(clamp(cosine, 0.0, 1.0), max(m, 0.0)) : 0.0;
    return shading_Sums(sums.diffuse + light.intensity
            * (dimmed * clamp(n_dot_w / to_light.w_length, 0.0, 1.0)),
            sums.specular + light.intensity * (dimmed * highlight));
}

// The same by Blinn and Phong's model.
shading_Sums shading_add_blinn_phong(shading_Sums sums, vec3 n, vec3 v, float m, shading_Light light,
        vec3 p) {
    if (light.is_sun > 0.0) {
        float n_dot_l = dot(n, light.position);
        if (!(n_dot_l > 0.0)) {
            return sums;
        }
        vec3 h = light.position + v;
        float n_dot_h = dot(n, h);
        float highlight_of_sun = n_dot_h > 0.0
                ? shading_power_of_quotient(n_dot_h * n_dot_h, dot(h, h), max(0.5 * m, 0.0)) : 0.0;
        return shading_Sums(sums.diffuse + light.intensity * clamp(n_dot_l, 0.0, 1.0),
                sums.specular + light.intensity * highlight_of_sun);
    }
    vec3 way = light.position - p;
    if (!(dot(n, way) > 0.0)) {
        return sums;
    }
    shading_Measured to_light = shading_measured(way);
    float dimmed = shading_falloff(light, to_light.v_length)
            * (light.cosines.x > -1.0 ? shading_spot(light, dot(-light.axis, to_light.w) / to_light.w_length)
            : 1.0);
    vec3 halfway = to_light.w + v * to_light.w_length;
    float cosine = dot(n, halfway);
    float highlight = cosine > 0.0
            ? shading_power_of_quotient(cosine * cosine, dot(halfway, halfway), max(0.5 * m, 0.0)) : 0.0;
    return shading_Sums(sums.diffuse + light.intensity
            * (dimmed * clamp(dot(n, to_light.w) / to_light.w_length, 0.0, 1.0)),
            sums.specular + light.intensity * (dimmed * highlight));
}

// The light that the point reflects: k_a I_a + k_d times the diffuse sum + k_s times the specular one.
vec3 shading_total(shading_Sums sums, shading_Material material, vec3 i_a) {
    return material.k_a * i_a + min(sums.diffuse, vec3(3.4028234e38)) * material.k_d
            + min(sums.specular, vec3(3.4028234e38)) * material.k_s;
}

// The normal of the plane ax + by + cz + d = 0: (a, b, c)/|(a, b, c)|. Foley, van Dam et al. 11.1.3.
vec3 shading_normal_plane(float a, float b, float c) {
    return shading_unit(vec3(a, b, c));
}

// The normal of a triangle, counter-clockwise: (v2 - v1) x (v3 - v1), length 1. Foley, van Dam et al. 11.1.3.
vec3 shading_normal_triangle(vec3 v1, vec3 v2, vec3 v3) {
    return shading_unit(shading_crossed(v1, v2, v3));
}

// The normal of a sphere: (p - center)/|p - center|. Foley, van Dam et al. 15.10.1.
vec3 shading_normal_sphere(vec3 center, vec3 p) {
    return shading_unit(shading_between(center, p));
}

// The normal of f(p) = 0 by the gradient of f, length 1. Foley, van Dam et al. 11.4.
vec3 shading_normal_from_gradient(vec3 gradient) {
    return shading_unit(gradient);
}

// The normal of s(u, v): ds/du x ds/dv, length 1. Foley, van Dam et al. 11.3.4.
vec3 shading_normal_from_tangents(vec3 s_u, vec3 s_v) {
    return shading_unit(shading_crossed(vec3(0.0), s_u, s_v));
}

// N toward the eye: N if F.V >= 0, else -N, where F is the normal of the face. GLSL 4.60, 8.5.
vec3 shading_normal_facing(vec3 n, vec3 v, vec3 f) {
    return dot(-f, v) > 0.0 ? -n : n;
}

// A normal transformed by the matrix of the columns a, b, c: cof(M) N, length 1. Lengyel 2024.
vec3 shading_normal_transformed(vec3 n, vec3 a, vec3 b, vec3 c) {
    if (shading_is_extreme(dot(a, a)) || shading_is_extreme(dot(b, b)) || shading_is_extreme(dot(c, c))) {
        vec3 along_b = shading_unit(b) + b * 0.0;
        vec3 along_c = shading_unit(c) + c * 0.0;
        float abs_x = abs(n.x);
        shading_Measured x = shading_measured(a);
        float abs_y = abs(n.y);
        shading_Measured y = shading_measured(b);
        float abs_z = abs(n.z);
        shading_Measured z = shading_measured(c);
        float least = min(min(abs_x > 0.0 ? x.v_length : 3.4028234e38,
                abs_y > 0.0 ? y.v_length : 3.4028234e38), abs_z > 0.0 ? z.v_length : 3.4028234e38);
        float n_x = abs_x > 0.0 ? n.x * (x.v_length > least ? least / x.v_length : 1.0) : 0.0;
        vec3 along_a = shading_unit(a) + a * 0.0;
        float n_y = abs_y > 0.0 ? n.y * (y.v_length > least ? least / y.v_length : 1.0) : 0.0;
        float n_z = abs_z > 0.0 ? n.z * (z.v_length > least ? least / z.v_length : 1.0) : 0.0;
        return shading_unit(cross(along_b, along_c) * n_x + cross(along_c, along_a) * n_y
                + cross(along_a, along_b) * n_z);
    }
    return shading_unit(cross(b, c) * n.x + cross(c, a) * n.y + cross(a, b) * n.z);
}

// A triangle's normal times its angle at v1, to be summed over a mesh. Thuermer and Wuethrich 1998.
vec3 shading_normal_corner(vec3 v1, vec3 v2, vec3 v3) {
    vec3 e1 = shading_between(v1, v2);
    vec3 e2 = shading_between(v1, v3);
    shading_Measured c = shading_measured(cross(e1, e2));
    float cosine = dot(e1, e2);
    float adjacent = abs(cosine);
    float x = adjacent * 2.4142137 > c.v_length ? (cosine > 0.0 ? 1.0 : -1.0) : 0.0;
    float y = c.v_length > adjacent * 0.41421357 ? 1.0 : 0.0;
    float t = (x * c.v_length - y * cosine) / (x * cosine + y * c.v_length);
    float z = t * t;
    float z2 = z * z;
    float z4 = z2 * z2;
    float series = -0.33333334 + z * 0.2 + z2 * (-0.14285715 + z * 0.111111104) + z4
            * (-0.0909089 + z * 0.07691945 + z2 * (-0.06661951 + z * 0.05840374) + z4
            * (-0.050085507 + z * 0.03734732 + z2 * -0.01718003));
    float arctangent = t + t * (z * series);
    float angle = max(1.5707964 - x * (1.5707964 - y * 0.7853982) + arctangent, 0.0);
    return (c.w_length > 0.0 ? c.w / c.w_length : vec3(0.0)) * angle;
}

// The tangent of a triangle and its handedness, by the texture coordinates of its vertices. Lengyel 2001.
shading_Tangent shading_normal_tangent(vec3 v1, vec3 v2, vec3 v3, vec2 uv1, vec2 uv2, vec2 uv3) {
    vec3 half_v1 = v1 * 0.5;
    vec3 e2 = v2 * 0.5 - half_v1;
    vec3 e3 = v3 * 0.5 - half_v1;
    float edge = max(shading_measured(e2).v_length, shading_measured(e3).v_length);
    float half_y = uv1.y * 0.5;
    float y3 = uv3.y * 0.5 - half_y;
    float y2 = uv2.y * 0.5 - half_y;
    float y_size = max(abs(y2), abs(y3));
    float y3_part = y3 / y_size;
    float y2_part = y2 / y_size;
    float half_x = uv1.x * 0.5;
    float x2 = uv2.x * 0.5 - half_x;
    float x3 = uv3.x * 0.5 - half_x;
    float x_size = max(abs(x2), abs(x3));
    float d = x2 / x_size * y3_part - x3 / x_size * y2_part;
    float h = d > 0.0 ? 1.0 : -1.0;
    shading_Measured t = shading_measured((e2 / edge * y3_part - e3 / edge * y2_part) * h);
    if (!(t.w_length > 0.0 && abs(d) > 0.0)) {
        return shading_Tangent(vec3(0.0), 0.0);
    }
    return shading_Tangent(t.w / t.w_length, h);
}

// A normal from a map: x t + y b + z N, length 1. glTF 2.0, 3.7.2.1.
vec3 shading_normal_mapped(vec3 n, vec3 tangent, float h, vec3 s) {
    shading_Measured across = shading_measured(shading_crossed(vec3(0.0), n, tangent));
    shading_Measured texel = shading_measured(s);
    if (!(across.w_length > 0.0 && texel.w_length > 0.0)) {
        return vec3(0.0);
    }
    vec3 side = across.w / across.w_length;
    return shading_unit(cross(side, n) * (texel.w.x / texel.w_length) + side * (h > 0.0 ? 1.0 : -1.0)
            * (texel.w.y / texel.w_length) + n * (texel.w.z / texel.w_length));
}

#endif
