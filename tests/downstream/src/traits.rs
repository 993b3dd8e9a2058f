//! The traits that types implement.

use core::fmt::Debug;
use core::iter::Sum;
use core::ops::{Add, AddAssign, Deref, Div, Mul, MulAssign, Neg, Sub, SubAssign};

#[cfg(feature = "fixed")]
use shading::fixed::Fixed;
use shading::{
    Attenuation, Beam, Cone, DirectionalLight, Dual, Elementary, Exponent, Falloff, IncidentLight,
    Light, Lights, Material, PointLight, Ranged, Real, Rgb, Scalar, Shaded, SoftCone, SpotLight,
    UnitVec3, Vec3,
};
#[cfg(feature = "wide")]
use shading::{InLanes, Lanes};

// named as the parameters of the implementations that they stand for
pub type I = core::iter::Empty<IncidentLight>;
#[cfg(feature = "wide")]
pub type L = wide::f32x4;

/// Fails to compile unless each type implements each trait.
macro_rules! implemented {
    ($($(#[$if:meta])? { $($type:ty: $($trait:path),+;)* })*) => {$(
        $(#[$if])?
        const _: () = {
            $($({
                const fn is<T: $trait>() {}
                is::<$type>();
            })+)*
        };
    )*};
}

implemented! {
    {
        Vec3: Copy, Clone, Debug, PartialEq, Default, Add, Sub, Mul<f32>, Div<f32>, Neg, Sum, Sum<&'static Vec3>;
        Vec3: AddAssign, SubAssign, MulAssign<f32>, From<[f32; 3]>, From<UnitVec3>;
        UnitVec3: Copy, Clone, Debug, PartialEq, Neg, Deref;
        Rgb: Copy, Clone, Debug, PartialEq, Default, Add, Sub, Mul, Mul<f32>, Div<f32>, Sum, Sum<&'static Rgb>;
        Rgb: AddAssign, SubAssign, MulAssign<f32>, From<[f32; 3]>;
        [f32; 3]: From<Vec3>, From<UnitVec3>, From<Rgb>;
        f32: Real, Scalar, Elementary, Exponent<f32>, Mul<Vec3>, Mul<Rgb>, Add<Dual>, Sub<Dual>, Mul<Dual>, Div<Dual>;
        f64: Real, Scalar, Elementary, Exponent<f64>, Mul<Vec3<f64>>, Mul<Rgb<f64>>;
        f64: Add<Dual<f64>>, Sub<Dual<f64>>, Mul<Dual<f64>>, Div<Dual<f64>>;
        u32: Exponent<f32>;
        Dual: Copy, Clone, Debug, PartialEq, PartialOrd, Real, Scalar, Elementary;
        Dual: Add, Sub, Mul, Div, Neg, Add<f32>, Sub<f32>, Mul<f32>, Div<f32>;
        Attenuation: Copy, Clone, Debug, PartialEq, Default, Falloff<f32>;
        Ranged: Copy, Clone, Debug, PartialEq, Falloff<f32>, From<Attenuation>;
        Cone: Copy, Clone, Debug, PartialEq, Beam<f32>;
        SoftCone: Copy, Clone, Debug, PartialEq, Beam<f32>, From<Cone>;
        IncidentLight: Copy, Clone, Debug, PartialEq, From<DirectionalLight>;
        I: Lights<f32>;
        DirectionalLight: Copy, Clone, Debug, PartialEq;
        PointLight: Copy, Clone, Debug, PartialEq;
        SpotLight: Copy, Clone, Debug, PartialEq;
        Light: Copy, Clone, Debug, PartialEq, From<DirectionalLight>, From<PointLight>, From<SpotLight>;
        Light<f32, SoftCone, Ranged>: From<Light>;
        Material: Copy, Clone, Debug, PartialEq;
        Shaded: Copy, Clone, Debug, PartialEq, Default, Add, Mul<f32>, Sum;
    }
    #[cfg(feature = "approx")] {
        Vec3: approx::AbsDiffEq, approx::RelativeEq, approx::UlpsEq;
        UnitVec3: approx::AbsDiffEq, approx::RelativeEq, approx::UlpsEq;
        Rgb: approx::AbsDiffEq, approx::RelativeEq, approx::UlpsEq;
        IncidentLight: approx::AbsDiffEq, approx::RelativeEq, approx::UlpsEq;
        Shaded: approx::AbsDiffEq, approx::RelativeEq, approx::UlpsEq;
    }
    #[cfg(feature = "bytemuck")] {
        Vec3: bytemuck::Pod, bytemuck::Zeroable;
        Rgb: bytemuck::Pod, bytemuck::Zeroable;
        UnitVec3: bytemuck::NoUninit;
    }
    #[cfg(feature = "defmt")] {
        Vec3: defmt::Format;
        UnitVec3: defmt::Format;
        Rgb: defmt::Format;
        Dual: defmt::Format;
        Attenuation: defmt::Format;
        Ranged: defmt::Format;
        Cone: defmt::Format;
        SoftCone: defmt::Format;
        IncidentLight: defmt::Format;
        DirectionalLight: defmt::Format;
        PointLight: defmt::Format;
        SpotLight: defmt::Format;
        Light: defmt::Format;
        Material: defmt::Format;
        Shaded: defmt::Format;
    }
    #[cfg(feature = "mint")] {
        Vec3: From<mint::Vector3<f32>>, From<mint::Point3<f32>>, mint::IntoMint;
        UnitVec3: mint::IntoMint;
        mint::Vector3<f32>: From<Vec3>, From<UnitVec3>;
        mint::Point3<f32>: From<Vec3>;
    }
    #[cfg(feature = "fixed")] {
        Fixed: Copy, Clone, Debug, core::fmt::Display, core::hash::Hash, PartialEq, Eq, PartialOrd, Ord, Default, From<i16>;
        Fixed: Real, Elementary, Add, Sub, Mul, Div, Neg, Mul<Vec3<Fixed>>, Mul<Rgb<Fixed>>;
        f64: From<Fixed>;
    }
    #[cfg(all(feature = "bytemuck", feature = "fixed"))] {
        Fixed: bytemuck::Pod, bytemuck::Zeroable;
    }
    #[cfg(all(feature = "defmt", feature = "fixed"))] {
        Fixed: defmt::Format;
    }
    #[cfg(feature = "wide")] {
        wide::f32x4: Real, Lanes;
        wide::f32x8: Real, Lanes;
        wide::f32x16: Real, Lanes;
        wide::f64x4: Real, Lanes;
        wide::f64x8: Real, Lanes;
        InLanes<()>: Copy, Clone, Debug;
        InLanes<core::iter::Empty<IncidentLight<L>>>: Lights<<L as Lanes>::Lane>;
        f32: Exponent<wide::f32x4>, Exponent<wide::f32x8>, Exponent<wide::f32x16>;
        f64: Exponent<wide::f64x4>, Exponent<wide::f64x8>;
    }
}

/// Values can be read and written, in both numbers.
#[cfg(feature = "serde")]
const _: () = {
    const fn survives<V: serde_core::Serialize + serde_core::de::DeserializeOwned>() {}

    macro_rules! survive {
        ($($number:ident)*) => {$(
            survives::<Vec3<$number>>();
            survives::<UnitVec3<$number>>();
            survives::<Rgb<$number>>();
            survives::<Attenuation<$number>>();
            survives::<Ranged<$number>>();
            survives::<Cone<$number>>();
            survives::<SoftCone<$number>>();
            survives::<DirectionalLight<$number>>();
            survives::<PointLight<$number>>();
            survives::<PointLight<$number, Ranged<$number>>>();
            survives::<SpotLight<$number>>();
            survives::<SpotLight<$number, SoftCone<$number>, Ranged<$number>>>();
            survives::<Light<$number>>();
            survives::<Light<$number, SoftCone<$number>, Ranged<$number>>>();
            survives::<Material<$number, u32>>();
            survives::<Material<$number, f32>>();
        )*};
    }
    survive!(f32 f64);
};
