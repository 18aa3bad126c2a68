"use strict";
/* What is seen: camera, light, section. It draws when something has changed, and never by itself. */
class View {
  constructor(canvas, gearbox, up) {
    this.canvas = canvas;
    this.gearbox = gearbox;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true, preserveDrawingBuffer: true});
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(0xf4f6f8);
    this.scene.add(gearbox.root);
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.001, 100);
    this.up = new THREE.Vector3().fromArray(up);
    this.camera.up.copy(this.up);
    this.light();
    this.orbit = new THREE.OrbitControls(this.camera, canvas);
    this.orbit.addEventListener("change", () => this.draw());
    this.plane = new THREE.Plane(new THREE.Vector3(0, 1, 0), 0);
    this.size();
    this.home();
    new ResizeObserver(() => this.size()).observe(canvas);
  }

  light() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8c96a5, 1.7));
    this.lamp = new THREE.DirectionalLight(0xffffff, 2.1);
    this.camera.add(this.lamp);
    this.lamp.position.set(0.6, 1.0, 0.8);
    this.scene.add(this.camera);
  }

  home() {
    const box = this.gearbox.box, size = box.getSize(new THREE.Vector3()).length();
    const ahead = Math.abs(this.up.x) > 0.9 ? new THREE.Vector3(0, 1, 0) : new THREE.Vector3(1, 0, 0);
    const beside = new THREE.Vector3().crossVectors(ahead, this.up);
    const way = beside.clone().addScaledVector(ahead, -0.83).addScaledVector(this.up, 0.64).normalize();
    this.size_ = size;
    this.middle = this.fit(way, box.getCenter(new THREE.Vector3()));
    this.orbit.target.copy(this.middle);
    this.camera.far = size * 20;
    this.camera.updateProjectionMatrix();
    this.orbit.update();
    this.draw();
  }

  /* Put the camera where all bodies just fill the picture, seen along a way; return the middle that it looks at. */
  fit(way, middle) {
    const right = new THREE.Vector3().crossVectors(this.up, way).normalize(), upward = new THREE.Vector3().crossVectors(way, right);
    const half = Math.tan((this.camera.fov * Math.PI) / 360), points = this.gearbox.outline();
    const room = [half * (this.camera.aspect || 1), half], axes = [right, upward], far = [0, 0];
    axes.forEach((axis, k) => {
      // |a ± s| ≤ room (far − depth) on either side: two lines, whose crossing is the nearest place and its shift.
      let low = -Infinity, high = -Infinity;
      for (const point of points) {
        const arm = point.clone().sub(middle), depth = room[k] * arm.dot(way), aside = arm.dot(axis);
        high = Math.max(high, depth + aside);
        low = Math.max(low, depth - aside);
      }
      far[k] = (high + low) / 2 / room[k];
      middle.addScaledVector(axis, (high - low) / 2);
    });
    this.camera.position.copy(middle).addScaledVector(way, 1.06 * Math.max(...far));
    return middle;
  }

  size() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    if (this.middle) this.draw();
  }

  /* Cut away what lies before a plane square to an axis of space, at a share of the box along it. */
  cut(axis, share) {
    const box = this.gearbox.box, ways = {x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1]};
    if (!ways[axis]) this.renderer.clippingPlanes = [];
    else {
      const place = box.min[axis] + share * (box.max[axis] - box.min[axis]), far = this.camera.position[axis] > place ? -1 : 1;
      this.plane.normal.fromArray(ways[axis]).multiplyScalar(far);
      this.plane.constant = -far * place;
      this.renderer.clippingPlanes = [this.plane];
    }
    this.gearbox.opened(Boolean(ways[axis]));
    this.draw();
  }

  turn(sideways, upwards) {
    const arm = this.camera.position.clone().sub(this.orbit.target);
    arm.applyAxisAngle(this.up, sideways);
    const right = new THREE.Vector3().crossVectors(arm, this.up).normalize(), tilted = arm.clone().applyAxisAngle(right, upwards);
    if (Math.abs(tilted.angleTo(this.up) - Math.PI / 2) < 1.5) arm.copy(tilted);
    this.camera.position.copy(this.orbit.target).add(arm);
    this.orbit.update();
  }

  zoom(factor) {
    this.camera.position.sub(this.orbit.target).multiplyScalar(factor).add(this.orbit.target);
    this.orbit.update();
    this.draw();
  }

  /* The body under a point of the canvas; what the section has cut away is not hit. */
  under(x, y) {
    const area = this.canvas.getBoundingClientRect(), ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2((2 * (x - area.left)) / area.width - 1, 1 - (2 * (y - area.top)) / area.height), this.camera);
    const cut = this.renderer.clippingPlanes, hits = ray.intersectObject(this.gearbox.root, true);
    const hit = hits.find(one => one.object.visible && !one.object.material.userData.glass && cut.every(plane => plane.distanceToPoint(one.point) >= 0));
    return hit ? hit.object.bodies[hit.instanceId] : null;
  }

  draw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      // The nearer the first plane, the coarser the depth: walls that nearly touch, as shaft and bore, would flicker.
      const far = this.camera.position.distanceTo(this.middle);
      this.camera.near = Math.max(this.size_ / 300, far - 0.8 * this.size_);
      this.camera.updateProjectionMatrix();
      this.renderer.render(this.scene, this.camera);
    });
  }
}
