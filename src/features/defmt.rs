//! Logging on a microcontroller: it sends the numbers as they are, and the host formats the text.

use defmt::{Format, Formatter, write};

#[cfg(feature = "fixed")]
use crate::fixed::Fixed;
use crate::{
    Arrival, Attenuation, Cone, DirectionalLight, Dual, IncidentLight, Light, Material, PointLight,
    Real, Rgb, Scalar, Shaded, SpotLight, UnitVec3, Vec3,
};

macro_rules! format {
    ($($type:ident$(<$($part:ident),+>)?, $self:ident: $text:literal, $($value:expr),+;)+) => {$(
        impl<T: Real + Scalar + Format $($(, $part: Format)+)?> Format for $type<T $($(, $part)+)?> {
            fn format(&$self, f: Formatter) {
                write!(f, $text, $($value),+);
            }
        }
    )+};
}

format! {
    Vec3, self: "Vec3({}, {}, {})", self.x, self.y, self.z;
    UnitVec3, self: "UnitVec3({}, {}, {})", self.x, self.y, self.z;
    Rgb, self: "Rgb({}, {}, {})", self.r, self.g, self.b;
    Dual, self: "Dual({}, {})", self.value, self.gradient;
    Attenuation, self: "Attenuation({}, limit: {}, range: {}, gltf: {})",
        self.coefficients(), self.limit(), self.range(), self.is_gltf();
    Cone, self: "Cone(cosines: {}, smoothstep: {})", self.cosines(), self.is_smoothstep();
    Arrival, self: "Arrival(l: {}, intensity: {}, distance: {})",
        self.l, self.intensity, self.distance;
    IncidentLight, self: "IncidentLight(l: {}, intensity: {}, distance: {})",
        self.l(), self.intensity(), self.distance();
    DirectionalLight, self: "DirectionalLight(l: {}, intensity: {})", self.l, self.intensity;
    PointLight, self: "PointLight(position: {}, intensity: {}, attenuation: {})",
        self.position, self.intensity, self.attenuation;
    SpotLight, self: "SpotLight({}, axis: {}, cone: {})", self.point, self.axis, self.cone;
    Material<M>, self: "Material(k_a: {}, k_d: {}, k_s: {}, m: {})",
        self.k_a, self.k_d, self.k_s, self.m;
    Shaded, self: "Shaded(ambient: {}, diffuse: {}, specular: {})",
        self.ambient, self.diffuse, self.specular;
}

impl<T: Real + Scalar + Format> Format for Light<T> {
    fn format(&self, f: Formatter) {
        match self {
            Self::Directional(light) => light.format(f),
            Self::Point(light) => light.format(f),
            Self::Spot(light) => light.format(f),
        }
    }
}

/// The number in decimal digits.
#[cfg(feature = "fixed")]
impl Format for Fixed {
    fn format(&self, f: Formatter) {
        write!(f, "{=f64}", f64::from(*self));
    }
}
