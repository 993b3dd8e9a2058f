// shading: Lambert, Phong and Blinn-Phong in linear light. MIT or Apache 2.0.
// Written by the package shading-languages from the source of the crate shading; do not edit it.
// All directions have length 1 and point away from the surface. A direction that does not exist is 0.
// Numbers are finite, and light, reflectances and the shininess m at least 0; then no result is NaN or negative light.
// Tried with 860,000 calls and numbers from 1e-45 to 1e38, in WGSL on Mesa's llvmpipe and in GLSL in Chromium's SwiftShader:
// with the crate's own power, 0.998 and 0.963 of the results were the crate's; with the language's, 0.950 and 0.957.

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
    v_length: f32,
}

// (c/d)^m for c/d within [0, 1] and m >= 0, by the language's own power.
fn shading_power_of_quotient(c: f32, d: f32, m: f32) -> f32 {
    return pow(min(c / d, 1.0), m);
}

// c^m for c within [0, 1] and m >= 0, by the language's own power.
fn shading_power(c: f32, m: f32) -> f32 {
    return pow(c, m);
}

// Whether a square is so small or large that it is not exact.
fn shading_is_extreme(square: f32) -> bool {
    return !(square >= 7.888609e-31 && square < 1.2676506e30);
}

// The length of v, and w in its direction: v itself, or v times a power of 2 where its square is out of range.
fn shading_measured(v: vec3f) -> shading_Measured {
    let square = dot(v, v);
    if shading_is_extreme(square) {
        let power = select(7.888609e-31, select(1.0, 1.2676506e30, square < 7.888609e-31),
                square < 1.2676506e30);
        let w = v * min(power, 1.0) * max(power, 1.0);
        let w_square = dot(w, w);
        let root = sqrt(w_square);
        return shading_Measured(w, select(0.0, root, w_square > 0.0 && w_square < 3.4028234e38),
                select(root, min(root / power, 3.4028234e38), w_square > 0.0 && w_square < 3.4028234e38));
    }
    let length = sqrt(square);
    return shading_Measured(v, length, length);
}

// v/|v|; 0 where v is 0.
fn shading_unit(v: vec3f) -> vec3f {
    let way = shading_measured(v);
    return select(vec3f(0.0), way.w / way.w_length, way.w_length > 0.0);
}

// The vector from a point to another, times a power of 2 where its square is out of range.
fn shading_between(origin: vec3f, p: vec3f) -> vec3f {
    let v = p - origin;
    let square = dot(v, v);
    if shading_is_extreme(square) {
        let power = select(7.888609e-31, select(1.0, 1.2676506e30, square < 7.888609e-31),
                square < 1.2676506e30);
        let shrink = min(power, 1.0);
        return (p * shrink - origin * shrink) * max(power, 1.0);
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
    return clamp(1.0 / (a + q * (b + c * q)), 0.0, 3.4028234e38);
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
    let inner = select(min(cosines.x, 0.9999995), -2.0, cosines.x < -0.9999995);
    let outer = select(min(cosines.y, 0.9999995), -2.0, cosines.x < -0.9999995);
    return shading_beam(dot(-axis, l), inner, outer);
}

// The same with a smoothstep between the edges.
fn shading_cone_smoothstep(axis: vec3f, l: vec3f, cosines: vec2f) -> f32 {
    let cosine = dot(-axis, l);
    let inner = select(min(cosines.x, 0.9999995), -2.0, cosines.x < -0.9999995);
    let outer = select(min(cosines.y, 0.9999995), -2.0, cosines.x < -0.9999995);
    return shading_beam_smoothstep(cosine, inner, outer);
}

// What dims a light after the distance q: its attenuation, at most its limit, and the window of its range.
fn shading_falloff(light: shading_Light, q: f32) -> f32 {
    return clamp(1.0 / (light.coefficients.x + q * (light.coefficients.y + light.coefficients.z * q)), 0.0,
            light.limit) * select(1.0,
            select(shading_window(q, light.range), shading_window_gltf(q, light.range), light.is_gltf > 0.0),
            light.range < 3.4028234e38);
}

// The factor of a spot's cone, by the cosine between its axis and -L.
fn shading_spot(light: shading_Light, cosine: f32) -> f32 {
    let inner = select(min(light.cosines.x, 0.9999995), -2.0, light.cosines.x < -0.9999995);
    let outer = select(min(light.cosines.y, 0.9999995), -2.0, light.cosines.x < -0.9999995);
    return select(shading_beam(cosine, inner, outer), shading_beam_smoothstep(cosine, inner, outer),
            light.is_smoothstep > 0.0);
}

// What arrives at the point p: L, the distance q and I. Foley, van Dam et al. 16.1.
fn shading_arrival(light: shading_Light, p: vec3f) -> shading_Arrival {
    if light.is_sun > 0.0 {
        return shading_Arrival(light.position, 3.4028234e38, light.intensity);
    }
    let to_light = shading_measured(light.position - p);
    if !(to_light.w_length > 0.0) {
        return shading_Arrival(vec3f(0.0, 0.0, 1.0), min(to_light.v_length, 3.4028234e38), vec3f(0.0));
    }
    let dimmed = shading_falloff(light, to_light.v_length)
            * select(1.0, shading_spot(light, dot(-light.axis, to_light.w) / to_light.w_length),
            light.cosines.x > -1.0);
    return shading_Arrival(to_light.w / to_light.w_length, min(to_light.v_length, 3.4028234e38),
            min(light.intensity * dimmed, vec3f(3.4028234e38)));
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
    let diffuse = light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d;
    let r = n * (n_dot_l + n_dot_l) - light.l;
    let r_dot_v = dot(r, v);
    let highlight = select(0.0, shading_power(clamp(r_dot_v, 0.0, 1.0), max(material.m, 0.0)), r_dot_v > 0.0);
    let specular = light.i * highlight * material.k_s;
    return diffuse + specular;
}

// What one light adds by Blinn and Phong's model: I (k_d N.L + k_s max(0, N.H)^m), where N.L > 0. Blinn 1977.
fn shading_shade_blinn_phong(n: vec3f, v: vec3f, material: shading_Material,
        light: shading_Arrival) -> vec3f {
    let n_dot_l = dot(n, light.l);
    if !(n_dot_l > 0.0) {
        return vec3f(0.0);
    }
    let diffuse = light.i * clamp(n_dot_l, 0.0, 1.0) * material.k_d;
    let h = light.l + v;
    let n_dot_h = dot(n, h);
    let highlight = select(0.0,
            shading_power_of_quotient(n_dot_h * n_dot_h, dot(h, h), max(0.5 * material.m, 0.0)),
            n_dot_h > 0.0);
    let specular = light.i * highlight * material.k_s;
    return diffuse + specular;
}

// The sums over lights after one more, by Lambert's model. A light from behind adds nothing and costs no root.
fn shading_add_lambert(sums: shading_Sums, n: vec3f, light: shading_Light, p: vec3f) -> shading_Sums {
    if light.is_sun > 0.0 {
        let n_dot_l = dot(n, light.position);
        if !(n_dot_l > 0.0) {
            return sums;
        }
        return shading_Sums(sums.diffuse + light.intensity * clamp(n_dot_l, 0.0, 1.0), sums.specular);
    }
    let way = light.position - p;
    if !(dot(n, way) > 0.0) {
        return sums;
    }
    let to_light = shading_measured(way);
    let dimmed = shading_falloff(light, to_light.v_length)
            * select(1.0, shading_spot(light, dot(-light.axis, to_light.w) / to_light.w_length),
            light.cosines.x > -1.0);
    return shading_Sums(sums.diffuse + light.intensity
            * (dimmed * clamp(dot(n, to_light.w) / to_light.w_length, 0.0, 1.0)), sums.specular);
}

// The same by Phong's model.
fn shading_add_phong(sums: shading_Sums, n: vec3f, v: vec3f, m: f32, light: shading_Light,
        p: vec3f) -> shading_Sums {
    if light.is_sun > 0.0 {
        let n_dot_l = dot(n, light.position);
        if !(n_dot_l > 0.0) {
            return sums;
        }
        let r_dot_v = dot(n * (n_dot_l + n_dot_l) - light.position, v);
        let highlight_of_sun = select(0.0, shading_power(clamp(r_dot_v, 0.0, 1.0), max(m, 0.0)),
                r_dot_v > 0.0);
        return shading_Sums(sums.diffuse + light.intensity * clamp(n_dot_l, 0.0, 1.0),
                sums.specular + light.intensity * highlight_of_sun);
    }
    let way = light.position - p;
    if !(dot(n, way) > 0.0) {
        return sums;
    }
    let to_light = shading_measured(way);
    let dimmed = shading_falloff(light, to_light.v_length)
            * select(1.0, shading_spot(light, dot(-light.axis, to_light.w) / to_light.w_length),
            light.cosines.x > -1.0);
    let n_dot_w = dot(n, to_light.w);
    let cosine = dot(n * (n_dot_w + n_dot_w) - to_light.w, v) / to_light.w_length;
    let highlight = select(0.0, shading_power(clamp(cosine, 0.0, 1.0), max(m, 0.0)), cosine > 0.0);
    return shading_Sums(sums.diffuse + light.intensity
            * (dimmed * clamp(n_dot_w / to_light.w_length, 0.0, 1.0)),
            sums.specular + light.intensity * (dimmed * highlight));
}

// The same by Blinn and Phong's model.
fn shading_add_blinn_phong(sums: shading_Sums, n: vec3f, v: vec3f, m: f32, light: shading_Light,
        p: vec3f) -> shading_Sums {
    if light.is_sun > 0.0 {
        let n_dot_l = dot(n, light.position);
        if !(n_dot_l > 0.0) {
            return sums;
        }
        let h = light.position + v;
        let n_dot_h = dot(n, h);
        let highlight_of_sun = select(0.0,
                shading_power_of_quotient(n_dot_h * n_dot_h, dot(h, h), max(0.5 * m, 0.0)), n_dot_h > 0.0);
        return shading_Sums(sums.diffuse + light.intensity * clamp(n_dot_l, 0.0, 1.0),
                sums.specular + light.intensity * highlight_of_sun);
    }
    let way = light.position - p;
    if !(dot(n, way) > 0.0) {
        return sums;
    }
    let to_light = shading_measured(way);
    let dimmed = shading_falloff(light, to_light.v_length)
            * select(1.0, shading_spot(light, dot(-light.axis, to_light.w) / to_light.w_length),
            light.cosines.x > -1.0);
    let halfway = to_light.w + v * to_light.w_length;
    let cosine = dot(n, halfway);
    let highlight = select(0.0,
            shading_power_of_quotient(cosine * cosine, dot(halfway, halfway), max(0.5 * m, 0.0)),
            cosine > 0.0);
    return shading_Sums(sums.diffuse + light.intensity
            * (dimmed * clamp(dot(n, to_light.w) / to_light.w_length, 0.0, 1.0)),
            sums.specular + light.intensity * (dimmed * highlight));
}

// The light that the point reflects: k_a I_a + k_d times the diffuse sum + k_s times the specular one.
fn shading_total(sums: shading_Sums, material: shading_Material, i_a: vec3f) -> vec3f {
    return material.k_a * i_a + min(sums.diffuse, vec3f(3.4028234e38)) * material.k_d
            + min(sums.specular, vec3f(3.4028234e38)) * material.k_s;
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
        let along_b = shading_unit(b) + b * 0.0;
        let along_c = shading_unit(c) + c * 0.0;
        let abs_x = abs(n.x);
        let x = shading_measured(a);
        let abs_y = abs(n.y);
        let y = shading_measured(b);
        let abs_z = abs(n.z);
        let z = shading_measured(c);
        let least = min(min(select(3.4028234e38, x.v_length, abs_x > 0.0),
                select(3.4028234e38, y.v_length, abs_y > 0.0)),
                select(3.4028234e38, z.v_length, abs_z > 0.0));
        let n_x = select(0.0, n.x * select(1.0, least / x.v_length, x.v_length > least), abs_x > 0.0);
        let along_a = shading_unit(a) + a * 0.0;
        let n_y = select(0.0, n.y * select(1.0, least / y.v_length, y.v_length > least), abs_y > 0.0);
        let n_z = select(0.0, n.z * select(1.0, least / z.v_length, z.v_length > least), abs_z > 0.0);
        return shading_unit(cross(along_b, along_c) * n_x + cross(along_c, along_a) * n_y
                + cross(along_a, along_b) * n_z);
    }
    return shading_unit(cross(b, c) * n.x + cross(c, a) * n.y + cross(a, b) * n.z);
}

// A triangle's normal times its angle at v1, to be summed over a mesh. Thuermer and Wuethrich 1998.
fn shading_normal_corner(v1: vec3f, v2: vec3f, v3: vec3f) -> vec3f {
    let e1 = shading_between(v1, v2);
    let e2 = shading_between(v1, v3);
    let c = shading_measured(cross(e1, e2));
    let cosine = dot(e1, e2);
    let adjacent = abs(cosine);
    let x = select(0.0, select(-1.0, 1.0, cosine > 0.0), adjacent * 2.4142137 > c.v_length);
    let y = select(0.0, 1.0, c.v_length > adjacent * 0.41421357);
    let t = (x * c.v_length - y * cosine) / (x * cosine + y * c.v_length);
    let z = t * t;
    let z2 = z * z;
    let z4 = z2 * z2;
    let series = -0.33333334 + z * 0.2 + z2 * (-0.14285715 + z * 0.111111104) + z4
            * (-0.0909089 + z * 0.07691945 + z2 * (-0.06661951 + z * 0.05840374) + z4
            * (-0.050085507 + z * 0.03734732 + z2 * -0.01718003));
    let arctangent = t + t * (z * series);
    let angle = max(1.5707964 - x * (1.5707964 - y * 0.7853982) + arctangent, 0.0);
    return select(vec3f(0.0), c.w / c.w_length, c.w_length > 0.0) * angle;
}

// The tangent of a triangle and its handedness, by the texture coordinates of its vertices. Lengyel 2001.
fn shading_normal_tangent(v1: vec3f, v2: vec3f, v3: vec3f, uv1: vec2f, uv2: vec2f,
        uv3: vec2f) -> shading_Tangent {
    let half_v1 = v1 * 0.5;
    let e2 = v2 * 0.5 - half_v1;
    let e3 = v3 * 0.5 - half_v1;
    let edge = max(shading_measured(e2).v_length, shading_measured(e3).v_length);
    let half_y = uv1.y * 0.5;
    let y3 = uv3.y * 0.5 - half_y;
    let y2 = uv2.y * 0.5 - half_y;
    let y_size = max(abs(y2), abs(y3));
    let y3_part = y3 / y_size;
    let y2_part = y2 / y_size;
    let half_x = uv1.x * 0.5;
    let x2 = uv2.x * 0.5 - half_x;
    let x3 = uv3.x * 0.5 - half_x;
    let x_size = max(abs(x2), abs(x3));
    let d = x2 / x_size * y3_part - x3 / x_size * y2_part;
    let h = select(-1.0, 1.0, d > 0.0);
    let t = shading_measured((e2 / edge * y3_part - e3 / edge * y2_part) * h);
    if !(t.w_length > 0.0 && abs(d) > 0.0) {
        return shading_Tangent(vec3f(0.0), 0.0);
    }
    return shading_Tangent(t.w / t.w_length, h);
}

// A normal from a map: x t + y b + z N, length 1. glTF 2.0, 3.7.2.1.
fn shading_normal_mapped(n: vec3f, tangent: vec3f, h: f32, s: vec3f) -> vec3f {
    let across = shading_measured(shading_crossed(vec3f(0.0), n, tangent));
    let texel = shading_measured(s);
    if !(across.w_length > 0.0 && texel.w_length > 0.0) {
        return vec3f(0.0);
    }
    let side = across.w / across.w_length;
    return shading_unit(cross(side, n) * (texel.w.x / texel.w_length) + side * select(-1.0, 1.0, h > 0.0)
            * (texel.w.y / texel.w_length) + n * (texel.w.z / texel.w_length));
}

