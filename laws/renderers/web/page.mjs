// What runs in the page. A scene is a point of one pixel, as an application would draw it, one after the other.

/** Opens a scene with one point, one material and eight lights. */
export function start() {
  const { BABYLON } = window;
  const { Color4, Vector3 } = BABYLON;
  const engine = new BABYLON.Engine(document.createElement("canvas"), false, { useHighPrecisionMatrix: true });
  const scene = new BABYLON.Scene(engine);
  scene.imageProcessingConfiguration.isEnabled = false;

  // A TargetCamera goes by angles, which are not precise enough to keep the point in its pixel.
  class Camera extends BABYLON.Camera {
    _getViewMatrix() {
      return BABYLON.Matrix.LookAtLH(this.position, this.target, this.upVector);
    }
  }
  const camera = new Camera("eye", Vector3.Zero(), scene);
  const mesh = new BABYLON.Mesh("point", scene);
  new BABYLON.VertexData().applyToMesh(mesh);
  mesh.setVerticesData("position", [0, 0, 0], true);
  mesh.setVerticesData("normal", [0, 0, 1], true);
  mesh.setIndices([0]);
  mesh.alwaysSelectAsActiveMesh = true;
  const material = new BABYLON.StandardMaterial("material", scene);
  material.pointsCloud = true;
  material.maxSimultaneousLights = 8;
  material.allowShaderHotSwapping = false;
  mesh.material = material;
  const lights = Array.from({ length: 8 }, (_, i) => new BABYLON.DirectionalLight(`light ${i}`, Vector3.Up(), scene));

  const size = 64;
  const target = new BABYLON.RenderTargetTexture("colors", size, scene, {
    type: BABYLON.Constants.TEXTURETYPE_FLOAT, generateMipMaps: false, samplingMode: BABYLON.Texture.NEAREST_SAMPLINGMODE,
  });
  target.renderList = [mesh];
  target.activeCamera = camera;
  target.ignoreCameraViewport = false;
  target.onClearObservable.add(() => engine.clear(new Color4(0, 0, 0, 0), target.first, true));
  Object.assign(window, { engine, scene, camera, mesh, material, lights, target, size });
}

/** The colors of the scenes in a JSON array, clamped as a screen does if a range is given. */
export async function shade({ json, clamps: [low, high] = [-Infinity, Infinity] }) {
  const { BABYLON, engine, scene, camera, mesh, material, lights, target, size } = window;
  const { Color3, Vector3 } = BABYLON;
  const vector = (triple) => Vector3.FromArray(triple);
  const color = (triple) => Color3.FromArray(triple);

  function set({ model, p, n, v, k_a, k_d, k_s, m, i_a, lights: given }) {
    mesh.updateVerticesData("position", p);
    mesh.updateVerticesData("normal", n);
    const distance = Math.hypot(...v);
    camera.position = vector(p).add(vector(v));
    camera.minZ = distance / 10;
    camera.maxZ = distance * 10;
    camera.upVector = Math.abs(v[1]) < distance / 2 ? Vector3.Up() : Vector3.Right();
    camera.target = vector(p);
    camera.getViewMatrix(true);
    scene.ambientColor = color(i_a);
    material.ambientColor = color(k_a);
    material.diffuseColor = color(k_d);
    material.specularColor = color(model === "lambert" ? [0, 0, 0] : k_s);
    material.specularPower = m;
    lights.forEach((light, i) => {
      light.setEnabled(i < given.length);
      if (i >= given.length) return;
      light.direction = vector(given[i].l).negate();
      light.diffuse = light.specular = color(given[i].intensity);
    });
    // Otherwise a light that was black when it was switched on never has a highlight.
    material.markAsDirty(BABYLON.Material.LightDirtyFlag);
  }

  const colors = [];
  const scenes = JSON.parse(json);
  while (scenes.length > 0) {
    const some = scenes.splice(0, size * size);
    for (const [i, one] of some.entries()) {
      set(one);
      await material.forceCompilationAsync(mesh); // in the background: a shader for each number of lights
      camera.viewport = new BABYLON.Viewport((i % size) / size, Math.floor(i / size) / size, 1 / size, 1 / size);
      target.first = i === 0;
      scene.incrementRenderId();
      scene.resetCachedMaterial();
      target.render();
    }
    const pixels = await target.readPixels();
    for (const [i, one] of some.entries()) {
      const [r, g, b, alpha] = pixels.subarray(4 * i);
      if (alpha !== 1) throw new Error(`not drawn: ${JSON.stringify(one)}`);
      colors.push([r, g, b].map((c) => Math.min(Math.max(c, low), high)));
    }
  }
  return colors;
}
