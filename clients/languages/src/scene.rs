//! What lights many points, and the arrays that describe them. Each array has a row for each point,
//! or one for all.

use crate::light::{Light, is_finite, is_light};
use crate::number::Number;
use crate::problem::{Problem, Status, triple};
use crate::threads;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Model {
    Lambert,
    Phong,
    BlinnPhong,
}

impl Model {
    pub fn of(model: u32) -> Result<Self, Problem> {
        match model {
            0 => Ok(Self::Lambert),
            1 => Ok(Self::Phong),
            2 => Ok(Self::BlinnPhong),
            _ => Err(Problem::new(
                Status::Model,
                "model",
                "0 (lambert), 1 (phong) or 2 (blinn-phong)",
                model,
            )),
        }
    }
}

#[derive(Clone, Copy)]
pub struct Scene<'a, T> {
    pub model: Model,
    pub count: usize,
    pub points: &'a [[T; 3]],
    pub normals: &'a [[T; 3]],
    pub eye: &'a [[T; 3]],
    pub k_a: &'a [[T; 3]],
    pub k_d: &'a [[T; 3]],
    pub k_s: &'a [[T; 3]],
    pub m: &'a [T],
    pub ambient: &'a [[T; 3]],
    pub lights: &'a [Light<T>],
    /// The fraction of each light that reaches each point, or one for all points, light after light.
    /// Without it, each light reaches each point.
    pub visible: Option<&'a [T]>,
}

impl<T: Number> Scene<'_, T> {
    /// The lights of the crate, if all numbers of the scene have a meaning.
    pub fn checked(&self) -> Result<Vec<shading::Light<T>>, Problem> {
        self.check_lengths()?;
        let lights = self.lights.iter().enumerate();
        let lights = lights
            .map(|(i, light)| light.checked().map_err(|problem| problem.in_light(i)))
            .collect::<Result<Vec<_>, _>>()?;
        for (status, name, rows) in [
            (Status::Points, "points", self.points),
            (Status::Normals, "normals", self.normals),
            (Status::Eye, "eye", self.eye),
        ] {
            check(rows, is_finite, |row| {
                Problem::new(status, name, "finite numbers", triple(row))
            })?;
        }
        let has_highlight = self.model != Model::Lambert;
        for (status, name, rows, is_used) in [
            (Status::Reflectance, "k_a", self.k_a, true),
            (Status::Reflectance, "k_d", self.k_d, true),
            (Status::Reflectance, "k_s", self.k_s, has_highlight),
            (Status::Ambient, "ambient", self.ambient, true),
        ] {
            let is_right = |x: T| !is_used | is_light(x);
            check(rows, is_right, |row| {
                Problem::new(status, name, "finite numbers of 0 or more", triple(row))
            })?;
            if status == Status::Reflectance && is_used {
                refuse_bytes(name, rows)?;
            }
        }
        check_numbers(
            self.m,
            |m| !has_highlight | (m >= T::ZERO),
            |m| Problem::new(Status::Shininess, "m", "numbers of 0 or more", m),
        )?;
        let fractions = self.visible.unwrap_or(&[]);
        let is_fraction = |x| (x >= T::ZERO) & (x <= T::ONE);
        match first_wrong(fractions, is_fraction) {
            None => Ok(lights),
            Some(i) => {
                let expected = "fractions from 0 to 1";
                let problem = Problem::new(Status::Visible, "visible", expected, fractions[i]);
                let is_per_light = fractions.len() == self.lights.len();
                Err(problem.at(i, if is_per_light { 1 } else { fractions.len() }))
            }
        }
    }

    fn check_lengths(&self) -> Result<(), Problem> {
        let rows = [
            ("points", self.points.len()),
            ("normals", self.normals.len()),
            ("eye", self.eye.len()),
            ("k_a", self.k_a.len()),
            ("k_d", self.k_d.len()),
            ("k_s", self.k_s.len()),
            ("m", self.m.len()),
            ("ambient", self.ambient.len()),
        ];
        let (count, lights) = (self.count, self.lights.len());
        for (name, length) in rows {
            if length != 1 && length != count {
                let expected = format!("as many as points, {count}, or one for all");
                return Err(Problem::new(Status::Count, name, &expected, length));
            }
        }
        match self.visible {
            Some(fractions) if ![lights, lights * count].contains(&fractions.len()) => {
                let expected =
                    format!("a fraction for each of {lights} lights, or for each light and point");
                let got = fractions.len();
                Err(Problem::new(Status::Count, "visible", &expected, got))
            }
            _ => Ok(()),
        }
    }
}

/// Nothing reflects ten times the light. Whole numbers that are not all small are the bytes of an image.
fn refuse_bytes<T: Number>(name: &str, rows: &[[T; 3]]) -> Result<(), Problem> {
    let (numbers, most) = (rows.as_flattened(), T::of(10.0));
    if first_wrong(numbers, |x| x < most).is_none()
        || first_wrong(numbers, |x| x.whole().is_some()).is_some()
    {
        return Ok(());
    }
    let expected = "linear numbers, usually from 0 to 1";
    let largest = numbers.iter().fold(T::ZERO, |most, &x| most.at_least(x));
    let got = format!("whole numbers up to {largest}; from_srgb8 decodes an image's bytes");
    Err(Problem::new(Status::Reflectance, name, expected, got))
}

/// The first row with a number that is not right is a problem.
fn check<T: Number>(
    rows: &[[T; 3]],
    is_right: impl Fn(T) -> bool + Send + Sync,
    problem: impl FnOnce([T; 3]) -> Problem,
) -> Result<(), Problem> {
    match first_wrong(rows.as_flattened(), is_right) {
        None => Ok(()),
        Some(i) => Err(problem(rows[i / 3]).at(i / 3, rows.len())),
    }
}

fn check_numbers<T: Number>(
    numbers: &[T],
    is_right: impl Fn(T) -> bool + Send + Sync,
    problem: impl FnOnce(T) -> Problem,
) -> Result<(), Problem> {
    match first_wrong(numbers, is_right) {
        None => Ok(()),
        Some(i) => Err(problem(numbers[i]).at(i, numbers.len())),
    }
}

fn first_wrong<T: Number>(
    numbers: &[T],
    is_right: impl Fn(T) -> bool + Send + Sync,
) -> Option<usize> {
    // without a branch for each number, which almost always is right
    let are_right = |span: &[T]| span.iter().fold(true, |right, &x| right & is_right(x));
    if threads::all(numbers, are_right) {
        return None;
    }
    numbers.iter().position(|&x| !is_right(x))
}
