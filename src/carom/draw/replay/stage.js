// Draws the run at one time: what stands still from a picture kept for the view, the rest anew in every frame.

// Seconds of the run for which hits stay, and at most how many of them are drawn.
const HIT_SECONDS = 2.5;
const MOST_HITS_DRAWN = 200;

class Stage {
  constructor(canvas, run, motion, view) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d", { alpha: false });
    this.kept = document.createElement("canvas");
    this.run = run;
    this.motion = motion;
    this.view = view;
    this.brush = new Brush(this.context, view, run.styles);
    this.keptBrush = new Brush(this.kept.getContext("2d"), view, run.styles);
    this.shown = new Set(run.layers.filter((layer) => layer.on).map((layer) => layer.name));
    const changes = (piece) => piece.mover >= 0 || run.shapes[piece.shape]?.switched >= 0;
    this.fixed = run.pieces.filter((piece) => !changes(piece));
    this.changing = run.pieces.filter(changes);
    this.glowing = new Map();
    for (const piece of run.pieces) {
      if (piece.layer !== "shapes" && piece.layer !== "sensors") continue;
      if (!this.glowing.has(piece.shape)) this.glowing.set(piece.shape, piece);
    }
    this.names = new Names(this);
    this.tracks = new Tracks(this);
    this.selected = -1;
    this.stale = true;
  }

  /** Takes the colours of a theme. */
  useInks(inks) {
    this.brush.inks = this.keptBrush.inks = inks;
    this.stale = true;
  }

  /** Fits the canvas to the place that it has in the window. */
  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.ratio = window.devicePixelRatio || 1;
    for (const canvas of [this.canvas, this.kept]) {
      canvas.width = Math.max(1, Math.round(width * this.ratio));
      canvas.height = Math.max(1, Math.round(height * this.ratio));
      const context = canvas.getContext("2d");
      context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
      context.lineCap = context.lineJoin = "round";
    }
    this.view.resize(width, height);
    this.stale = true;
  }

  draw(time) {
    this.time = time;
    this.frame = this.motion.frameAt(time);
    this.findHits();
    this.drawGround();
    this.drawFixed();
    if (this.shown.has("tracks")) this.tracks.draw();
    if (this.shown.has("lights")) this.drawLights();
    this.drawChanging();
    if (this.shown.has("boxes")) this.drawBoxes();
    if (this.shown.has("hits")) this.drawHits();
    if (this.shown.has("tangents")) this.drawStamps("tangent", (hit) => this.run.hits.normal[hit]);
    if (this.shown.has("normals")) this.drawStamps("normal", (hit) => this.run.hits.normal[hit]);
    if (this.shown.has("balls")) this.drawBalls();
    if (this.shown.has("velocities")) this.drawVelocities();
    if (this.shown.has("reticles")) this.drawStamps("reticle", (hit, age) => this.reticleTurn(hit, age));
    if (this.shown.has("names")) this.names.draw();
    if (this.selected >= 0) this.drawSelected();
  }

  /** Finds the hits that are still to be seen: from `firstHit` up to `endHit`; where there are many, they fade sooner. */
  findHits() {
    const { time } = this.run.hits;
    this.endHit = countUpTo(time, this.time);
    this.firstHit = Math.max(countUpTo(time, this.time - HIT_SECONDS), this.endHit - MOST_HITS_DRAWN);
    const crowded = this.firstHit > 0 && this.endHit - this.firstHit === MOST_HITS_DRAWN;
    this.hitSeconds = crowded ? Math.min(HIT_SECONDS, this.time - time[this.firstHit - 1]) : HIT_SECONDS;
  }

  drawGround() {
    const { context, view } = this;
    const { left, bottom, right, top } = view.stage;
    const x = view.pixelX(left) - AROUND / 2;
    const y = view.pixelY(top) - AROUND / 2;
    const width = (right - left) * view.scale + AROUND;
    const height = (top - bottom) * view.scale + AROUND;
    context.fillStyle = this.brush.inks.paper;
    context.fillRect(0, 0, view.width, view.height);
    context.fillStyle = this.brush.inks.stage;
    context.strokeStyle = this.brush.inks.rule;
    context.lineWidth = 1;
    context.beginPath();
    context.roundRect(x, y, width, height, 6);
    context.fill();
    context.stroke();
  }

  drawFixed() {
    if (this.stale) {
      this.kept.getContext("2d").clearRect(0, 0, this.view.width, this.view.height);
      for (const piece of this.fixed) {
        if (this.shown.has(piece.layer)) this.keptBrush.play(piece.on);
      }
      this.stale = false;
    }
    this.context.drawImage(this.kept, 0, 0, this.view.width, this.view.height);
  }

  drawChanging() {
    for (const piece of this.changing) {
      if (this.shown.has(piece.layer)) this.brush.play(this.callsOf(piece), this.poseOf(piece));
    }
  }

  poseOf(piece) {
    return piece.mover < 0 ? STILL : this.motion.poseOf(piece.mover, this.time);
  }

  callsOf(piece) {
    const shape = this.run.shapes[piece.shape];
    return !shape || this.motion.collidesAt(shape, this.frame) ? piece.on : piece.off;
  }

  // -- hits -----------------------------------------------------------------------------------------------------------

  /** Lets shapes that were hit glow for a moment. */
  drawLights() {
    const { hits, marks } = this.run;
    const { strokes, seconds, weight } = marks.glow;
    const lights = new Map();
    for (let hit = this.firstHit; hit < this.endHit; hit++) {
      const left = 1 - (this.time - hits.time[hit]) / seconds;
      const shape = hits.thing[hit];
      if (left <= 0 || !this.glowing.has(shape)) continue;
      const strength = hits.kind[hit] === BOUNCE ? 0.3 + 0.7 * Math.sqrt(this.strength(hit)) : 1;
      lights.set(shape, Math.max(left * strength, lights.get(shape) ?? 0));
    }
    for (const [shape, light] of lights) {
      const piece = this.glowing.get(shape);
      if (!this.shown.has(piece.layer)) continue;
      const pose = this.poseOf(piece);
      for (const [width, opacity] of strokes) {
        this.brush.glow(this.callsOf(piece), pose, width * weight, opacity * light);
      }
    }
  }

  /** Calls `draw(hit, x, y, seconds)` for the bounces of the last seconds, the oldest first. */
  eachBounce(longest, draw) {
    const { hits } = this.run;
    for (let hit = this.firstHit; hit < this.endHit; hit++) {
      const age = this.time - hits.time[hit];
      if (age < longest && hits.kind[hit] === BOUNCE) draw(hit, hits.x[hit], hits.y[hit], age);
    }
  }

  /** How strong a hit was, 0 to 1, beside the strong ones of the run. */
  strength(hit) {
    return Math.min(1, this.run.hits.impulse[hit] / this.run.strong.impulse);
  }

  drawHits() {
    const { context, view } = this;
    const { smallest, largest } = this.run.marks.hit;
    context.fillStyle = this.brush.inks.hit;
    this.eachBounce(this.hitSeconds, (hit, x, y, age) => {
      const size = smallest + (largest - smallest) * Math.sqrt(this.strength(hit));
      context.globalAlpha = 0.75 * (1 - age / this.hitSeconds);
      this.disc(view.pixelX(x), view.pixelY(y), size * view.marks);
    });
    context.globalAlpha = 1;
  }

  disc(x, y, radius) {
    this.context.beginPath();
    this.context.arc(x, y, radius, 0, 2 * Math.PI);
    this.context.fill();
  }

  /** Sets a stamp at each of the latest hits, turned by what `turn(hit, age)` says. */
  drawStamps(name, turn) {
    const { stamps } = this.run;
    this.eachBounce(stamps.latest, (hit, x, y, age) => {
      this.brush.play(stamps[name], poseAt(x, y, turn(hit, age)), 1 - age / stamps.latest);
    });
  }

  /** Reticles turn the faster the faster the impact was. */
  reticleTurn(hit, age) {
    const { stamps, hits, strong } = this.run;
    return stamps.first_angle + (stamps.turn * age * hits.speed[hit]) / strong.impact;
  }

  drawSelected() {
    const { x, y } = this.run.hits;
    const { context, view } = this;
    context.strokeStyle = this.brush.inks.text;
    context.lineWidth = 1.5;
    context.beginPath();
    context.arc(view.pixelX(x[this.selected]), view.pixelY(y[this.selected]), 18, 0, 2 * Math.PI);
    context.stroke();
    const angle = this.run.hits.normal[this.selected];
    this.brush.play(this.run.stamps.normal, poseAt(x[this.selected], y[this.selected], angle));
  }

  // -- balls ----------------------------------------------------------------------------------------------------------

  /** Calls `draw(ball, x, y, radius, state)`, in pixels, for the balls that are there. */
  eachBall(draw) {
    const { balls } = this.run;
    for (let ball = 0; ball < balls.count; ball++) {
      const state = this.motion.ballAt(ball, this.time, this.frame);
      if (!state) continue;
      draw(ball, this.view.pixelX(state.x), this.view.pixelY(state.y), balls.radii[ball] * this.view.scale, state);
    }
  }

  /** Draws the balls, each in a rim of the ground's colour while it is large enough for one. */
  drawBalls() {
    const { context } = this;
    const { inks } = this.brush;
    this.eachBall((ball, x, y, radius) => {
      const rim = Math.min(1.5, 0.2 * radius);
      if (rim >= 0.3) {
        // Two discs are much quicker than one with a line around it.
        context.fillStyle = inks.stage;
        this.disc(x, y, radius);
      }
      context.fillStyle = inks[this.run.ball_inks[ball]];
      this.disc(x, y, Math.max(0.4, rim >= 0.3 ? radius - rim : radius));
    });
  }

  /** Draws the boxes of all that moves; those of what stands still are in the kept picture. */
  drawBoxes() {
    const { context, view } = this;
    const { ink, width, dash } = this.run.marks.box;
    context.beginPath();
    if (this.shown.has("balls")) {
      this.eachBall((ball, x, y, radius) => context.rect(x - radius, y - radius, 2 * radius, 2 * radius));
    }
    for (const piece of this.glowing.values()) {
      if (piece.mover < 0) continue;
      const { left, top, right, bottom } = this.brush.box(piece.on[0], this.poseOf(piece));
      if (right > left || bottom > top) context.rect(left, top, right - left, bottom - top);
    }
    context.setLineDash(dash.map((length) => length * view.marks));
    this.brush.stroke(ink, width, 1);
    context.setLineDash([]);
  }

  drawVelocities() {
    const { stamps, strong } = this.run;
    this.eachBall((ball, pixelX, pixelY, radius, { x, y, vx, vy }) => {
      const pixels = stamps.fast_arrow * Math.min(2, Math.hypot(vx, vy) / strong.speed);
      if (pixels < stamps.shortest_arrow) return;
      const arrow = stamps.arrows[Math.round((pixels - stamps.shortest_arrow) / stamps.arrow_step)];
      this.brush.play(arrow, poseAt(x, y, Math.atan2(vy, vx)));
    });
  }
}
