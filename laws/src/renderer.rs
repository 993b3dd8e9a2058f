//! Whatever shades.

use crate::profile::Profile;
use crate::scene::{Scene, Triple};

/// Whatever shades: a function, a shader on a GPU, another program.
///
/// ```
/// use shading_laws::{Profile, Renderer, Scene};
///
/// struct MyRenderer;
///
/// impl Renderer for MyRenderer {
///     fn profile(&self) -> Profile {
///         Profile { ambient: false, ..Profile::default() }
///     }
///
///     fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<[f64; 3]>, String> {
///         Ok(scenes.iter().map(|_scene| [0.0; 3]).collect()) // all black
///     }
/// }
/// ```
pub trait Renderer {
    /// What it says of itself.
    fn profile(&self) -> Profile {
        Profile::default()
    }

    /// The color of each scene, in the same order. A batch is one law's scenes, hundreds of them,
    /// or the few of one case while a failure is made smaller.
    ///
    /// # Errors
    ///
    /// What prevents an answer, in one line. It ends the run.
    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<Triple>, String>;

    /// Forgets all that it was asked, as a program does that is started again, and says whether it could. Then
    /// what is wrong only after other scenes is told from what is wrong by itself.
    ///
    /// # Errors
    ///
    /// What prevents it, in one line.
    fn begin_again(&mut self) -> Result<bool, String> {
        Ok(false)
    }

    /// Hears before each batch how far the run is, and says whether it goes on. If it does not, the
    /// report has what was found until then.
    fn goes_on(&mut self, _progress: &Progress) -> bool {
        true
    }
}

/// How far a run is.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// The number of scenes that were asked for.
    pub asked: usize,
    /// The scenes of the whole run, but for those that tell where something is wrong.
    pub of: usize,
    /// The number of broken laws.
    pub broken: usize,
}

/// Makes a renderer of a function that gives the color of one scene.
pub fn from_fn(profile: Profile, color: impl FnMut(&Scene) -> Triple) -> impl Renderer {
    (profile, color)
}

impl<F: FnMut(&Scene) -> Triple> Renderer for (Profile, F) {
    fn profile(&self) -> Profile {
        self.0.clone()
    }

    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<Triple>, String> {
        Ok(scenes.iter().map(&mut self.1).collect())
    }
}
