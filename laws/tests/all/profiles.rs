//! Kinds of renderers.

use shading_laws::{Model, Profile};

/// It has everything and gives linear light.
pub fn linear() -> Profile {
    Profile::default()
}

/// It gives bytes for a screen.
pub fn bytes() -> Profile {
    Profile {
        srgb: true,
        bits: Some(8),
        ..linear()
    }
}

pub fn clamped() -> Profile {
    Profile {
        clamps: Some([0.0, 1.0]),
        ..linear()
    }
}

/// It has one lamp at a time.
pub fn one_lamp() -> Profile {
    Profile {
        models: vec![Model::Phong],
        directional_lights: false,
        most_lights: 1,
        unit_vectors: true,
        ..linear()
    }
}

/// It has directional lights only.
pub fn sunny() -> Profile {
    Profile {
        models: vec![Model::Lambert, Model::BlinnPhong],
        point_lights: false,
        spot_lights: false,
        integer_shininess: true,
        ..linear()
    }
}

/// It departs from the formulas on purpose.
pub fn of_its_own() -> Profile {
    Profile {
        whole_angle: true,
        attenuated_ambient: true,
        unattenuated_highlight: true,
        highlight_on_the_dark_side: true,
        ..linear()
    }
}

/// It departs from the formulas on purpose in all other ways.
pub fn of_another_kind() -> Profile {
    Profile {
        normal_faces_eye: true,
        black_without_lights: true,
        unattenuated: true,
        gray_highlight: true,
        spot_exponent: 2.0,
        ambient_times_diffuse: true,
        ..linear()
    }
}

/// It shows a surface unlit without lights, and has lamps only.
pub fn unlit() -> Profile {
    Profile {
        unlit_without_lights: true,
        directional_lights: false,
        ..linear()
    }
}
