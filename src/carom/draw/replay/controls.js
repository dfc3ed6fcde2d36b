// What the reader does: buttons, keys, wheel, drag, pinch.

/** Moves and zooms the view with a mouse, a pen or fingers on `canvas`. */
class Fingers {
  constructor(canvas, view, changed, pointed) {
    this.canvas = canvas;
    this.view = view;
    this.changed = changed;
    this.pointed = pointed;
    this.down = new Map();
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const kind of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(kind, (event) => this.lift(event));
    }
    canvas.addEventListener("pointerleave", () => pointed(null));
    canvas.addEventListener("wheel", (event) => this.turnWheel(event), { passive: false });
    canvas.addEventListener("dblclick", () => this.fit());
  }

  press(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.classList.add("held");
    this.down.set(event.pointerId, [event.offsetX, event.offsetY]);
  }

  lift(event) {
    this.down.delete(event.pointerId);
    this.canvas.classList.toggle("held", this.down.size > 0);
  }

  move(event) {
    const place = [event.offsetX, event.offsetY];
    if (!this.down.has(event.pointerId)) {
      this.pointed(place);
      return;
    }
    const before = this.grip();
    this.down.set(event.pointerId, place);
    const after = this.grip();
    this.view.moveBy(after.x - before.x, after.y - before.y);
    if (before.spread > 0) this.view.zoomAt(after.x, after.y, after.spread / before.spread);
    this.changed();
  }

  /** The middle of the fingers that are down, and how far they are from it. */
  grip() {
    const places = [...this.down.values()];
    const x = places.reduce((sum, place) => sum + place[0], 0) / places.length;
    const y = places.reduce((sum, place) => sum + place[1], 0) / places.length;
    return { x, y, spread: places.reduce((sum, place) => sum + Math.hypot(place[0] - x, place[1] - y), 0) };
  }

  turnWheel(event) {
    event.preventDefault();
    // Lines and pages are what some mice count in instead of pixels.
    const pixels = event.deltaY * [1, 16, 400][event.deltaMode];
    this.view.zoomAt(event.offsetX, event.offsetY, Math.exp(-0.0016 * pixels));
    this.changed();
  }

  zoom(factor) {
    this.view.zoomAt(0.5 * this.view.width, 0.5 * this.view.height, factor);
    this.changed();
  }

  fit() {
    this.view.fit();
    this.changed();
  }
}

/** Calls the action of each key, unless the reader is writing or a control wants the key itself. */
function listenToKeys(actions) {
  document.addEventListener("keydown", (event) => {
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    const target = event.target;
    const writes = target.matches("input[type=search], select");
    const presses = event.key === " " && target.matches("button:not([aria-selected=true]), input[type=checkbox]");
    if (!action || writes || presses || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action(event);
  });
}

/** The tabs of the panel: shows one section, hides the others. */
function chooseTab(name) {
  for (const tab of document.querySelectorAll("[role=tab]")) {
    const chosen = tab.id === `tab-${name}`;
    tab.setAttribute("aria-selected", chosen);
    element(tab.getAttribute("aria-controls")).hidden = !chosen;
  }
}
