"use strict";
/* Time that passes slowly. Nothing runs while it stands, while nobody looks, or where the reader wants no motion. */
class Motion {
  constructor(gearbox, view, told) {
    this.gearbox = gearbox;
    this.view = view;
    this.told = told;
    this.name = gearbox.cases[0];
    this.time = 0;
    this.slow = 1;
    this.runs = false;
    document.addEventListener("visibilitychange", () => { this.last = null; if (!document.hidden) this.next(); });
  }

  fastest() { return Math.max(1e-9, ...this.gearbox.bodies.map(body => Math.abs(body.spin_rad_s[this.name]))); }

  select(name) { this.name = name; this.show(); }

  show() { this.gearbox.pose(this.time, this.name); this.view.draw(); }

  go(on) { this.runs = on; this.last = null; this.told(on); this.next(); }

  /* On by one tooth of a gear, or of the fastest one. */
  step(teeth, body) {
    const speed = Math.abs(body ? body.spin_rad_s[this.name] : this.fastest());
    this.time += (2 * Math.PI) / (teeth * (speed || this.fastest()));
    this.show();
  }

  next() {
    if (!this.runs || document.hidden || this.waiting) return;
    this.waiting = true;
    // Where drawing is slow, as without a graphics processor, the page keeps time for itself between two pictures.
    const wait = (this.gap || 0) > 100 ? Math.min(this.gap, 500) : 0;
    this.paused = wait;
    setTimeout(() => requestAnimationFrame(now => this.frame(now)), wait);
  }

  frame(now) {
    this.waiting = false;
    if (!this.runs) return;
    this.gap = this.last ? now - this.last - (this.paused || 0) : 0;
    if (this.last) this.time += Math.min(now - this.last, 500) / 1000 / this.slow;
    this.last = now;
    this.show();
    this.next();
  }
}
