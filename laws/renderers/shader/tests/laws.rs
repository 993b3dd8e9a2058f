//! The shader under the laws, and mistakes that the laws find in it.

use shader::{PHONG, Shader};
use shading_laws::{Laws, check};

#[test]
fn the_shader_follows_the_laws() {
    check(Shader::new(PHONG));
}

/// The right code, a usual mistake in its place, and its name.
const MISTAKES: [(&str, &str, &str); 10] = [
    ("normalize(scene.n)", "scene.n", "NormalNotNormalized"),
    ("normalize(scene.v)", "scene.v", "ViewNotNormalized"),
    ("l = to_light / q", "l = to_light", "LightNotNormalized"),
    ("reflect(-l, n)", "reflect(l, n)", "ReflectionReversed"),
    ("normalize(l + v)", "l + v", "HalfVectorNotNormalized"),
    (
        "let n_dot_l = dot(n, l);\n        if n_dot_l <= 0 { continue; }",
        "let n_dot_l = max(dot(n, l), 0);",
        "HighlightNotGated",
    ),
    (
        "color += scene.k_s * intensity",
        "color += scene.k_s * light.intensity",
        "HighlightNotAttenuated",
    ),
    ("i < scene.count", "i < min(scene.count, 1)", "LightsAtMost"),
    ("dot(-l, light.axis)", "dot(l, light.axis)", "ConeReversed"),
    ("cos_angle { continue; }", "cos_angle { }", "ConeForgotten"),
];

#[test]
fn usual_mistakes_are_found_and_named() {
    for (right, wrong, mistake) in MISTAKES {
        assert_eq!(PHONG.matches(right).count(), 1, "{right}");
        let mut shader = Shader::new(&PHONG.replace(right, wrong));
        let report = Laws::default().run(&mut shader).expect("colors");
        let cause = report.findings[0].cause.as_ref().expect("a cause");
        let named = cause.mistake.map(|fault| fault.id());
        assert_eq!(named, Some(mistake), "{wrong}: {report}");
    }
}
