//! Adds up what lights in lanes give.

use super::Lanes;
use crate::color::Rgb;
use crate::number::Real;
use crate::shade::Shaded;

impl<L: Lanes> Shaded<L> {
    /// The sum of the lanes: what one point sends to the eye, with its lights
    /// [in lanes](crate::PointLight::packed).
    ///
    /// ```text
    /// a + b + c + d + e + f + g + h = ((a + e) + (c + g)) + ((b + f) + (d + h))
    /// ```
    ///
    /// On every machine, the upper half of the lanes is added to the lower half until one lane is left. A
    /// sum that overflows counts as the largest number. The ambient part, which is the same in each lane,
    /// counts once: it is that of the first lane.
    ///
    /// The bits differ from those of a sum one by one, because the order differs; the terms are the same,
    /// and none is negative. One by one, n lights take n − 1 additions and the product with k. In w lanes
    /// they take ⌈n/w⌉ − 1 additions, the product and log₂ w additions. So the two sums differ by at most
    /// (n + ⌈n/w⌉ + log₂ w)u of themselves, where u is the unit roundoff.
    ///
    /// ```
    /// use shading::{Rgb, Shaded};
    /// use wide::f32x4;
    ///
    /// let shaded = Shaded {
    ///     ambient: Rgb::gray(f32x4::splat(0.5)),
    ///     diffuse: Rgb::gray(f32x4::new([1.0, 2.0, 3.0, 4.0])),
    ///     specular: Rgb::BLACK,
    /// };
    /// let sum = shaded.sum_of_lanes();
    /// assert_eq!((sum.ambient, sum.diffuse), (Rgb::gray(0.5), Rgb::gray(10.0)));
    /// ```
    ///
    /// **A shadow** makes a lane black. Each lane has a direction and a distance of its own:
    ///
    /// ```
    /// use shading::f32::{Attenuation, IncidentLight, Material, PointLight, Rgb, UnitVec3, Vec3};
    /// use shading::shade;
    /// use wide::f32x8;
    ///
    /// /// Whether a ball of radius 1 around (0, 0, 3) stands between p and the light.
    /// fn is_blocked(p: Vec3, light: &IncidentLight) -> bool {
    ///     let (to_center, arrival) = (Vec3::new(0.0, 0.0, 3.0) - p, light.arrival());
    ///     let along = to_center.dot(arrival.l);
    ///     let aside_squared = to_center.dot(to_center) - along * along;
    ///     let t = along - (1.0 - aside_squared).sqrt(); // NaN where the ray misses the ball
    ///     0.0 < t && t < arrival.distance
    /// }
    ///
    /// /// These lights, black where they are behind the surface or in shadow.
    /// fn unblocked(
    ///     p: Vec3,
    ///     n: UnitVec3,
    ///     lights: shading::IncidentLight<f32x8>,
    /// ) -> shading::IncidentLight<f32x8> {
    ///     let open = std::array::from_fn(|i| {
    ///         let light = lights.cast(|x| x.to_array()[i]);
    ///         f32::from(light.is_in_front(n) && !is_blocked(p, &light))
    ///     });
    ///     lights * f32x8::new(open)
    /// }
    ///
    /// let lamp = |x: i8, z| PointLight {
    ///     position: Vec3::new(f32::from(x), 0.0, z),
    ///     intensity: Rgb::WHITE,
    ///     attenuation: Attenuation::NONE,
    /// };
    /// // five above the ball, of which it hides three, and one below it
    /// let lamps = [lamp(-6, 6.0), lamp(-1, 6.0), lamp(0, 6.0), lamp(1, 6.0), lamp(6, 6.0), lamp(0, 1.5)];
    /// let clay = Material { k_a: Rgb::gray(0.1), k_d: Rgb::gray(0.5), k_s: Rgb::gray(0.2), m: 32 };
    /// let (p, n, v) = (Vec3::ZERO, UnitVec3::Z, UnitVec3::Z);
    /// let (p8, n8, v8) = (p.map(f32x8::splat), n.cast(f32x8::splat), v.cast(f32x8::splat));
    ///
    /// let lit = PointLight::packed::<f32x8>(&lamps)
    ///     .map(|pack| pack.at(p8))
    ///     .map(|lights| unblocked(p, n, lights));
    /// let clay8 = clay.cast(f32x8::splat);
    /// let shaded = shade::blinn_phong(n8, v8, &clay8, Rgb::BLACK.map(f32x8::splat), lit).sum_of_lanes();
    ///
    /// let lit = [lamps[0], lamps[4], lamps[5]].map(|lamp| lamp.at(p));
    /// let alone = shade::blinn_phong(n, v, &clay, Rgb::BLACK, lit);
    /// assert!((shaded.total().g - alone.total().g).abs() < 1e-6);
    /// ```
    #[doc(alias("reduce_add", "horizontal sum"))]
    #[inline]
    pub fn sum_of_lanes(self) -> Shaded<L::Lane> {
        let sum = |part: Rgb<L>| part.map(|channel| channel.sum().at_most(Real::MAX));
        Shaded {
            ambient: self.ambient.map(|channel| channel.to_lanes().as_ref()[0]),
            diffuse: sum(self.diffuse),
            specular: sum(self.specular),
        }
    }
}
