"use strict";
/* The gearbox as the page holds it: reads the GLB that the page carries, and turns its bodies. */
class Gearbox {
  constructor(buffer) {
    const head = new DataView(buffer), size = head.getUint32(12, true);
    const document_ = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 20, size)));
    this.document = document_;
    this.binary = 28 + size;
    this.buffer = buffer;
    this.cases = document_.scenes[0].extras.cases;
    this.materials = document_.materials.map(entry => this.material(entry));
    this.shapes = document_.meshes.map(entry => this.shape(entry.primitives[0]));
    this.root = new THREE.Group();
    this.bodies = document_.nodes.map(entry => this.body(entry));
    document_.nodes.forEach((entry, k) => (entry.children || []).forEach(child => this.bodies[k].frame.add(this.bodies[child].frame)));
    document_.scenes[0].nodes.forEach(k => this.root.add(this.bodies[k].frame));
    this.alike();
    this.settle();
  }

  array(number) {
    const accessor = this.document.accessors[number], view = this.document.bufferViews[accessor.bufferView];
    const kinds = {5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array}, widths = {SCALAR: 1, VEC3: 3};
    return new kinds[accessor.componentType](this.buffer, this.binary + view.byteOffset, accessor.count * widths[accessor.type]);
  }

  shape(primitive) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(this.array(primitive.attributes.POSITION), 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(this.array(primitive.attributes.NORMAL), 3));
    geometry.setIndex(new THREE.BufferAttribute(this.array(primitive.indices), 1));
    return {geometry, material: primitive.material};
  }

  material(entry) {
    const colour = new THREE.Color().fromArray(entry.pbrMetallicRoughness.baseColorFactor);
    return Gearbox.paint(colour, entry.alphaMode === "BLEND");
  }

  /* Where a plane cuts a body open one sees the inside of its far wall: painted flat and darker it looks like the cut. */
  static paint(colour, glass) {
    const made = new THREE.MeshPhongMaterial({color: colour, specular: 0x2a2a2a, shininess: 28, side: THREE.DoubleSide});
    made.userData.glass = glass;
    Gearbox.clear(made, true);
    made.onBeforeCompile = shader => {
      shader.fragmentShader = shader.fragmentShader.replace("#include <dithering_fragment>",
        "#include <dithering_fragment>\nif (!gl_FrontFacing) gl_FragColor = vec4(mix(diffuse, vec3(0.96, 0.80, 0.70), 0.55), opacity);");
    };
    return made;
  }

  /* A housing is seen through, and solid where it is cut open. */
  static clear(material, whole) {
    const clear = material.userData.glass && whole;
    Object.assign(material, {transparent: clear, opacity: clear ? 0.25 : 1, depthWrite: !clear, needsUpdate: true});
  }

  opened(cut) { for (const solid of this.groups) Gearbox.clear(solid.material, !cut); }

  body(entry) {
    const frame = new THREE.Group();
    frame.position.fromArray(entry.translation);
    frame.quaternion.fromArray(entry.rotation);
    const shown = entry.mesh === undefined ? null : this.shapes[entry.mesh];
    return {frame, name: entry.name, ...entry.extras, place: frame.position.clone(), rest: frame.quaternion.clone(), solid: null,
      shown, own: shown && this.materials[shown.material]};
  }

  /* Equal bodies of one part, such as the planets of a set, are drawn at once. */
  alike() {
    const groups = new Map();
    for (const body of this.bodies.filter(one => one.shown)) {
      const key = JSON.stringify([this.shapes.indexOf(body.shown), body.part, body.look]);
      groups.set(key, [...(groups.get(key) || []), body]);
    }
    this.groups = [...groups.values()].map(bodies => {
      const solid = new THREE.InstancedMesh(bodies[0].shown.geometry, bodies[0].own, bodies.length);
      solid.bodies = bodies;
      solid.frustumCulled = false;
      for (const body of bodies) body.solid = solid;
      this.root.add(solid);
      return solid;
    });
  }

  /* Where the frames are, the solids are. */
  settle() {
    this.root.updateMatrixWorld(true);
    for (const solid of this.groups) {
      solid.bodies.forEach((body, k) => solid.setMatrixAt(k, body.frame.matrixWorld));
      solid.instanceMatrix.needsUpdate = true;
      solid.boundingBox = solid.boundingSphere = null;
    }
  }

  /* Turn everything to where it is `seconds` after the start, in a load case; round numbers of turns are left out. */
  pose(seconds, name) {
    const about = new THREE.Vector3(0, 0, 1), turn = new THREE.Quaternion();
    for (const body of this.bodies) {
      turn.setFromAxisAngle(about, (body.spin_rad_s[name] * seconds) % (2 * Math.PI));
      body.frame.quaternion.copy(body.rest).multiply(turn);
    }
    this.settle();
  }

  explode(ways, share) {
    for (const body of this.bodies) {
      const way = ways[body.name];
      body.frame.position.copy(body.place);
      if (way) body.frame.position.addScaledVector(new THREE.Vector3().fromArray(way), share);
    }
    this.settle();
  }

  /* Some hundred vertices of every body where it stands: as far as it reaches. */
  outline() {
    const found = [];
    for (const body of this.bodies.filter(one => one.shown)) {
      const places = body.shown.geometry.attributes.position, step = Math.ceil(places.count / 300);
      for (let k = 0; k < places.count; k += step) found.push(new THREE.Vector3().fromBufferAttribute(places, k).applyMatrix4(body.frame.matrixWorld));
    }
    return found;
  }

  get box() { return new THREE.Box3().setFromObject(this.root); }
}
