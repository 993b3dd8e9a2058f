//! A light as the files have it: the numbers of any kind of light.

use shading::number::Mask;
use shading::{
    Attenuation, Cone, DirectionalLight, IncidentLight, PointLight, Rgb, SpotLight, UnitVec3, Vec3,
};

use crate::graph::assuming;
use crate::kind::{Light, Number, Value};

impl<T: Number> Light<T> {
    /// What dims the light after the distance q: the attenuation and the window of the range.
    pub fn falloff(&self, q: T) -> T {
        // the window is computed without a range, too, and counts as 1
        let at = |attenuation: Attenuation<T>| assuming(|| attenuation.at(q));
        let [within, within_gltf] = self.attenuations().map(at);
        self.is_gltf.above(T::ZERO).select(within_gltf, within)
    }

    /// The factor of its cone, by the cosine to its axis.
    pub fn spot(&self, cosine: T) -> T {
        let [l, axis] = [T::ONE, -cosine].map(|x| Vec3::new(x, T::ZERO, T::ZERO));
        let [l, axis] = [l, axis].map(UnitVec3::assume_unit);
        let [hard, smooth] = self.cones().map(|cone| cone.factor(axis, l));
        self.is_smoothstep.above(T::ZERO).select(smooth, hard)
    }

    /// With a range, and with a range of glTF.
    fn attenuations(&self) -> [Attenuation<T>; 2] {
        let Rgb { r: a, g: b, b: c } = self.coefficients;
        let (limit, range) = (self.limit, self.range);
        let both = assuming(|| {
            let falloff = Attenuation::new(a, b, c)?.clamped_to(limit)?;
            Some([falloff.within(range)?, falloff.within_gltf(range)?])
        });
        both.expect("the numbers of an attenuation")
    }

    /// With a linear edge, and with a smoothstep.
    fn cones(&self) -> [Cone<T>; 2] {
        let hard = cone(self.cosines);
        [hard, hard.smoothstep()]
    }

    /// What `f` makes of the light at p, whatever its kind and falloff: each is made by its constructors.
    pub fn each<V: Value<T>>(&self, p: Vec3<T>, f: impl Fn(IncidentLight<T>) -> V) -> V {
        let (position, intensity) = (self.position, self.intensity);
        if self.is_sun > T::ZERO {
            let l = UnitVec3::assume_unit(position);
            return f(DirectionalLight { l, intensity }.at(p));
        }
        let is_gltf = usize::from(self.is_gltf > T::ZERO);
        let attenuation = self.attenuations()[is_gltf];
        let point = PointLight {
            position,
            intensity,
            attenuation,
        };
        let is_smoothstep = usize::from(self.is_smoothstep > T::ZERO);
        let (axis, cone) = (self.axis, self.cones()[is_smoothstep]);
        let spot = SpotLight { point, axis, cone };
        let is_spot = self.cosines[0].above(T::NEG_ONE);
        let [spot, point] = [spot.at(p), point.at(p)].map(|light| f(light).numbers());
        let both = spot.into_iter().zip(point);
        V::take(&mut both.map(|(spot, point)| is_spot.select(spot, point)))
    }
}

pub fn cone<T: Number>([inner, outer]: [T; 2]) -> Cone<T> {
    assuming(|| Cone::from_cosines(inner, outer)).expect("the cosines of a cone")
}
