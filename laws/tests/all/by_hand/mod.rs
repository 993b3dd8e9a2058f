//! A renderer written by hand, in `f32` or `f64`, with each known mistake to choose from and some that are not known.

mod float;
mod plan;
mod reply;
mod shade;

use shading_laws::{Mistake, Profile, Renderer, Scene};

pub use float::{Float, Short, Vec3, add, dot, mul, of, scale, sub};
pub use plan::{Odd, Plan};
pub use shade::shade;

/// The renderer as a program would have it: in the precision of its profile, with what it remembers of other scenes.
pub struct ByHand {
    profile: Profile,
    plan: Plan,
    previous: [f64; 3],
    count: usize,
}

impl Renderer for ByHand {
    fn profile(&self) -> Profile {
        self.profile.clone()
    }

    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<[f64; 3]>, String> {
        let is = |mistake| {
            self.plan
                .faults
                .iter()
                .any(|fault| fault.mistake == mistake)
        };
        let (leaks, flickers) = (is(Mistake::Leak), is(Mistake::NotRepeatable));
        let is_double = self.profile.roundoff < 1e-10;
        let mut colors = Vec::with_capacity(scenes.len());
        for scene in scenes {
            let mut color = if is_double {
                shade::<f64>(scene, &self.profile, &self.plan)
            } else {
                shade::<f32>(scene, &self.profile, &self.plan)
            };
            self.count += 1;
            if leaks {
                let previous = std::mem::replace(&mut self.previous, color);
                color = [0, 1, 2].map(|i| f64::midpoint(color[i], previous[i]));
            }
            if flickers {
                color = color.map(|c| c * (1.0 + 0.01 * (self.count % 7) as f64));
            }
            colors.push(color);
        }
        Ok(colors)
    }
}

pub fn renderer(profile: &Profile, plan: impl Into<Plan>) -> ByHand {
    ByHand {
        profile: profile.clone(),
        plan: plan.into(),
        previous: [0.0; 3],
        count: 0,
    }
}
