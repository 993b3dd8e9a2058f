//! Lights that fit into the type of wider ones.

use super::{DirectionalLight, Light, PointLight, SpotLight};
use crate::attenuation::Attenuation;
use crate::cone::Cone;
use crate::range::Ranged;
use crate::real::Real;
use crate::soft_cone::SoftCone;

/// A cone or a falloff that fits into a light with another one: a hard cone where soft ones are
/// allowed, no range where there may be one, and each where its own type is asked for.
#[diagnostic::on_unimplemented(
    message = "a light with `{Self}` does not fit into a light with `{Wider}`",
    label = "expected a light with `{Wider}`",
    note = "every light fits into `Light<_, SoftCone<_>, Ranged<_>>`, in short `shading::f32::Light<SoftCone, Ranged>`"
)]
pub trait Fits<Wider> {
    #[doc(hidden)]
    fn widened(self) -> Wider;
}

impl<X> Fits<X> for X {
    #[inline]
    fn widened(self) -> X {
        self
    }
}

impl<T: Copy> Fits<SoftCone<T>> for Cone<T> {
    #[inline]
    fn widened(self) -> SoftCone<T> {
        self.into()
    }
}

impl<T: Real> Fits<Ranged<T>> for Attenuation<T> {
    #[inline]
    fn widened(self) -> Ranged<T> {
        self.into()
    }
}

impl<T, C, A> From<DirectionalLight<T>> for Light<T, C, A> {
    #[inline]
    fn from(light: DirectionalLight<T>) -> Self {
        Self::Directional(light)
    }
}

impl<T, C, A, B: Fits<A>> From<PointLight<T, B>> for Light<T, C, A> {
    #[inline]
    fn from(light: PointLight<T, B>) -> Self {
        Self::Point(PointLight {
            position: light.position,
            intensity: light.intensity,
            attenuation: light.attenuation.widened(),
        })
    }
}

impl<T, C, A, D: Fits<C>, B: Fits<A>> From<SpotLight<T, D, B>> for Light<T, C, A> {
    #[inline]
    fn from(light: SpotLight<T, D, B>) -> Self {
        let point = PointLight {
            position: light.point.position,
            intensity: light.point.intensity,
            attenuation: light.point.attenuation.widened(),
        };
        Self::Spot(SpotLight {
            point,
            axis: light.axis,
            cone: light.cone.widened(),
        })
    }
}

/// A list of hard lights without ranges becomes one of lights of every kind.
impl<T: Real> From<Light<T>> for Light<T, SoftCone<T>, Ranged<T>> {
    #[inline]
    fn from(light: Light<T>) -> Self {
        match light {
            Light::Directional(light) => light.into(),
            Light::Point(light) => light.into(),
            Light::Spot(light) => light.into(),
        }
    }
}
