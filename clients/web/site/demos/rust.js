// The pixel as a Rust program, with the bits of the page.

/** The shortest decimal that is this f32 and no other. */
function float(x) {
  const single = Math.fround(x);
  let digits = String(single);
  for (let count = 1; count <= 9; count++) {
    digits = String(Number(single.toPrecision(count)));
    if (Math.fround(Number(digits)) === single) break;
  }
  return /[.e]/.test(digits) ? digits : `${digits}.0`;
}

/** Radians as the page's module computes them, in f32. */
function radians(degrees) {
  const PI = Math.fround(Math.PI);
  const scaled = Math.fround(Math.fround(degrees) * Math.fround(PI / 180));
  return Math.min(Math.max(scaled, 0), PI);
}

/**
 * A program that prints the color of a point. `values` are the settings, `colors` the bytes of each color, and `lamps`
 * the names of the settings and the color of each lamp that is on. `sun` is the direction to the sun, or null.
 */
export function program({ P, N, V }, values, colors, lamps, sun) {
  const { a, b, c, angle, edge, ka, kd, ks, m } = values;
  const model = ["lambert", "phong", "blinn_phong"][values.model];
  const isSpot = angle < 180;
  const vector = (v) => v.map(float).join(", ");
  const rgb = (name) => `Rgb::from_srgb8([${colors[name].join(", ")}])`;
  const on = a || b || c ? lamps : [];
  const list = on.map(({ names, color }) =>
    `        (Vec3::new(${vector(names.map((name) => values[name]))}), ${rgb(color)}),\n`).join("");
  const angles = [angle - Math.max(edge, 0), angle].map((degrees) => float(radians(degrees))).join(", ");
  const light = isSpot ? `        let axis = (-position).unit_or(UnitVec3::NEG_Z); // toward the origin
        SpotLight { point, axis, cone }.at(p)
` : "        point.at(p)\n";
  const material = [`k_a: color * ${float(ka)}`, `k_d: color * ${float(kd)}`, `k_s: Rgb::gray(${float(ks)})`, `m: ${float(m)}`];
  const types = ["Attenuation", isSpot && "Cone", sun && "DirectionalLight", "PointLight", "Rgb", isSpot && "SpotLight", "UnitVec3",
    "Vec3"].filter(Boolean).join(", ");
  const ofSun = sun ? `    let sun = DirectionalLight {
        l: Vec3::new(${vector(sun)}).unit_or(UnitVec3::Y),
        intensity: ${rgb("sunlight")},
    };
    let lights = lights.into_iter().chain([sun.at(p)]);
` : "";
  return `use shading::f32::{${types}};
use shading::{Material, shade};

fn main() {
    let color = ${rgb("color")};
    let material = Material {
${material.map((line) => `        ${line},\n`).join("")}    };
    let attenuation = Attenuation::new(${vector([a, b, c])})${on.length ? ".unwrap()" : ".unwrap_or_default()"};
${isSpot ? `    let cone = Cone::from_half_angles(${angles}).unwrap();\n` : ""}    let lamps: [(Vec3, Rgb); ${on.length}] = [
${list}    ];

    // the pixel: its point, its normal${model === "lambert" ? "" : " and the direction to the eye"}
    let p = Vec3::new(${vector(P)});
    let n = UnitVec3::assume_unit(Vec3::new(${vector(N)}));
${model === "lambert" ? "" : `    let v = UnitVec3::assume_unit(Vec3::new(${vector(V)}));\n`}
    let lights = lamps.map(|(position, intensity)| {
        let point = PointLight { position, intensity, attenuation };
${light}    });
${ofSun}    let shaded = shade::${model}(n, ${model === "lambert" ? "" : "v, "}&material, Rgb::WHITE, lights);
    println!("{:?}", shaded.total().to_srgb8());
}
`;
}
