//! Log lines on a microcontroller: numbers are sent as they are, and the host makes the text.

use defmt::{Format, Formatter, write};

use crate::{
    Attenuation, Cone, DirectionalLight, Dual, IncidentLight, Light, Material, PointLight, Real,
    Rgb, Shaded, SpotLight, UnitVec3, Vec3,
};

macro_rules! format {
    ($type:ident, $self:ident, $text:literal, $($value:expr),+) => {
        impl<T: Real + Format> Format for $type<T> {
            fn format(&$self, f: Formatter) {
                write!(f, $text, $($value),+);
            }
        }
    };
}

format!(Vec3, self, "Vec3({}, {}, {})", self.x, self.y, self.z);
format!(
    UnitVec3,
    self, "UnitVec3({}, {}, {})", self.x, self.y, self.z
);
format!(Rgb, self, "Rgb({}, {}, {})", self.r, self.g, self.b);
format!(Dual, self, "Dual({}, {})", self.value, self.gradient);
format!(
    Attenuation,
    self,
    "Attenuation({}, clamped: {})",
    self.coefficients(),
    self.is_clamped()
);
format!(Cone, self, "Cone(cosine: {})", self.cosine());
format!(
    IncidentLight,
    self,
    "IncidentLight(l: {}, intensity: {}, distance: {})",
    self.l,
    self.intensity,
    self.distance
);
format!(
    DirectionalLight,
    self, "DirectionalLight(l: {}, intensity: {})", self.l, self.intensity
);
format!(
    PointLight,
    self,
    "PointLight(position: {}, intensity: {}, attenuation: {})",
    self.position,
    self.intensity,
    self.attenuation
);
format!(
    SpotLight,
    self, "SpotLight({}, axis: {}, cone: {})", self.point, self.axis, self.cone
);
format!(
    Shaded,
    self,
    "Shaded(ambient: {}, diffuse: {}, specular: {})",
    self.ambient,
    self.diffuse,
    self.specular
);

impl<T: Real + Format> Format for Light<T> {
    fn format(&self, f: Formatter) {
        match self {
            Self::Directional(light) => light.format(f),
            Self::Point(light) => light.format(f),
            Self::Spot(light) => light.format(f),
        }
    }
}

impl<T: Real + Format, M: Format> Format for Material<T, M> {
    fn format(&self, f: Formatter) {
        write!(
            f,
            "Material(k_a: {}, k_d: {}, k_s: {}, m: {})",
            self.k_a, self.k_d, self.k_s, self.m
        );
    }
}
