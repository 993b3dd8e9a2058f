// shading: Lambert, Phong and Blinn-Phong in linear light. MIT or Apache 2.0.
// Written by the package shading-languages from the source of the crate shading; do not edit it.
// All directions have length 1 and point away from the surface. A direction that does not exist is 0.
// Numbers are finite, and light, reflectances and the shininess m at least 0; then no result is NaN or negative light.

#ifndef SHADING_HLSL
#define SHADING_HLSL

// A light of any kind. A sun has its direction L for a position; a lamp has the cosines -1.
struct shading_Light {
    float3 position;
    float is_sun;
    float3 intensity;
    float limit;
    float3 coefficients;
    float range;
    float3 axis;
    float is_smoothstep;
    float2 cosines;
    float is_gltf;
    float padding_is_gltf;
};

// The reflectances of a surface, and its shininess m.
struct shading_Material {
    float3 k_a;
    float m;
    float3 k_d;
    float padding_k_d;
    float3 k_s;
    float padding_k_s;
};

// What arrives at a point from one light: L, the distance q and I.
struct shading_Arrival {
    float3 l;
    float q;
    float3 i;
};

// The sums over lights of I max(0, N.L) and of I times the highlight. They begin as 0.
struct shading_Sums {
    float3 diffuse;
    float3 specular;
};

// The tangent t of a triangle with texture coordinates, and its handedness h.
struct shading_Tangent {
    float3 t;
    float h;
};

// A vector w of the direction of another, whose square is in range, |w|, and the length of the other.
struct shading_Measured {
    float3 w;
    float w_length;
    float length;
};

// Whether a square is so small or large that it is not exact.
bool shading_is_extreme(float square) {
    return !(square >= 7.888609e-31 && square < 1.2676506e30);
}

#ifdef SHADING_EXACT_POWER

// e of x = 2^e z, where z is within [least, 2 least).
float shading_exponent(float x, float least) {
    return float((asint(x) - asint(least)) >> 23);
}

// z of x = 2^e z.
float shading_significand(float x, float least) {
    int above = asint(x) - asint(least);
    return asfloat(asint(x) - (above & -0x800000));
}

// 2^(n - 127) for the low byte n of the bits of x.
float shading_two_to_low_bits(float x) {
    return asfloat(asint(x) << 23);
}

// How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart.
float shading_steps_above(float x, float shift) {
    return float(asint(x) - asint(shift));
}

// (c/d)^m for c/d within [0, 1] and m >= 0, by the crate's own logarithm: within 2^-22.
float shading_power_of_quotient(float c, float d, float m) {
    float t1 = c * 16777216.0;
    float t2 = d * 11863283.0;
    float t3 = shading_significand(t1, t2);
    float t4 = d * 16777216.0;
    float t5 = (t3 - t4) / (t3 + t4);
    float t6 = t5 * t5;
    float t7 = max(min(m * (shading_exponent(t1, t2) + t5
            * (2.8853905 + t6 * 0.9615518 + t6 * t6 * 0.59732693)), 0.0), -126.0);
    float t8 = t7 + 12583038.0;
    float t9 = t7 - shading_steps_above(t8, 12583038.0);
    float t10 = t9 * t9;
    return (2.0 + t9 + t9 * (0.38629442 + 0.4804531 * t9 + t10 * (0.111006565 + 0.019235516 * t9) + t10 * t10
            * (0.0026797508 + 0.00031013472 * t9))) * shading_two_to_low_bits(t8);
}

// c^m for c within [0, 1] and m >= 0, within 2^-22.
float shading_power(float c, float m) {
    float t1 = c * 16777216.0;
    float t2 = shading_significand(t1, 11863283.0);
    float t3 = (t2 - 16777216.0) / (t2 + 16777216.0);
    float t4 = t3 * t3;
    float t5 = max(m * (shading_exponent(t1, 11863283.0) + t3
            * (2.8853905 + t4 * 0.9615518 + t4 * t4 * 0.59732693)), -126.0);
    float t6 = t5 + 12583038.0;
    float t7 = t5 - shading_steps_above(t6, 12583038.0);
    float t8 = t7 * t7;
    return (2.0 + t7 + t7 * (0.38629442 + 0.4804531 * t7 + t8 * (0.111006565 + 0.019235516 * t7) + t8 * t8
            * (0.0026797508 + 0.00031013472 * t7))) * shading_two_to_low_bits(t6);
}

#else

// (c/d)^m for c/d within [0, by the language's own power.
float shading_power_of_quotient(float c, float d, float m) {
    return pow(min(c / d, 1.0), m);
}

// c^m for c within [0, by the language's own power.
float shading_power(float c, float m) {
    return pow(c, m);
}

#endif

// The length of v, and w in its direction: v itself, or v times a power of 2 where its square is out of range.
shading_Measured shading_measured(float3 v) {
    float square = dot(v, v);
    if (shading_is_extreme(square)) {
        float t1 = square < 1.2676506e30 ? (square < 7.888609e-31 ? 1.2676506e30 : 1.0) : 7.888609e-31;
        float3 t2 = v * min(t1, 1.0) * max(t1, 1.0);
        float t2_dot_t2 = dot(t2, t2);
        float t3 = sqrt(t2_dot_t2);
        shading_Measured result = {t2, t2_dot_t2 > 0.0 && t2_dot_t2 < 3.4028235e38 ? t3 : 0.0,
                t2_dot_t2 > 0.0 && t2_dot_t2 < 3.4028235e38 ? min(t3 / t1, 3.4028235e38) : t3};
        return result;
    }
    float t1 = sqrt(square);
    shading_Measured result = {v, t1, t1};
    return result;
}

// v/|v|; 0 where v is 0.
float3 shading_unit(float3 v) {
    shading_Measured of = shading_measured(v);
    return of.w_length > 0.0 ? of.w / of.w_length : float3(0.0, 0.0, 0.0);
}

// The vector from a point to another, times a power of 2 where its square is out of range.
float3 shading_between(float3 origin, float3 p) {
    float3 v = p - origin;
    float square = dot(v, v);
    if (shading_is_extreme(square)) {
        float t1 = square < 1.2676506e30 ? (square < 7.888609e-31 ? 1.2676506e30 : 1.0) : 7.888609e-31;
        float t2 = min(t1, 1.0);
        return (p * t2 - origin * t2) * max(t1, 1.0);
    }
    return v;
}

// (a - origin) x (b - origin), in the right direction even where its square is out of range.
float3 shading_crossed(float3 origin, float3 a, float3 b) {
    float3 c = cross(a - origin, b - origin);
    if (shading_is_extreme(dot(c, c))) {
        return cross(shading_between(origin, a), shading_between(origin, b));
    }
    return c;
}

// The reflection vector R = 2(N.L)N - L. Phong 1975; Foley, van Dam et al. 16.1.
float3 shading_reflection(float3 n, float3 l) {
    float n_dot_l = dot(n, l);
    return n * (n_dot_l + n_dot_l) - l;
}

// The half vector H = (L + V)/|L + V|; 0 where L = -V. Blinn 1977.
float3 shading_half_vector(float3 l, float3 v) {
    return shading_unit(l + v);
}

// The ambient term k_a I_a. Foley, van Dam et al. 16.1.
float3 shading_term_ambient(float3 k_a, float3 i_a) {
    return k_a * i_a;
}

// Lambert's factor max(0, N.L). Lambert 1760.
float shading_term_lambert(float3 n, float3 l) {
    return max(dot(n, l), 0.0);
}

// Phong's highlight max(0, R.V)^m. Phong 1975.
float shading_term_phong(float3 r, float3 v, float m) {
    float r_dot_v = dot(r, v);
    return r_dot_v > 0.0 ? shading_power(clamp(r_dot_v, 0.0, 1.0), max(m, 0.0)) : 0.0;
}

// Blinn's highlight max(0, N.H)^m. Blinn 1977.
float shading_term_blinn(float3 n, float3 h, float m) {
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
    return clamp(1.0 / (a + q * (b + c * q)), 0.0, 3.4028235e38);
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
float shading_cone(float3 axis, float3 l, float2 cosines) {
    return shading_beam(dot(-axis, l), cosines.x < -0.9999995 ? -2.0 : min(cosines.x, 0.9999995),
            cosines.x < -0.9999995 ? -2.0 : min(cosines.y, 0.9999995));
}

// The same with a smoothstep between the edges.
float shading_cone_smoothstep(float3 axis, float3 l, float2 cosines) {
    return shading_beam_smoothstep(dot(-axis, l), cosines.x < -0.9999995 ? -2.0 : min(cosines.x, 0.9999995),
            cosines.x < -0.9999995 ? -2.0 : min(cosines.y, 0.9999995));
}

// What arrives at the point p: L, the distance q and I. Foley, van Dam et al. 16.1.
shading_Arrival shading_arrival(shading_Light light, float3 p) {
    if (light.is_sun > 0.0) {
        shading_Arrival result = {light.position, 3.4028235e38, light.intensity};
        return result;
    }
    shading_Measured to_light = shading_measured(light.position - p);
    float t1 = dot(-light.axis, to_light.w) / to_light.w_length;
    float t2 = light.cosines.x < -0.9999995 ? -2.0 : min(light.cosines.x, 0.9999995);
    float t3 = light.cosines.x < -0.9999995 ? -2.0 : min(light.cosines.y, 0.9999995);
    shading_Arrival result = {to_light.w_length > 0.0 ? to_light.w / to_light.w_length
            : float3(0.0, 0.0, 1.0), min(to_light.length, 3.4028235e38),
            min(light.intensity * (to_light.w_length > 0.0
            ? clamp(1.0 / (light.coefficients.x + to_light.length
            * (light.coefficients.y + light.coefficients.z * to_light.length)), 0.0, light.limit)
            * (light.range < 3.4028235e38
            ? (light.is_gltf > 0.0 ? shading_window_gltf(to_light.length, light.range)
            : shading_window(to_light.length, light.range)) : 1.0)
            * (light.cosines.x > -1.0
            ? (light.is_smoothstep > 0.0 ? shading_beam_smoothstep(t1, t2, t3) : shading_beam(t1, t2, t3))
            : 1.0) : 0.0), float3(3.4028235e38, 3.4028235e38, 3.4028235e38))};
    return result;
}

// What one light adds by Lambert's model: I k_d max(0, N.L).
float3 shading_shade_lambert(float3 n, shading_Material material, shading_Arrival light) {
    float n_dot_l = dot(n, light.l);
    if (!(n_dot_l > 0.0)) {
        return float3(0.0, 0.0, 0.0);
    }
    return light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d;
}

// What one light adds by Phong's model: I (k_d N.L + k_s max(0, R.V)^m), where N.L > 0. Phong 1975.
float3 shading_shade_phong(float3 n, float3 v, shading_Material material, shading_Arrival light) {
    float n_dot_l = dot(n, light.l);
    if (!(n_dot_l > 0.0)) {
        return float3(0.0, 0.0, 0.0);
    }
    float3 r = n * (n_dot_l + n_dot_l) - light.l;
    float r_dot_v = dot(r, v);
    return light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d + light.i
            * (r_dot_v > 0.0 ? shading_power(clamp(r_dot_v, 0.0, 1.0), max(material.m, 0.0)) : 0.0)
            * material.k_s;
}

// What one light adds by Blinn and Phong's model: I (k_d N.L + k_s max(0, N.H)^m), where N.L > 0. Blinn 1977.
float3 shading_shade_blinn_phong(float3 n, float3 v, shading_Material material, shading_Arrival light) {
    float n_dot_l = dot(n, light.l);
    if (!(n_dot_l > 0.0)) {
        return float3(0.0, 0.0, 0.0);
    }
    float3 h = light.l + v;
    float n_dot_h = dot(n, h);
    return light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d + light.i
            * (n_dot_h > 0.0 ? shading_power_of_quotient(n_dot_h * n_dot_h, dot(h, h),
            max(0.5 * material.m, 0.0)) : 0.0) * material.k_s;
}

// The sums over lights after one more, by Lambert's model. A light from behind adds nothing and costs no root.
shading_Sums shading_add_lambert(shading_Sums sums, float3 n, shading_Light light, float3 p) {
    if (light.is_sun > 0.0) {
        float t1 = dot(n, light.position);
        if (!(t1 > 0.0)) {
            shading_Sums result = {sums.diffuse, sums.specular};
            return result;
        }
        shading_Sums result = {sums.diffuse + light.intensity * clamp(t1, 0.0, 1.0), sums.specular};
        return result;
    }
    float3 t1 = light.position - p;
    if (!(dot(n, t1) > 0.0)) {
        shading_Sums result = {sums.diffuse, sums.specular};
        return result;
    }
    shading_Measured t2 = shading_measured(t1);
    float t3 = dot(-light.axis, t2.w) / t2.w_length;
    float t4 = light.cosines.x < -0.9999995 ? -2.0 : min(light.cosines.x, 0.9999995);
    float t5 = light.cosines.x < -0.9999995 ? -2.0 : min(light.cosines.y, 0.9999995);
    shading_Sums result = {sums.diffuse + light.intensity
            * (clamp(1.0 / (light.coefficients.x + t2.length
            * (light.coefficients.y + light.coefficients.z * t2.length)), 0.0, light.limit)
            * (light.range < 3.4028235e38
            ? (light.is_gltf > 0.0 ? shading_window_gltf(t2.length, light.range)
            : shading_window(t2.length, light.range)) : 1.0)
            * (light.cosines.x > -1.0
            ? (light.is_smoothstep > 0.0 ? shading_beam_smoothstep(t3, t4, t5) : shading_beam(t3, t4, t5))
            : 1.0) * clamp(dot(n, t2.w) / t2.w_length, 0.0, 1.0)), sums.specular};
    return result;
}

// The same by Phong's model.
shading_Sums shading_add_phong(shading_Sums sums, float3 n, float3 v, float m, shading_Light light,
        float3 p) {
    if (light.is_sun > 0.0) {
        float t1 = dot(n, light.position);
        if (!(t1 > 0.0)) {
            shading_Sums result = {sums.diffuse, sums.specular};
            return result;
        }
        float t2 = dot(n * (t1 + t1) - light.position, v);
        shading_Sums result = {sums.diffuse + light.intensity * clamp(t1, 0.0, 1.0), sums.specular
                + light.intensity * (t2 > 0.0 ? shading_power(clamp(t2, 0.0, 1.0), max(m, 0.0)) : 0.0)};
        return result;
    }
    float3 t1 = light.position - p;
    if (!(dot(n, t1) > 0.0)) {
        shading_Sums result = {sums.diffuse, sums.specular};
        return result;
    }
    shading_Measured t2 = shading_measured(t1);
    float t3 = dot(-light.axis, t2.w) / t2.w_length;
    float t4 = light.cosines.x < -0.9999995 ? -2.0 : min(light.cosines.x, 0.9999995);
    float t5 = light.cosines.x < -0.9999995 ? -2.0 : min(light.cosines.y, 0.9999995);
    float t6 = clamp(1.0 / (light.coefficients.x + t2.length
            * (light.coefficients.y + light.coefficients.z * t2.length)), 0.0, light.limit)
            * (light.range < 3.4028235e38
            ? (light.is_gltf > 0.0 ? shading_window_gltf(t2.length, light.range)
            : shading_window(t2.length, light.range)) : 1.0)
            * (light.cosines.x > -1.0
            ? (light.is_smoothstep > 0.0 ? shading_beam_smoothstep(t3, t4, t5) : shading_beam(t3, t4, t5))
            : 1.0);
    float t7 = dot(n, t2.w);
    float t8 = dot(n * (t7 + t7) - t2.w, v) / t2.w_length;
    shading_Sums result = {sums.diffuse + light.intensity * (t6 * clamp(t7 / t2.w_length, 0.0, 1.0)),
            sums.specular + light.intensity
            * (t6 * (t8 > 0.0 ? shading_power(clamp(t8, 0.0, 1.0), max(m, 0.0)) : 0.0))};
    return result;
}

// The same by Blinn and Phong's model.
shading_Sums shading_add_blinn_phong(shading_Sums sums, float3 n, float3 v, float m, shading_Light light,
        float3 p) {
    if (light.is_sun > 0.0) {
        float t1 = dot(n, light.position);
        if (!(t1 > 0.0)) {
            shading_Sums result = {sums.diffuse, sums.specular};
            return result;
        }
        float3 t2 = light.position + v;
        float n_dot_t2 = dot(n, t2);
        shading_Sums result = {sums.diffuse + light.intensity * clamp(t1, 0.0, 1.0), sums.specular
                + light.intensity * (n_dot_t2 > 0.0
                ? shading_power_of_quotient(n_dot_t2 * n_dot_t2, dot(t2, t2), max(0.5 * m, 0.0)) : 0.0)};
        return result;
    }
    float3 t1 = light.position - p;
    if (!(dot(n, t1) > 0.0)) {
        shading_Sums result = {sums.diffuse, sums.specular};
        return result;
    }
    shading_Measured t2 = shading_measured(t1);
    float t3 = dot(-light.axis, t2.w) / t2.w_length;
    float t4 = light.cosines.x < -0.9999995 ? -2.0 : min(light.cosines.x, 0.9999995);
    float t5 = light.cosines.x < -0.9999995 ? -2.0 : min(light.cosines.y, 0.9999995);
    float t6 = clamp(1.0 / (light.coefficients.x + t2.length
            * (light.coefficients.y + light.coefficients.z * t2.length)), 0.0, light.limit)
            * (light.range < 3.4028235e38
            ? (light.is_gltf > 0.0 ? shading_window_gltf(t2.length, light.range)
            : shading_window(t2.length, light.range)) : 1.0)
            * (light.cosines.x > -1.0
            ? (light.is_smoothstep > 0.0 ? shading_beam_smoothstep(t3, t4, t5) : shading_beam(t3, t4, t5))
            : 1.0);
    float3 t7 = t2.w + v * t2.w_length;
    float n_dot_t7 = dot(n, t7);
    shading_Sums result = {sums.diffuse + light.intensity
            * (t6 * clamp(dot(n, t2.w) / t2.w_length, 0.0, 1.0)), sums.specular + light.intensity
            * (t6 * (n_dot_t7 > 0.0 ? shading_power_of_quotient(n_dot_t7 * n_dot_t7, dot(t7, t7),
            max(0.5 * m, 0.0)) : 0.0))};
    return result;
}

// The light that the point reflects: k_a I_a + k_d times the diffuse sum + k_s times the specular one.
float3 shading_total(shading_Sums sums, shading_Material material, float3 i_a) {
    return material.k_a * i_a + min(sums.diffuse, float3(3.4028235e38, 3.4028235e38, 3.4028235e38))
            * material.k_d + min(sums.specular, float3(3.4028235e38, 3.4028235e38, 3.4028235e38))
            * material.k_s;
}

// The normal of the plane ax + by + cz + d = 0: (a, b, c)/|(a, b, c)|. Foley, van Dam et al. 11.1.3.
float3 shading_normal_plane(float a, float b, float c) {
    return shading_unit(float3(a, b, c));
}

// The normal of a triangle, counter-clockwise: (v2 - v1) x (v3 - v1), length 1. Foley, van Dam et al. 11.1.3.
float3 shading_normal_triangle(float3 v1, float3 v2, float3 v3) {
    return shading_unit(shading_crossed(v1, v2, v3));
}

// The normal of a sphere: (p - center)/|p - center|. Foley, van Dam et al. 15.10.1.
float3 shading_normal_sphere(float3 center, float3 p) {
    return shading_unit(shading_between(center, p));
}

// The normal of f(p) = 0 by the gradient of f, length 1. Foley, van Dam et al. 11.4.
float3 shading_normal_from_gradient(float3 gradient) {
    return shading_unit(gradient);
}

// The normal of s(u, v): ds/du x ds/dv, length 1. Foley, van Dam et al. 11.3.4.
float3 shading_normal_from_tangents(float3 s_u, float3 s_v) {
    return shading_unit(shading_crossed(float3(0.0, 0.0, 0.0), s_u, s_v));
}

// N toward the eye: N if F.V >= 0, else -N, where F is the normal of the face. GLSL 4.60, 8.5.
float3 shading_normal_facing(float3 n, float3 v, float3 f) {
    return dot(-f, v) > 0.0 ? -n : n;
}

// A normal transformed by the matrix of the columns a, b, c: cof(M) N, length 1. Lengyel 2024.
float3 shading_normal_transformed(float3 n, float3 a, float3 b, float3 c) {
    if (shading_is_extreme(dot(a, a)) || shading_is_extreme(dot(b, b)) || shading_is_extreme(dot(c, c))) {
        float3 t1 = shading_unit(b) + b * 0.0;
        float3 t2 = shading_unit(c) + c * 0.0;
        float t3 = abs(n.x);
        shading_Measured t4 = shading_measured(a);
        float t5 = abs(n.y);
        shading_Measured t6 = shading_measured(b);
        float t7 = abs(n.z);
        shading_Measured t8 = shading_measured(c);
        float t9 = min(min(t3 > 0.0 ? t4.length : 3.4028235e38, t5 > 0.0 ? t6.length : 3.4028235e38), t7 > 0.0
                ? t8.length : 3.4028235e38);
        float3 t10 = shading_unit(a) + a * 0.0;
        return shading_unit(cross(t1, t2) * (t3 > 0.0 ? n.x * (t4.length > t9 ? t9 / t4.length : 1.0) : 0.0)
                + cross(t2, t10) * (t5 > 0.0 ? n.y * (t6.length > t9 ? t9 / t6.length : 1.0) : 0.0)
                + cross(t10, t1) * (t7 > 0.0 ? n.z * (t8.length > t9 ? t9 / t8.length : 1.0) : 0.0));
    }
    return shading_unit(cross(b, c) * n.x + cross(c, a) * n.y + cross(a, b) * n.z);
}

// A triangle's normal times its angle at v1, to be summed over a mesh. Thuermer and Wuethrich 1998.
float3 shading_normal_corner(float3 v1, float3 v2, float3 v3) {
    float3 t1 = shading_between(v1, v2);
    float3 t2 = shading_between(v1, v3);
    shading_Measured t3 = shading_measured(cross(t1, t2));
    float t1_dot_t2 = dot(t1, t2);
    float t4 = abs(t1_dot_t2);
    float t5 = t4 * 2.4142137 > t3.length ? (t1_dot_t2 > 0.0 ? 1.0 : -1.0) : 0.0;
    float t6 = t3.length > t4 * 0.41421357 ? 1.0 : 0.0;
    float t7 = (t5 * t3.length - t6 * t1_dot_t2) / (t5 * t1_dot_t2 + t6 * t3.length);
    float t8 = t7 * t7;
    float t9 = t8 * t8;
    float t10 = t9 * t9;
    return (t3.w_length > 0.0 ? t3.w / t3.w_length : float3(0.0, 0.0, 0.0))
            * max(1.5707964 - t5 * (1.5707964 - t6 * 0.7853982)
            + (t7 + t7 * (t8 * (-0.33333334 + t8 * 0.2 + t9 * (-0.14285715 + t8 * 0.111111104) + t10
            * (-0.0909089 + t8 * 0.07691945 + t9 * (-0.06661951 + t8 * 0.05840374) + t10
            * (-0.050085507 + t8 * 0.03734732 + t9 * -0.01718003))))), 0.0);
}

// The tangent of a triangle and its handedness, by the texture coordinates of its vertices. Lengyel 2001.
shading_Tangent shading_normal_tangent(float3 v1, float3 v2, float3 v3, float2 uv1, float2 uv2, float2 uv3) {
    float3 t1 = v1 * 0.5;
    float3 t2 = v2 * 0.5 - t1;
    float3 t3 = v3 * 0.5 - t1;
    float t4 = max(shading_measured(t2).length, shading_measured(t3).length);
    float t5 = uv1.y * 0.5;
    float t6 = uv3.y * 0.5 - t5;
    float t7 = uv2.y * 0.5 - t5;
    float t8 = max(abs(t7), abs(t6));
    float t9 = t6 / t8;
    float t10 = t7 / t8;
    float t11 = uv1.x * 0.5;
    float t12 = uv2.x * 0.5 - t11;
    float t13 = uv3.x * 0.5 - t11;
    float t14 = max(abs(t12), abs(t13));
    float t15 = t12 / t14 * t9 - t13 / t14 * t10;
    float t16 = t15 > 0.0 ? 1.0 : -1.0;
    shading_Measured t17 = shading_measured((t2 / t4 * t9 - t3 / t4 * t10) * t16);
    if (!(t17.w_length > 0.0 && abs(t15) > 0.0)) {
        shading_Tangent result = {float3(0.0, 0.0, 0.0), 0.0};
        return result;
    }
    shading_Tangent result = {t17.w / t17.w_length, t16};
    return result;
}

// A normal from a map: x t + y b + z N, length 1. glTF 2.0, 3.7.2.1.
float3 shading_normal_mapped(float3 n, float3 tangent, float h, float3 s) {
    shading_Measured t1 = shading_measured(shading_crossed(float3(0.0, 0.0, 0.0), n, tangent));
    shading_Measured t2 = shading_measured(s);
    if (!(t1.w_length > 0.0 && t2.w_length > 0.0)) {
        return float3(0.0, 0.0, 0.0);
    }
    float3 t3 = t1.w / t1.w_length;
    return shading_unit(cross(t3, n) * (t2.w.x / t2.w_length) + t3 * (h > 0.0 ? 1.0 : -1.0)
            * (t2.w.y / t2.w_length) + n * (t2.w.z / t2.w_length));
}

#endif
