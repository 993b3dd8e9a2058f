//! The numbers of several lights, or of parts of them, in lanes.

use super::Lanes;
use crate::attenuation::Attenuation;
use crate::cone::Cone;
use crate::light::{DirectionalLight, PointLight, SpotLight};
use crate::range::Ranged;
use crate::real::Real;
use crate::rgb::Rgb;
use crate::soft_cone::SoftCone;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// A light, or a part of it, of which lanes can hold several.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be gathered into lanes",
    note = "`all_at` takes lights with an `Attenuation` or a `Ranged`, and a `Cone` or a `SoftCone`; \
            others go into lanes by `packed`"
)]
pub trait Gather<L: Lanes>: Sized {
    type Gathered;

    /// One of these in each lane, by its index, or `None` if they differ in more than numbers.
    #[doc(hidden)]
    fn gather<'a>(of: impl Fn(usize) -> &'a Self) -> Option<Self::Gathered>
    where
        Self: 'a;
}

/// The first in any lane.
#[inline(always)]
pub(super) fn first<L: Lanes, K>(of: impl Fn(usize) -> Option<K>) -> Option<K> {
    (0..L::COUNT).find_map(of)
}

/// 1 in the lanes where it is so, and 0 elsewhere.
#[inline(always)]
pub(super) fn choice<L: Lanes>(is: impl Fn(usize) -> bool) -> L {
    L::from_fn(|i| if is(i) { L::Lane::ONE } else { L::Lane::ZERO })
}

#[inline(always)]
fn are_alike<L: Lanes>(is: impl Fn(usize) -> bool) -> bool {
    (1..L::COUNT).all(|i| is(i) == is(0))
}

macro_rules! gather {
    ($([$($parameter:ident),*] $type:ty => $gathered:ty, $of:ident $body:block)*) => {
        $(impl<L: Lanes $(, $parameter: Gather<L>)*> Gather<L> for $type {
            type Gathered = $gathered;

            #[inline(always)]
            fn gather<'a>($of: impl Fn(usize) -> &'a Self) -> Option<$gathered>
            where
                Self: 'a,
            $body
        })*
    };
}

gather! {
    [] Vec3<L::Lane> => Vec3<L>, of {
        let [x, y, z, _] = L::columns(|i| [of(i).x, of(i).y, of(i).z, of(i).z]);
        Some(Vec3::new(x, y, z))
    }
    [] UnitVec3<L::Lane> => UnitVec3<L>, of {
        Some(UnitVec3::assume_unit(Vec3::gather(|i| &**of(i))?))
    }
    [] Rgb<L::Lane> => Rgb<L>, of {
        let [r, g, b, _] = L::columns(|i| [of(i).r, of(i).g, of(i).b, of(i).b]);
        Some(Rgb::new(r, g, b))
    }
    [] Attenuation<L::Lane> => Attenuation<L>, of {
        let [a, b, c, _] = L::columns(|i| {
            let [a, b, c] = of(i).coefficients();
            [a, b, c, c]
        });
        let attenuation = Attenuation::unchecked(a, b, c);
        if !are_alike::<L>(|i| of(i).is_clamped()) {
            None
        } else if of(0).is_clamped() {
            Some(attenuation.clamped())
        } else {
            Some(attenuation)
        }
    }
    [] Ranged<L::Lane> => Ranged<L>, of {
        let attenuation = Attenuation::gather(|i| &of(i).attenuation)?;
        let ranged = Ranged::unchecked(attenuation, L::from_fn(|i| of(i).range()));
        if !are_alike::<L>(|i| of(i).is_unsquared()) {
            None
        } else if of(0).is_unsquared() {
            Some(ranged.unsquared())
        } else {
            Some(ranged)
        }
    }
    [] Cone<L::Lane> => Cone<L>, of {
        Some(Cone { cosine: L::from_fn(|i| of(i).cosine) })
    }
    [] SoftCone<L::Lane> => SoftCone<L>, of {
        let cosine = |k: usize| Cone { cosine: L::from_fn(|i| [of(i).inner, of(i).outer][k]) };
        let cone = SoftCone::between(cosine(0), cosine(1));
        if !are_alike::<L>(|i| of(i).is_smoothstep()) {
            None
        } else if of(0).is_smoothstep() {
            Some(cone.smoothstep())
        } else {
            Some(cone)
        }
    }
    [] DirectionalLight<L::Lane> => DirectionalLight<L>, of {
        let intensity = Rgb::gather(|i| &of(i).intensity)?;
        Some(DirectionalLight { l: UnitVec3::gather(|i| &of(i).l)?, intensity })
    }
    [A] PointLight<L::Lane, A> => PointLight<L, A::Gathered>, of {
        Some(PointLight {
            position: Vec3::gather(|i| &of(i).position)?,
            intensity: Rgb::gather(|i| &of(i).intensity)?,
            attenuation: A::gather(|i| &of(i).attenuation)?,
        })
    }
    [C, A] SpotLight<L::Lane, C, A> => SpotLight<L, C::Gathered, A::Gathered>, of {
        Some(SpotLight {
            point: PointLight::gather(|i| &of(i).point)?,
            axis: UnitVec3::gather(|i| &of(i).axis)?,
            cone: C::gather(|i| &of(i).cone)?,
        })
    }
}
