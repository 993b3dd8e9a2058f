// shading: Lambert, Phong and Blinn-Phong in linear light. MIT or Apache 2.0.
// Written by the package shading-languages from the source of the crate shading; do not edit it.
// All directions have length 1 and point away from the surface. A direction that does not exist is 0.
// Numbers are finite, and light, reflectances and the shininess m at least 0; then no result is NaN or negative light.

// A light of any kind. A sun has its direction L for a position; a lamp has the cosines -1.
struct shading_Light {
    position: vec3f,
    is_sun: f32,
    intensity: vec3f,
    limit: f32,
    coefficients: vec3f,
    range: f32,
    axis: vec3f,
    is_smoothstep: f32,
    cosines: vec2f,
    is_gltf: f32,
}

// The reflectances of a surface, and its shininess m.
struct shading_Material {
    k_a: vec3f,
    m: f32,
    k_d: vec3f,
    k_s: vec3f,
}

// What arrives at a point from one light: L, the distance q and I.
struct shading_Arrival {
    l: vec3f,
    q: f32,
    i: vec3f,
}

// The sums over lights of I max(0, N.L) and of I times the highlight. They begin as 0.
struct shading_Sums {
    diffuse: vec3f,
    specular: vec3f,
}

// The tangent t of a triangle with texture coordinates, and its handedness h.
struct shading_Tangent {
    t: vec3f,
    h: f32,
}

// A vector w of the direction of another, whose square is in range, |w|, and the length of the other.
struct shading_Measured {
    w: vec3f,
    w_length: f32,
    length: f32,
}

// Whether a square is so small or large that it is not exact.
fn shading_is_extreme(square: f32) -> bool {
    return !(square >= 7.888609e-31 && square < 1.2676506e30);
}

// e of x = 2^e z, where z is within [least, 2 least).
fn shading_exponent(x: f32, least: f32) -> f32 {
    return f32((bitcast<i32>(x) - bitcast<i32>(least)) >> 23);
}

// z of x = 2^e z.
fn shading_significand(x: f32, least: f32) -> f32 {
    let above = bitcast<i32>(x) - bitcast<i32>(least);
    return bitcast<f32>(bitcast<i32>(x) - (above & -0x800000));
}

// 2^(n - 127) for the low byte n of the bits of x.
fn shading_two_to_low_bits(x: f32) -> f32 {
    return bitcast<f32>(bitcast<i32>(x) << 23);
}

// How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart.
fn shading_steps_above(x: f32, shift: f32) -> f32 {
    return f32(bitcast<i32>(x) - bitcast<i32>(shift));
}

// (c/d)^m for c/d within [0, 1] and m >= 0, by the crate's own logarithm: within 2^-22.
fn shading_power_of_quotient(c: f32, d: f32, m: f32) -> f32 {
    let t1 = c * 16777216.0;
    let t2 = d * 11863283.0;
    let t3 = shading_significand(t1, t2);
    let t4 = d * 16777216.0;
    let t5 = (t3 - t4) / (t3 + t4);
    let t6 = t5 * t5;
    let t7 = max(min(m * (shading_exponent(t1, t2) + t5
            * (2.8853905 + t6 * 0.9615518 + t6 * t6 * 0.59732693)), 0.0), -126.0);
    let t8 = t7 + 12583038.0;
    let t9 = t7 - shading_steps_above(t8, 12583038.0);
    let t10 = t9 * t9;
    return (2.0 + t9 + t9 * (0.38629442 + 0.4804531 * t9 + t10 * (0.111006565 + 0.019235516 * t9) + t10 * t10
            * (0.0026797508 + 0.00031013472 * t9))) * shading_two_to_low_bits(t8);
}

// c^m for c within [0, 1] and m >= 0, within 2^-22.
fn shading_power(c: f32, m: f32) -> f32 {
    let t1 = c * 16777216.0;
    let t2 = shading_significand(t1, 11863283.0);
    let t3 = (t2 - 16777216.0) / (t2 + 16777216.0);
    let t4 = t3 * t3;
    let t5 = max(m * (shading_exponent(t1, 11863283.0) + t3
            * (2.8853905 + t4 * 0.9615518 + t4 * t4 * 0.59732693)), -126.0);
    let t6 = t5 + 12583038.0;
    let t7 = t5 - shading_steps_above(t6, 12583038.0);
    let t8 = t7 * t7;
    return (2.0 + t7 + t7 * (0.38629442 + 0.4804531 * t7 + t8 * (0.111006565 + 0.019235516 * t7) + t8 * t8
            * (0.0026797508 + 0.00031013472 * t7))) * shading_two_to_low_bits(t6);
}

// The length of v, and w in its direction: v itself, or v times a power of 2 where its square is out of range.
fn shading_measured(v: vec3f) -> shading_Measured {
    let square = dot(v, v);
    if shading_is_extreme(square) {
        let t1 = select(7.888609e-31, select(1.0, 1.2676506e30, square < 7.888609e-31),
                square < 1.2676506e30);
        let t2 = v * min(t1, 1.0) * max(t1, 1.0);
        let t2_dot_t2 = dot(t2, t2);
        let t3 = sqrt(t2_dot_t2);
        return shading_Measured(t2, select(0.0, t3, t2_dot_t2 > 0.0 && t2_dot_t2 < 3.4028235e38),
                select(t3, min(t3 / t1, 3.4028235e38), t2_dot_t2 > 0.0 && t2_dot_t2 < 3.4028235e38));
    }
    let t1 = sqrt(square);
    return shading_Measured(v, t1, t1);
}

// v/|v|; 0 where v is 0.
fn shading_unit(v: vec3f) -> vec3f {
    let of = shading_measured(v);
    return select(vec3f(0.0), of.w / of.w_length, of.w_length > 0.0);
}

// The vector from a point to another, times a power of 2 where its square is out of range.
fn shading_between(origin: vec3f, p: vec3f) -> vec3f {
    let v = p - origin;
    let square = dot(v, v);
    if shading_is_extreme(square) {
        let t1 = select(7.888609e-31, select(1.0, 1.2676506e30, square < 7.888609e-31),
                square < 1.2676506e30);
        let t2 = min(t1, 1.0);
        return (p * t2 - origin * t2) * max(t1, 1.0);
    }
    return v;
}

// (a - origin) x (b - origin), in the right direction even where its square is out of range.
fn shading_crossed(origin: vec3f, a: vec3f, b: vec3f) -> vec3f {
    let c = cross(a - origin, b - origin);
    if shading_is_extreme(dot(c, c)) {
        return cross(shading_between(origin, a), shading_between(origin, b));
    }
    return c;
}

// The reflection vector R = 2(N.L)N - L. Phong 1975; Foley, van Dam et al. 16.1.
fn shading_reflection(n: vec3f, l: vec3f) -> vec3f {
    let n_dot_l = dot(n, l);
    return n * (n_dot_l + n_dot_l) - l;
}

// The half vector H = (L + V)/|L + V|; 0 where L = -V. Blinn 1977.
fn shading_half_vector(l: vec3f, v: vec3f) -> vec3f {
    return shading_unit(l + v);
}

// The ambient term k_a I_a. Foley, van Dam et al. 16.1.
fn shading_term_ambient(k_a: vec3f, i_a: vec3f) -> vec3f {
    return k_a * i_a;
}

// Lambert's factor max(0, N.L). Lambert 1760.
fn shading_term_lambert(n: vec3f, l: vec3f) -> f32 {
    return max(dot(n, l), 0.0);
}

// Phong's highlight max(0, R.V)^m. Phong 1975.
fn shading_term_phong(r: vec3f, v: vec3f, m: f32) -> f32 {
    let r_dot_v = dot(r, v);
    return select(0.0, shading_power(clamp(r_dot_v, 0.0, 1.0), max(m, 0.0)), r_dot_v > 0.0);
}

// Blinn's highlight max(0, N.H)^m. Blinn 1977.
fn shading_term_blinn(n: vec3f, h: vec3f, m: f32) -> f32 {
    let n_dot_h = dot(n, h);
    return select(0.0, shading_power(clamp(n_dot_h, 0.0, 1.0), max(m, 0.0)), n_dot_h > 0.0);
}

// What makes Phong's highlight reflect at most k_s: (m + 2)/(2 pi). Lafortune and Willems 1994.
fn shading_term_phong_normalization(m: f32) -> f32 {
    return (max(m, 0.0) + 2.0) * 0.15915494;
}

// The same of Blinn's: (m + 2)(m + 4)/(8 pi (2^(-m/2) + m)). Giesen 2009.
fn shading_term_blinn_normalization(m: f32) -> f32 {
    let exponent = max(m, 0.0);
    return (exponent + 2.0) * 0.039788734
            * ((exponent + 4.0) / (exponent + shading_power(0.70710677, max(exponent, 0.0))));
}

// The attenuation 1/(a + bq + cq^2). Foley, van Dam et al. 16.1; OpenGL 2.1, 2.14.1.
fn shading_attenuation(a: f32, b: f32, c: f32, q: f32) -> f32 {
    return clamp(1.0 / (a + q * (b + c * q)), 0.0, 3.4028235e38);
}

// What ends a light at the range r: max(0, 1 - (q/r)^4)^2. Karis 2013.
fn shading_window(q: f32, r: f32) -> f32 {
    let fraction = q / r;
    let square = fraction * fraction;
    let root = max(1.0 - square * square, 0.0);
    return root * root;
}

// The same without the square: KHR_lights_punctual.
fn shading_window_gltf(q: f32, r: f32) -> f32 {
    let fraction = q / r;
    let square = fraction * fraction;
    return max(1.0 - square * square, 0.0);
}

// t^2, where t rises from 0 at the cosine of the outer edge to 1 at that of the inner. KHR_lights_punctual.
fn shading_beam(cosine: f32, inner: f32, outer: f32) -> f32 {
    if !(inner > outer) {
        return select(1.0, 0.0, inner > cosine);
    }
    let t = clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    return select(1.0, t * t, inner > cosine);
}

// The same with t^2(3 - 2t). POV-Ray 3.7.
fn shading_beam_smoothstep(cosine: f32, inner: f32, outer: f32) -> f32 {
    if !(inner > outer) {
        return select(1.0, 0.0, inner > cosine);
    }
    let t = clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    return select(1.0, min(t * t * (3.0 - (t + t)), 1.0), inner > cosine);
}

// The factor of a spot's cone, given the cosines of its inner and its outer half-angle.
fn shading_cone(axis: vec3f, l: vec3f, cosines: vec2f) -> f32 {
    return shading_beam(dot(-axis, l), select(min(cosines.x, 0.9999995), -2.0, cosines.x < -0.9999995),
            select(min(cosines.y, 0.9999995), -2.0, cosines.x < -0.9999995));
}

// The same with a smoothstep between the edges.
fn shading_cone_smoothstep(axis: vec3f, l: vec3f, cosines: vec2f) -> f32 {
    return shading_beam_smoothstep(dot(-axis, l),
            select(min(cosines.x, 0.9999995), -2.0, cosines.x < -0.9999995),
            select(min(cosines.y, 0.9999995), -2.0, cosines.x < -0.9999995));
}

// What arrives at the point p: L, the distance q and I. Foley, van Dam et al. 16.1.
fn shading_arrival(light: shading_Light, p: vec3f) -> shading_Arrival {
    if light.is_sun > 0.0 {
        return shading_Arrival(light.position, 3.4028235e38, light.intensity);
    }
    let to_light = shading_measured(light.position - p);
    let t1 = dot(-light.axis, to_light.w) / to_light.w_length;
    let t2 = select(min(light.cosines.x, 0.9999995), -2.0, light.cosines.x < -0.9999995);
    let t3 = select(min(light.cosines.y, 0.9999995), -2.0, light.cosines.x < -0.9999995);
    return shading_Arrival(select(vec3f(0.0, 0.0, 1.0), to_light.w / to_light.w_length,
            to_light.w_length > 0.0), min(to_light.length, 3.4028235e38),
            min(light.intensity * select(0.0,
            clamp(1.0 / (light.coefficients.x + to_light.length
            * (light.coefficients.y + light.coefficients.z * to_light.length)), 0.0, light.limit)
            * select(1.0, select(shading_window(to_light.length, light.range),
            shading_window_gltf(to_light.length, light.range), light.is_gltf > 0.0),
            light.range < 3.4028235e38)
            * select(1.0, select(shading_beam(t1, t2, t3), shading_beam_smoothstep(t1, t2, t3),
            light.is_smoothstep > 0.0), light.cosines.x > -1.0), to_light.w_length > 0.0),
            vec3f(3.4028235e38)));
}

// What one light adds by Lambert's model: I k_d max(0, N.L).
fn shading_shade_lambert(n: vec3f, material: shading_Material, light: shading_Arrival) -> vec3f {
    let n_dot_l = dot(n, light.l);
    if !(n_dot_l > 0.0) {
        return vec3f(0.0);
    }
    return light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d;
}

// What one light adds by Phong's model: I (k_d N.L + k_s max(0, R.V)^m), where N.L > 0. Phong 1975.
fn shading_shade_phong(n: vec3f, v: vec3f, material: shading_Material, light: shading_Arrival) -> vec3f {
    let n_dot_l = dot(n, light.l);
    if !(n_dot_l > 0.0) {
        return vec3f(0.0);
    }
    let r = n * (n_dot_l + n_dot_l) - light.l;
    let r_dot_v = dot(r, v);
    return light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d + light.i
            * select(0.0, shading_power(clamp(r_dot_v, 0.0, 1.0), max(material.m, 0.0)), r_dot_v > 0.0)
            * material.k_s;
}

// What one light adds by Blinn and Phong's model: I (k_d N.L + k_s max(0, N.H)^m), where N.L > 0. Blinn 1977.
fn shading_shade_blinn_phong(n: vec3f, v: vec3f, material: shading_Material,
        light: shading_Arrival) -> vec3f {
    let n_dot_l = dot(n, light.l);
    if !(n_dot_l > 0.0) {
        return vec3f(0.0);
    }
    let h = light.l + v;
    let n_dot_h = dot(n, h);
    return light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d + light.i
            * select(0.0, shading_power_of_quotient(n_dot_h * n_dot_h, dot(h, h), max(0.5 * material.m, 0.0)),
            n_dot_h > 0.0) * material.k_s;
}

// The sums over lights after one more, by Lambert's model. A light from behind adds nothing and costs no root.
fn shading_add_lambert(sums: shading_Sums, n: vec3f, light: shading_Light, p: vec3f) -> shading_Sums {
    if light.is_sun > 0.0 {
        let t1 = dot(n, light.position);
        if !(t1 > 0.0) {
            return shading_Sums(sums.diffuse, sums.specular);
        }
        return shading_Sums(sums.diffuse + light.intensity * clamp(t1, 0.0, 1.0), sums.specular);
    }
    let t1 = light.position - p;
    if !(dot(n, t1) > 0.0) {
        return shading_Sums(sums.diffuse, sums.specular);
    }
    let t2 = shading_measured(t1);
    let t3 = dot(-light.axis, t2.w) / t2.w_length;
    let t4 = select(min(light.cosines.x, 0.9999995), -2.0, light.cosines.x < -0.9999995);
    let t5 = select(min(light.cosines.y, 0.9999995), -2.0, light.cosines.x < -0.9999995);
    return shading_Sums(sums.diffuse + light.intensity
            * (clamp(1.0 / (light.coefficients.x + t2.length
            * (light.coefficients.y + light.coefficients.z * t2.length)), 0.0, light.limit)
            * select(1.0, select(shading_window(t2.length, light.range),
            shading_window_gltf(t2.length, light.range), light.is_gltf > 0.0), light.range < 3.4028235e38)
            * select(1.0, select(shading_beam(t3, t4, t5), shading_beam_smoothstep(t3, t4, t5),
            light.is_smoothstep > 0.0), light.cosines.x > -1.0)
            * clamp(dot(n, t2.w) / t2.w_length, 0.0, 1.0)), sums.specular);
}

// The same by Phong's model.
fn shading_add_phong(sums: shading_Sums, n: vec3f, v: vec3f, m: f32, light: shading_Light,
        p: vec3f) -> shading_Sums {
    if light.is_sun > 0.0 {
        let t1 = dot(n, light.position);
        if !(t1 > 0.0) {
            return shading_Sums(sums.diffuse, sums.specular);
        }
        let t2 = dot(n * (t1 + t1) - light.position, v);
        return shading_Sums(sums.diffuse + light.intensity * clamp(t1, 0.0, 1.0), sums.specular
                + light.intensity * select(0.0, shading_power(clamp(t2, 0.0, 1.0), max(m, 0.0)), t2 > 0.0));
    }
    let t1 = light.position - p;
    if !(dot(n, t1) > 0.0) {
        return shading_Sums(sums.diffuse, sums.specular);
    }
    let t2 = shading_measured(t1);
    let t3 = dot(-light.axis, t2.w) / t2.w_length;
    let t4 = select(min(light.cosines.x, 0.9999995), -2.0, light.cosines.x < -0.9999995);
    let t5 = select(min(light.cosines.y, 0.9999995), -2.0, light.cosines.x < -0.9999995);
    let t6 = clamp(1.0 / (light.coefficients.x + t2.length
            * (light.coefficients.y + light.coefficients.z * t2.length)), 0.0, light.limit)
            * select(1.0, select(shading_window(t2.length, light.range),
            shading_window_gltf(t2.length, light.range), light.is_gltf > 0.0), light.range < 3.4028235e38)
            * select(1.0, select(shading_beam(t3, t4, t5), shading_beam_smoothstep(t3, t4, t5),
            light.is_smoothstep > 0.0), light.cosines.x > -1.0);
    let t7 = dot(n, t2.w);
    let t8 = dot(n * (t7 + t7) - t2.w, v) / t2.w_length;
    return shading_Sums(sums.diffuse + light.intensity * (t6 * clamp(t7 / t2.w_length, 0.0, 1.0)),
            sums.specular + light.intensity
            * (t6 * select(0.0, shading_power(clamp(t8, 0.0, 1.0), max(m, 0.0)), t8 > 0.0)));
}

// The same by Blinn and Phong's model.
fn shading_add_blinn_phong(sums: shading_Sums, n: vec3f, v: vec3f, m: f32, light: shading_Light,
        p: vec3f) -> shading_Sums {
    if light.is_sun > 0.0 {
        let t1 = dot(n, light.position);
        if !(t1 > 0.0) {
            return shading_Sums(sums.diffuse, sums.specular);
        }
        let t2 = light.position + v;
        let n_dot_t2 = dot(n, t2);
        return shading_Sums(sums.diffuse + light.intensity * clamp(t1, 0.0, 1.0), sums.specular
                + light.intensity * select(0.0,
                shading_power_of_quotient(n_dot_t2 * n_dot_t2, dot(t2, t2), max(0.5 * m, 0.0)),
                n_dot_t2 > 0.0));
    }
    let t1 = light.position - p;
    if !(dot(n, t1) > 0.0) {
        return shading_Sums(sums.diffuse, sums.specular);
    }
    let t2 = shading_measured(t1);
    let t3 = dot(-light.axis, t2.w) / t2.w_length;
    let t4 = select(min(light.cosines.x, 0.9999995), -2.0, light.cosines.x < -0.9999995);
    let t5 = select(min(light.cosines.y, 0.9999995), -2.0, light.cosines.x < -0.9999995);
    let t6 = clamp(1.0 / (light.coefficients.x + t2.length
            * (light.coefficients.y + light.coefficients.z * t2.length)), 0.0, light.limit)
            * select(1.0, select(shading_window(t2.length, light.range),
            shading_window_gltf(t2.length, light.range), light.is_gltf > 0.0), light.range < 3.4028235e38)
            * select(1.0, select(shading_beam(t3, t4, t5), shading_beam_smoothstep(t3, t4, t5),
            light.is_smoothstep > 0.0), light.cosines.x > -1.0);
    let t7 = t2.w + v * t2.w_length;
    let n_dot_t7 = dot(n, t7);
    return shading_Sums(sums.diffuse + light.intensity * (t6 * clamp(dot(n, t2.w) / t2.w_length, 0.0, 1.0)),
            sums.specular + light.intensity
            * (t6 * select(0.0, shading_power_of_quotient(n_dot_t7 * n_dot_t7, dot(t7, t7),
            max(0.5 * m, 0.0)), n_dot_t7 > 0.0)));
}

// The light that the point reflects: k_a I_a + k_d times the diffuse sum + k_s times the specular one.
fn shading_total(sums: shading_Sums, material: shading_Material, i_a: vec3f) -> vec3f {
    return material.k_a * i_a + min(sums.diffuse, vec3f(3.4028235e38)) * material.k_d
            + min(sums.specular, vec3f(3.4028235e38)) * material.k_s;
}

// The normal of the plane ax + by + cz + d = 0: (a, b, c)/|(a, b, c)|. Foley, van Dam et al. 11.1.3.
fn shading_normal_plane(a: f32, b: f32, c: f32) -> vec3f {
    return shading_unit(vec3f(a, b, c));
}

// The normal of a triangle, counter-clockwise: (v2 - v1) x (v3 - v1), length 1. Foley, van Dam et al. 11.1.3.
fn shading_normal_triangle(v1: vec3f, v2: vec3f, v3: vec3f) -> vec3f {
    return shading_unit(shading_crossed(v1, v2, v3));
}

// The normal of a sphere: (p - center)/|p - center|. Foley, van Dam et al. 15.10.1.
fn shading_normal_sphere(center: vec3f, p: vec3f) -> vec3f {
    return shading_unit(shading_between(center, p));
}

// The normal of f(p) = 0 by the gradient of f, length 1. Foley, van Dam et al. 11.4.
fn shading_normal_from_gradient(gradient: vec3f) -> vec3f {
    return shading_unit(gradient);
}

// The normal of s(u, v): ds/du x ds/dv, length 1. Foley, van Dam et al. 11.3.4.
fn shading_normal_from_tangents(s_u: vec3f, s_v: vec3f) -> vec3f {
    return shading_unit(shading_crossed(vec3f(0.0), s_u, s_v));
}

// N toward the eye: N if F.V >= 0, else -N, where F is the normal of the face. GLSL 4.60, 8.5.
fn shading_normal_facing(n: vec3f, v: vec3f, f: vec3f) -> vec3f {
    return select(n, -n, dot(-f, v) > 0.0);
}

// A normal transformed by the matrix of the columns a, b, c: cof(M) N, length 1. Lengyel 2024.
fn shading_normal_transformed(n: vec3f, a: vec3f, b: vec3f, c: vec3f) -> vec3f {
    if shading_is_extreme(dot(a, a)) || shading_is_extreme(dot(b, b)) || shading_is_extreme(dot(c, c)) {
        let t1 = shading_unit(b) + b * 0.0;
        let t2 = shading_unit(c) + c * 0.0;
        let t3 = abs(n.x);
        let t4 = shading_measured(a);
        let t5 = abs(n.y);
        let t6 = shading_measured(b);
        let t7 = abs(n.z);
        let t8 = shading_measured(c);
        let t9 = min(min(select(3.4028235e38, t4.length, t3 > 0.0),
                select(3.4028235e38, t6.length, t5 > 0.0)), select(3.4028235e38, t8.length, t7 > 0.0));
        let t10 = shading_unit(a) + a * 0.0;
        return shading_unit(cross(t1, t2)
                * select(0.0, n.x * select(1.0, t9 / t4.length, t4.length > t9), t3 > 0.0) + cross(t2, t10)
                * select(0.0, n.y * select(1.0, t9 / t6.length, t6.length > t9), t5 > 0.0) + cross(t10, t1)
                * select(0.0, n.z * select(1.0, t9 / t8.length, t8.length > t9), t7 > 0.0));
    }
    return shading_unit(cross(b, c) * n.x + cross(c, a) * n.y + cross(a, b) * n.z);
}

// A triangle's normal times its angle at v1, to be summed over a mesh. Thuermer and Wuethrich 1998.
fn shading_normal_corner(v1: vec3f, v2: vec3f, v3: vec3f) -> vec3f {
    let t1 = shading_between(v1, v2);
    let t2 = shading_between(v1, v3);
    let t3 = shading_measured(cross(t1, t2));
    let t1_dot_t2 = dot(t1, t2);
    let t4 = abs(t1_dot_t2);
    let t5 = select(0.0, select(-1.0, 1.0, t1_dot_t2 > 0.0), t4 * 2.4142137 > t3.length);
    let t6 = select(0.0, 1.0, t3.length > t4 * 0.41421357);
    let t7 = (t5 * t3.length - t6 * t1_dot_t2) / (t5 * t1_dot_t2 + t6 * t3.length);
    let t8 = t7 * t7;
    let t9 = t8 * t8;
    let t10 = t9 * t9;
    return select(vec3f(0.0), t3.w / t3.w_length, t3.w_length > 0.0)
            * max(1.5707964 - t5 * (1.5707964 - t6 * 0.7853982)
            + (t7 + t7 * (t8 * (-0.33333334 + t8 * 0.2 + t9 * (-0.14285715 + t8 * 0.111111104) + t10
            * (-0.0909089 + t8 * 0.07691945 + t9 * (-0.06661951 + t8 * 0.05840374) + t10
            * (-0.050085507 + t8 * 0.03734732 + t9 * -0.01718003))))), 0.0);
}

// The tangent of a triangle and its handedness, by the texture coordinates of its vertices. Lengyel 2001.
fn shading_normal_tangent(v1: vec3f, v2: vec3f, v3: vec3f, uv1: vec2f, uv2: vec2f,
        uv3: vec2f) -> shading_Tangent {
    let t1 = v1 * 0.5;
    let t2 = v2 * 0.5 - t1;
    let t3 = v3 * 0.5 - t1;
    let t4 = max(shading_measured(t2).length, shading_measured(t3).length);
    let t5 = uv1.y * 0.5;
    let t6 = uv3.y * 0.5 - t5;
    let t7 = uv2.y * 0.5 - t5;
    let t8 = max(abs(t7), abs(t6));
    let t9 = t6 / t8;
    let t10 = t7 / t8;
    let t11 = uv1.x * 0.5;
    let t12 = uv2.x * 0.5 - t11;
    let t13 = uv3.x * 0.5 - t11;
    let t14 = max(abs(t12), abs(t13));
    let t15 = t12 / t14 * t9 - t13 / t14 * t10;
    let t16 = select(-1.0, 1.0, t15 > 0.0);
    let t17 = shading_measured((t2 / t4 * t9 - t3 / t4 * t10) * t16);
    if !(t17.w_length > 0.0 && abs(t15) > 0.0) {
        return shading_Tangent(vec3f(0.0), 0.0);
    }
    return shading_Tangent(t17.w / t17.w_length, t16);
}

// A normal from a map: x t + y b + z N, length 1. glTF 2.0, 3.7.2.1.
fn shading_normal_mapped(n: vec3f, tangent: vec3f, h: f32, s: vec3f) -> vec3f {
    let t1 = shading_measured(shading_crossed(vec3f(0.0), n, tangent));
    let t2 = shading_measured(s);
    if !(t1.w_length > 0.0 && t2.w_length > 0.0) {
        return vec3f(0.0);
    }
    let t3 = t1.w / t1.w_length;
    return shading_unit(cross(t3, n) * (t2.w.x / t2.w_length) + t3 * select(-1.0, 1.0, h > 0.0)
            * (t2.w.y / t2.w_length) + n * (t2.w.z / t2.w_length));
}

