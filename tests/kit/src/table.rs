//! The table. A row is: identifier, name, call, and the [promise](crate::promise) that holds of
//! the numbers of the result whatever the bits of the arguments. The name is the public name of
//! the function, before any comma; `tests/bits/coverage.rs` names each public function without a row.

/// Calls `$callback!` with all rows. The sections differ in who calls the functions:
///
/// - `ARITHMETIC`, `SWEEPS`, `SERIES`: the digests and the checks with any bits alone. The first
///   compile to a few instructions; the other two call a function several times in a row;
/// - `BYTES`, `ANGLES`, `OFF_GPU`: the counts of instructions and of flash, too;
/// - `FUNCTIONS`, `REAL_M`: the shader, too, which has neither bytes nor doubles, tables nor
///   enums with data. It has arguments of its own, with the same names.
///
/// `ANGLES` compute in doubles in fixed point and in `f32`; so does a constructor for constants.
/// `REAL_M` and `SERIES` are for floats.
#[macro_export]
macro_rules! for_each_function {
    ($callback:ident) => { $callback! {
        ARITHMETIC: Number {
            divided "Vec3, divided" |g| g.a / g.x => nothing;
            any_outside "Real::any_outside" |g|
                if g.x.any_outside(T::ONE, T::ONE + T::ONE) {
                    T::ONE
                } else {
                    T::ZERO
                }
                => nothing;
            if_positive "Real::select" |g| g.x.above(T::ZERO).select(g.y, g.cosine) => nothing;
            if_above "Real::above" |g| g.x.above(g.y).select(g.cosine, g.x) => nothing;
            at_least "Real::at_least" |g| g.x.at_least(g.y) => nothing;
            at_most "Real::at_most" |g| g.x.at_most(g.y) => nothing;
            // a signaling NaN, which no operation returns, may be its own positive part
            positive_part "Real::at_least, zero" |g|
                (g.x + T::ZERO).at_least(T::ZERO)
                => not_negative;
            light_sum "LightSum::add" |g|
                <T::Sum as LightSum<T>>::DARK
                    .add(
                        Dimmed {
                            color: g.rgb,
                            factor: g.cosine,
                        },
                        g.cosine,
                    )
                    .total()
                => nothing;
            any_positive "Mask::any" |g| g.x.above(T::ZERO).any() => nothing;
            all_positive "Mask::all" |g| g.x.above(T::ZERO).all() => nothing;
            vec3_operators "Vec3, operators" |g|
                [
                    g.a + g.b,
                    g.a - g.b,
                    g.a * g.x,
                    g.x.times_vector(g.a),
                    g.a / g.x,
                    -g.a,
                ]
                => nothing;
            vec3_assigned "Vec3, assigned" |g| {
                let mut v = g.a;
                v += g.b;
                v -= g.n;
                v *= g.x;
                v /= g.y;
                v
            } => nothing;
            vec3_sum "Vec3::sum" |g| [g.b, g.a, g.p].into_iter().sum::<Vec3<T>>() => nothing;
            vec3_dot_directions "Vec3::dot, with directions" |g|
                [g.a.dot(g.b), g.a.dot(g.n)]
                => nothing;
            vec3_cross_directions "Vec3::cross, with directions" |g|
                [g.a.cross(g.b), g.a.cross(g.n)]
                => nothing;
            assume_unit "UnitVec3::assume_unit" |g| -UnitVec3::assume_unit(g.a) => nothing;
            rgb_operators "Rgb, operators" |g|
                [
                    g.rgb + g.integer.k_a,
                    g.rgb - g.integer.k_a,
                    g.rgb * g.integer.k_a,
                    g.rgb * g.x,
                    g.x.times_rgb(g.rgb),
                    g.rgb / g.x,
                ]
                => nothing;
            rgb_assigned "Rgb, assigned" |g| {
                let mut c = g.rgb;
                c += g.integer.k_a;
                c -= g.integer.k_d;
                c *= g.integer.k_s;
                c *= g.x;
                c /= g.y;
                c
            } => nothing;
            rgb_sum "Rgb::sum" |g|
                [g.integer.k_d, g.rgb, g.integer.k_a]
                    .into_iter()
                    .sum::<Rgb<T>>()
                => nothing;
            vec3_between "Vec3::lerp" |g|
                [
                    Vec3::splat(g.y),
                    g.a.lerp(g.b, g.x),
                    g.a + g.n,
                    g.a - g.n,
                    g.n * g.x,
                ]
                => nothing;
            gray "Rgb::gray" |g| Rgb::gray(g.x) => nothing;
            dual_operators "Dual, operators" |g|
                [g.f + g.h, g.f - g.h, g.f * g.h, g.f / g.h, -g.f]
                => nothing;
            dual_with_number "Dual, with a number" |g|
                [g.f + g.y, g.f - g.y, g.f * g.y, g.f / g.y]
                => nothing;
            dual_compared "Dual, compared" |g|
                [
                    g.f.at_least(Dual::ZERO),
                    g.f.at_most(g.h),
                    g.f.abs(),
                    g.f.above(g.h).select(g.h, g.f),
                ]
                => nothing;
            dual_chain "Dual::chain" |g| g.f.chain(g.y, g.x) => nothing;
            half_angle_cosine "Real::half_angle_cosine" |g| g.x.half_angle_cosine() => nothing;
            shaded_operators "Shaded, operators" |g|
                [
                    g.shaded + g.shaded * g.x,
                    [g.shaded, g.shaded].into_iter().sum(),
                ]
                => nothing;
            shaded_assigned "Shaded, assigned" |g| {
                let mut s = g.shaded;
                s += g.shaded * g.x;
                s *= g.y;
                s
            } => nothing;
            dual_assigned "Dual, assigned" |g| {
                let mut f = g.f;
                f += g.h;
                f -= g.y;
                f *= g.h;
                f /= g.f;
                f
            } => nothing;
            light_assigned "IncidentLight, assigned" |g| {
                let mut light = g.sun.at(g.p);
                light *= g.x;
                light *= g.rgb;
                light.intensity()
            } => nothing;
            dual_offset "Dual, with a plain vector" |g|
                [
                    Vec3::new(g.f, g.h, g.f) + g.a,
                    Vec3::new(g.f, g.h, g.f) - g.a,
                ]
                => nothing;
            limit "Attenuation::limit" |g|
                g.lamps.map(|lamp| lamp.attenuation.limit().unwrap_or(T::MAX))
                => not_negative;
            window_kind "Attenuation::is_gltf" |g|
                g.lamps.map(|lamp| lamp.attenuation.is_gltf())
                => nothing;
            cone_kind "Cone::is_smoothstep" |g|
                [g.spot.cone, g.spot.cone.smoothstep()].map(|cone| cone.is_smoothstep())
                => nothing;
            limited "Attenuation::clamped_to" |g|
                g.attenuation
                    .clamped_to(g.y.abs())
                    .map(|limited| limited.at(g.x.abs()))
                => nothing;
            coefficients "Attenuation::coefficients" |g|
                g.attenuation.coefficients()
                => not_negative;
            clamped_attenuation "Attenuation::clamped" |g|
                g.attenuation.clamped().at(g.x.abs())
                => nothing;
            range "Attenuation::range" |g| g.soft_spot.point.attenuation.range().unwrap_or(T::MAX) => not_negative;
            cone_cosines "Cone::cosines" |g| g.spot.cone.cosines() => cosines;
            soft_cone_cosines "Cone::cosines, soft" |g| g.soft_spot.cone.cosines() => cosines;
        }
        SWEEPS: Number {
            powi_sweep "Elementary::powi, several" |g|
                [-3, -1, 0, 1, 2, 7, 100, i32::MIN, i32::MAX].map(|i| g.x.powi(i))
                => nothing;
            dual_powi_sweep "Dual::powi, several" |g|
                [-3, -1, 0, 1, 2, 7, i32::MIN, i32::MAX].map(|i| g.f.powi(i))
                => nothing;
            atan2 "Elementary::atan2" |g| [g.y.atan2(g.x), g.cosine.atan2(T::ZERO)] => nothing;
            powf "Elementary::powf" |g| g.x.abs().powf(g.cosine) => nothing;
            dual_atan2 "Dual::atan2" |g| [g.f.atan2(g.h), g.f.atan2(g.x)] => nothing;
            dual_powf "Dual::powf" |g| [g.f.powf(g.h), g.f.powf(g.x)] => nothing;
            dual_max "Dual::max" |g| [g.f.max(g.h), g.f.max(g.x)] => nothing;
            dual_min "Dual::min" |g| [g.f.min(g.h), g.f.min(g.x)] => nothing;
            raise_sweep "Lobe::raise, every integer m" |g|
                INTEGER.map(|m| m.raise(g.cosine))
                => nothing;
            phong_sweep "term::phong, every integer m" |g|
                INTEGER.map(|m| term::phong(g.l, g.v, m))
                => fraction;
            blinn_sweep "term::blinn, every integer m" |g|
                INTEGER.map(|m| term::blinn(g.n, g.v, m))
                => fraction;
            slivers "normal::triangle, slivers" |g|
                normal::triangle(g.p, g.p + g.a, g.p + g.a * g.cosine)
                => unit;
            blob_normals "normal::implicit, blobs" |g| normal::implicit(blobs, g.p) => unit;
            wild_normals "normal::implicit, of any value" |g|
                normal::implicit(|p| (p.x / p.y).sqrt() + p.z.ln(), g.a)
                => unit;
            wild_tangents "normal::parametric, of any value" |g|
                normal::parametric(
                    |u, v| Vec3::new(u * v, u.exp() / v, (u - v).abs()),
                    g.x,
                    g.y,
                )
                => unit;
            encoded "Rgb, encoded and decoded" |g| {
                let rgb = g.rgb.map(T::single);
                [
                    Rgb::<f32>::from_srgb8(rgb.to_srgb8()),
                    Rgb::gray(rgb.to_rgb565().into()),
                ]
            } => not_negative;
            cast "PointLight::cast" |g|
                g.lamps[0].cast(Dual::constant).at(Dual::point(g.p))
                => nothing;
            dual_directions "Vec3::unit_or, of dual numbers" |g| {
                let v = Vec3::new(g.f, g.h, Dual::constant(g.x));
                [*v.unit_or(UnitVec3::X), v.cross(v)]
            } => nothing;
            dual_factors "term::blinn, of dual numbers" |g| {
                let [n, h] = [g.n, g.l].map(|u| u.cast(Dual::constant));
                [
                    term::lambert(n, h),
                    term::phong(n, h, g.integer.m),
                    term::blinn(n, h, g.integer.m),
                ]
            } => nothing;
            gltf_range "Attenuation::within_gltf" |g| {
                let ranged = within_gltf(g.soft_spot.point.attenuation);
                [ranged.at(g.x.abs()), ranged.at(g.y.abs())]
            } => not_negative;
            gltf_lamp "PointLight::at, as in glTF" |g| {
                let mut lamp = g.soft_spot.point;
                lamp.attenuation = within_gltf(lamp.attenuation);
                lamp.at(g.p)
            } => arriving;
            smooth_factor "Cone::smoothstep" |g|
                g.soft_spot.cone.smoothstep().factor(g.n, g.l)
                => fraction;
            every_lamp "PointLight::at, every lamp" |g| g.lamps.map(|lamp| lamp.at(g.p)) => nothing;
            every_light "Light::at, every light" |g| g.lights.map(|light| light.at(g.p)) => nothing;
            light_arrival "IncidentLight::arrival" |g| g.soft_spot.at(g.p).arrival() => nothing;
            light_l "IncidentLight::l" |g| g.spot.at(g.p).l() => nothing;
            light_distance "IncidentLight::distance" |g| g.spot.at(g.p).distance() => nothing;
            light_intensity "IncidentLight::intensity" |g|
                g.soft_spot.at(g.p).intensity()
                => nothing;
            light_dimmed "IncidentLight, dimmed and filtered" |g|
                [g.spot.at(g.p) * g.cosine, g.sun.at(g.p) * g.rgb]
                => nothing;
            hook_direction "Real::measured" |g| {
                let m = T::measured(g.a);
                [m.w, Vec3::new(m.w_length, m.length, T::ZERO)]
            } => nothing;
            hook_faces "Real::faces" |g| T::faces(*g.n, g.a).any() => nothing;
            hook_toward "Real::toward" |g|
                T::faces(*g.n, g.a).any().then(|| {
                    let t = T::toward(*g.n, g.a);
                    [t.n_dot_w, T::cosine(*g.n, &t)]
                })
                => nothing;
            hook_cosine "Real::cosine" |g| T::cosine(*g.n, &T::toward(*g.n, *g.l)) => fraction;
            hook_whole_power "Real::whole_power" |g|
                INTEGER.map(|m| g.cosine.whole_power(m))
                => nothing;
            hook_halfway_power "Real::halfway_power" |g|
                T::halfway_power(*g.n, T::measured(g.a), *g.v, g.integer.m)
                => fraction;
            raise_root "Lobe::raise_root" |g| INTEGER.map(|m| m.raise_root(g.cosine)) => nothing;
            hook_attenuated "Real::attenuated" |g|
                light(T::attenuated(
                    g.rgb,
                    g.attenuation.coefficients(),
                    g.x.abs(),
                    T::ONE,
                ))
                => light;
            hook_windowed "Real::windowed" |g| {
                let dimmed = Dimmed {
                    color: g.rgb,
                    factor: g.cosine,
                };
                [
                    light(T::windowed(
                        dimmed,
                        g.a,
                        T::measured(g.a).length,
                        g.y.abs(),
                        T::ONE.above(T::ZERO),
                    )),
                    light(T::windowed(
                        dimmed,
                        g.a,
                        T::measured(g.a).length,
                        g.y.abs(),
                        T::ZERO.above(T::ZERO),
                    )),
                ]
            } => nothing;
            hook_beamed "Real::beamed" |g| {
                let dimmed = Dimmed {
                    color: g.rgb,
                    factor: g.cosine,
                };
                [
                    light(T::beamed(
                        dimmed,
                        *g.l,
                        [T::of_f32(0.5), T::of_f32(0.25)],
                        T::ONE.above(T::ZERO),
                        g.a,
                        &T::measured(g.a),
                    )),
                    light(T::beamed(
                        dimmed,
                        *g.l,
                        [T::of_f32(0.5), T::of_f32(0.25)],
                        T::ZERO.above(T::ZERO),
                        g.a,
                        &T::measured(g.a),
                    )),
                ]
            } => nothing;
            every_lambert "shade::lambert, every light" |g|
                shade::lambert(g.n, &g.integer, g.rgb, g.from_lights())
                => light;
            every_phong "shade::phong, every light" |g|
                shade::phong(
                    g.n,
                    g.v,
                    &g.integer,
                    g.rgb,
                    g.from_lights().filter(|light| light.is_in_front(g.n)),
                )
                => light;
            every_blinn_phong "shade::blinn_phong, every light" |g|
                shade::blinn_phong(g.n, g.v, &g.integer, g.rgb, g.from_lights())
                => light;
        }
        SERIES: Float {
            raise_real_sweep "Lobe::raise, every real m" |g|
                REAL.map(|m| T::from(m).raise(g.cosine))
                => nothing;
            raise_root_real "Lobe::raise_root, real m" |g|
                REAL.map(|m| T::from(m).raise_root(g.cosine))
                => nothing;
            raise_invalid "Lobe::raise, invalid m" |g|
                [f32::INFINITY, -1.0, f32::NAN].map(|m| T::from(m).raise(g.cosine))
                => nothing;
            raise_vanishing "Lobe::raise, where the power vanishes" |g|
                [2_u16, 5, 33, 1000, 10_000].map(|m| u32::from(m).raise(vanishing(m, g.cosine)))
                => nothing;
            raise_difficult "Lobe::raise, where all coefficients count" |g|
                Each((0_u8..32).map(|i| {
                    let (m, cosine) = difficult(i, g.cosine);
                    m.raise(cosine)
                }))
                => nothing;
            phong_real_sweep "term::phong, every real m" |g|
                REAL.map(|m| term::phong(g.l, g.v, T::from(m)))
                => fraction;
            blinn_real_sweep "term::blinn, every real m" |g|
                REAL.map(|m| term::blinn(g.n, g.v, T::from(m)))
                => fraction;
            number_before_dual "Dual, after a number" |g| g.y.before(g.f) => nothing;
            every_phong_real "shade::phong, real m, every light" |g|
                shade::phong(g.n, g.v, &g.real, g.rgb, g.from_lights())
                => light;
            every_blinn_phong_real "shade::blinn_phong, real m, every light" |g|
                shade::blinn_phong(g.n, g.v, &g.real, g.rgb, g.from_lights())
                => light;
        }
        BYTES: Number {
            to_srgb8 "Rgb::to_srgb8" |g| g.rgb.map(T::single).to_srgb8() => nothing;
            from_srgb8 "Rgb::from_srgb8" |g| {
                let [r, g, b, _] = g.bits.to_le_bytes();
                Rgb::<T>::from_srgb8([r, g, b])
            } => fraction;
            to_rgb565 "Rgb::to_rgb565" |g| g.rgb.map(T::single).to_rgb565() => nothing;
            from_rgb565 "Rgb::from_rgb565" |g| {
                let [low, high, ..] = g.bits.to_le_bytes();
                Rgb::<T>::from_rgb565(u16::from_le_bytes([low, high]))
            } => fraction;
            to_linear8 "Rgb::to_linear8" |g| g.rgb.map(T::single).to_linear8() => nothing;
        }
        ANGLES: Number {
            sin "Elementary::sin" |g| g.x.sin() => nothing;
            cos "Elementary::cos" |g| g.x.cos() => nothing;
            dual_sin "Dual::sin" |g| g.f.sin() => nothing;
            dual_cos "Dual::cos" |g| g.f.cos() => nothing;
            cone_from_half_angle "Cone::from_half_angle" |g|
                Cone::from_half_angle(g.x.abs()).map(Cone::cosines)
                => cosines;
            cone_from_half_angles "Cone::from_half_angles" |g|
                Cone::from_half_angles(g.cosine, g.x.abs()).map(Cone::cosines)
                => cosines;
            tan "Elementary::tan" |g| g.x.tan() => nothing;
            dual_tan "Dual::tan" |g| g.f.tan() => nothing;
            const_unit "UnitVec3::const_new" |g| T::const_unit(g.a) => unit;
            angular_implicit "normal::implicit, with angles" |g|
                normal::implicit(gyroid, g.p)
                => unit;
            angular_parametric "normal::parametric, with angles" |g|
                normal::parametric(globe, g.x, g.y)
                => unit;
        }
        OFF_GPU: Number {
            exp "Elementary::exp" |g| g.x.exp() => nothing;
            ln "Elementary::ln" |g| g.x.abs().ln() => nothing;
            dual_exp "Dual::exp" |g| g.f.exp() => nothing;
            dual_ln "Dual::ln" |g| g.f.abs().ln() => nothing;
            any_light "Light::at" |g| g.lights[2].at(g.p) => arriving;
        }
        FUNCTIONS: Number {
            sqrt "Real::sqrt" |g| g.x.abs().sqrt() => nothing;
            powi "Elementary::powi" |g| g.x.powi(7) => nothing;
            raise_integer "Lobe::raise, integer m" |g| g.integer.m.raise(g.cosine) => nothing;

            dot "Vec3::dot" |g| g.a.dot(g.b) => nothing;
            cross "Vec3::cross" |g| g.a.cross(g.b) => nothing;
            distance "Vec3::distance" |g| g.a.distance(g.b) => nothing;
            length "Vec3::length" |g| g.a.length() => nothing;
            unit "Vec3::unit" |g| g.a.unit() => unit;
            unit_or "Vec3::unit_or" |g| g.a.unit_or(g.n) => unit_or_n;
            unit_vec3_new "UnitVec3::new" |g| UnitVec3::new(g.n.x, g.n.y, g.n.z) => unit;
            clamped "Rgb::clamped" |g| (g.rgb - g.integer.k_a).clamped() => fraction;

            dual_sqrt "Dual::sqrt" |g| g.f.abs().sqrt() => nothing;
            dual_powi "Dual::powi" |g| g.f.powi(7) => nothing;

            normal_plane "normal::plane" |g| normal::plane(g.a.x, g.a.y, g.a.z) => unit;
            normal_triangle "normal::triangle" |g| normal::triangle(g.p, g.a, g.b) => unit;
            normal_sphere "normal::sphere" |g| normal::sphere(g.a, g.p) => unit;
            normal_implicit "normal::implicit, of a torus" |g| normal::implicit(torus, g.p) => unit;
            normal_from_gradient "normal::from_gradient" |g| normal::from_gradient(g.a) => unit;
            normal_parametric "normal::parametric, of a saddle" |g|
                normal::parametric(saddle, g.x, g.y)
                => unit;
            normal_from_tangents "normal::from_tangents" |g|
                normal::from_tangents(g.a, g.b)
                => unit;
            normal_facing "normal::facing" |g| normal::facing(g.n, g.v, g.n) => n_or_opposite;
            normal_transformed "normal::transformed" |g|
                normal::transformed(g.n, [g.p, g.a, g.b])
                => unit;
            normal_corner "normal::corner" |g| normal::corner(g.p, g.a, g.b) => at_most_pi_long;
            normal_tangent "normal::tangent" |g|
                normal::tangent(
                    [g.p, g.a, g.b],
                    [[g.x, g.y], [g.cosine, g.x], [g.y, g.cosine]],
                )
                .map(|(t, _)| t)
                => unit;
            normal_mapped "normal::mapped" |g| normal::mapped(g.n, g.a, g.cosine, g.b) => unit;

            reflection "reflection" |g| shading::reflection(g.n, g.l) => reflected;
            half_vector "half_vector" |g| shading::half_vector(g.l, g.v) => unit;
            term_ambient "term::ambient" |g| term::ambient(g.integer.k_a, g.rgb) => light;
            term_lambert "term::lambert" |g| term::lambert(g.n, g.l) => not_negative;
            term_phong "term::phong, integer m" |g| term::phong(g.l, g.v, g.integer.m) => fraction;
            term_blinn "term::blinn, integer m" |g| term::blinn(g.n, g.v, g.integer.m) => fraction;
            phong_normalization "term::phong_normalization" |g|
                term::phong_normalization(g.real.m)
                => positive;

            attenuation "attenuation" |g| shading::attenuation(g.a.x, g.a.y, g.a.z, g.x) => nothing;
            attenuation_new "Attenuation::new" |g|
                Attenuation::new(g.x, g.y, g.cosine).map(Attenuation::coefficients)
                => not_negative;
            attenuation_at "Attenuation::at" |g| g.attenuation.at(g.x.abs()) => nothing;
            attenuation_within "Attenuation::within" |g|
                g.attenuation.within(g.y.abs()).map(|ranged| ranged.range().unwrap_or(T::MAX))
                => positive;
            attenuation_at_ranged "Attenuation::at, ranged" |g|
                g.soft_spot.point.attenuation.at(g.x.abs())
                => not_negative;
            cone_from_cosine "Cone::from_cosine" |g| {
                let c = g.cosine + g.cosine - T::ONE;
                Cone::from_cosine(c).map(Cone::cosines)
            } => cosines;
            cone_factor "Cone::factor" |g| g.spot.cone.factor(g.n, g.l) => fraction;
            cone_from_cosines "Cone::from_cosines" |g|
                Cone::from_cosines(g.cosine, -g.cosine).map(Cone::cosines)
                => cosines;
            soft_cone_factor "Cone::factor, soft" |g| g.soft_spot.cone.factor(g.n, g.l) => fraction;

            directional_light "DirectionalLight::at" |g| g.sun.at(g.p) => arriving;
            point_light "PointLight::at" |g| g.lamps[0].at(g.p) => arriving;
            spot_light "SpotLight::at" |g| g.spot.at(g.p) => arriving;
            soft_spot_light "SpotLight::at, soft and ranged" |g| g.soft_spot.at(g.p) => arriving;
            incident_light_is_in_front "IncidentLight::is_in_front" |g|
                g.spot.at(g.p).is_in_front(g.n)
                => nothing;

            shade_lambert "shade::lambert" |g|
                shade::lambert(g.n, &g.integer, g.rgb, g.from_lamps())
                => light;
            shade_phong "shade::phong, integer m" |g|
                shade::phong(g.n, g.v, &g.integer, g.rgb, g.from_lamps())
                => light;
            shade_blinn_phong "shade::blinn_phong, integer m" |g|
                shade::blinn_phong(g.n, g.v, &g.integer, g.rgb, g.from_lamps())
                => light;
            shaded_total "Shaded::total" |g| g.shaded.total() => light;
        }
        REAL_M: Float {
            raise_real "Lobe::raise, real m" |g| g.real.m.raise(g.cosine) => nothing;
            term_phong_real "term::phong, real m" |g| term::phong(g.l, g.v, g.real.m) => fraction;
            term_blinn_real "term::blinn, real m" |g| term::blinn(g.n, g.v, g.real.m) => fraction;
            blinn_normalization "term::blinn_normalization" |g|
                term::blinn_normalization(g.real.m)
                => positive;
            shade_phong_real "shade::phong, real m" |g|
                shade::phong(g.n, g.v, &g.real, g.rgb, g.from_lamps())
                => light;
            shade_blinn_phong_real "shade::blinn_phong, real m" |g|
                shade::blinn_phong(g.n, g.v, &g.real, g.rgb, g.from_lamps())
                => light;
        }
    } };
}

/// Each row as a function.
pub mod row {
    use shading::number::{Dimmed, LightSum, Mask as _};
    use shading::{
        Attenuation, Cone, Dual, Elementary, Lobe, Real, Rgb, UnitVec3, Vec3, normal, shade, term,
    };

    use crate::digest::{Each, Value};
    use crate::given::Given;
    use crate::number::{Float, Number};
    use crate::places::{INTEGER, REAL};

    macro_rules! functions {
        ($($section:ident: $bound:ident {
            $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
        })*) => {$($(
            #[doc = $name]
            #[inline(always)]
            pub fn $row<T: $bound>($given: &Given<T>) -> impl Value { $call }
        )*)*};
    }
    for_each_function!(functions);

    fn light<T: Number>(Dimmed { color, factor }: Dimmed<T>) -> Rgb<T> {
        color * factor
    }

    fn within_gltf<T: Number>(ranged: Attenuation<T>) -> Attenuation<T> {
        ranged
            .range()
            .and_then(|r| ranged.within_gltf(r))
            .unwrap_or(ranged)
    }

    /// The cosine whose power is close to the smallest normal number, below which it becomes 0.
    fn vanishing<T: Float>(m: u16, fraction: T) -> T {
        let power = T::from(126.0) + fraction * T::from(4.0);
        (power / T::from(m.into())).raise(T::from(0.5))
    }

    /// An odd m, and a cosine next to √½: there the series of the logarithm and of the exponential
    /// have their largest arguments.
    fn difficult<T: Float>(i: u8, fraction: T) -> (T, T) {
        let i = T::from(i.into());
        (
            i + i + T::ONE,
            T::from(0.707) + (i + fraction) * T::from(1e-5),
        )
    }

    pub fn torus<T: Real>(p: Vec3<T>) -> T {
        let ring = (p.x * p.x + p.y * p.y).sqrt() - T::of_f32(2.0);
        ring * ring + p.z * p.z - T::of_f32(0.25)
    }

    fn blobs<T: Elementary>(p: Vec3<T>) -> T {
        let blob = |x: T| {
            let offset = p - Vec3::new(x, T::ZERO, T::ONE);
            (-offset.dot(offset)).exp()
        };
        blob(-T::ONE) + blob(T::ONE) + (p.z.abs() + T::ONE).ln() - p.x.powi(3)
    }

    pub fn saddle<T: Real>(u: T, v: T) -> Vec3<T> {
        Vec3::new(u, v, u * u - v * v)
    }

    fn gyroid<T: Elementary>(p: Vec3<T>) -> T {
        p.x.sin() * p.y.cos() + p.y.sin() * p.z.cos() + p.z.sin() * p.x.cos()
    }

    fn globe<T: Elementary>(u: T, v: T) -> Vec3<T> {
        Vec3::new(u.cos() * v.cos(), u.sin() * v.cos(), v.sin())
    }
}
