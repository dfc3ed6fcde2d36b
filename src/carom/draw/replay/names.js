// The names of shapes and balls, each where there is room for it: beside what it names, and over no other name.

class Names {
  constructor(stage) {
    this.stage = stage;
    this.widths = new Map();
  }

  draw() {
    const { run, view, context, motion, time } = this.stage;
    this.label = run.marks.label;
    this.size = this.label.size * Math.max(0.85, view.marks);
    context.font = `${this.size}px ${FONT}`;
    this.taken = [];
    for (const { words, mover, places } of run.names) {
      const pose = mover < 0 ? STILL : motion.poseOf(mover, time);
      this.write(words, places.map((place) => [...this.stage.brush.pixel(...place, pose), 3]));
    }
    const named = new Set(run.named);
    this.stage.eachBall((ball, x, y, radius) => {
      if (named.has(ball)) this.write(run.ball_names[ball], [[x, y, radius]]);
    });
  }

  /** Writes words at the first place with room: above, below, right or left of a pixel, and clear of it. */
  write(words, places) {
    const { around, gap } = this.label;
    const width = this.widthOf(words) + 4 * around;
    const height = this.size + 2 * around;
    for (const [x, y, clearance] of places) {
      const off = clearance + gap;
      const middles = [
        [x, y - off - 0.5 * height], [x, y + off + 0.5 * height], [x + off + 0.5 * width, y], [x - off - 0.5 * width, y],
      ];
      const found = middles.find((middle) => this.isFree(...middle, width, height));
      if (!found) continue;
      this.taken.push([...found, width, height]);
      this.set(words, ...found, width, height);
      return;
    }
  }

  widthOf(words) {
    const key = `${this.size} ${words}`;
    if (!this.widths.has(key)) this.widths.set(key, this.stage.context.measureText(words).width);
    return this.widths.get(key);
  }

  isFree(x, y, width, height) {
    const { view } = this.stage;
    const inside = 2 * x >= width && 2 * y >= height && x + 0.5 * width <= view.width && y + 0.5 * height <= view.height;
    return inside && this.taken.every(([otherX, otherY, otherWidth, otherHeight]) =>
      2 * Math.abs(x - otherX) >= width + otherWidth || 2 * Math.abs(y - otherY) >= height + otherHeight);
  }

  set(words, x, y, width, height) {
    const { context, brush } = this.stage;
    context.globalAlpha = this.label.opacity;
    context.fillStyle = brush.inks[this.label.ground];
    context.fillRect(x - 0.5 * width, y - 0.5 * height, width, height);
    context.globalAlpha = 1;
    context.fillStyle = brush.inks[this.label.ink];
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(words, x, y);
    context.textBaseline = "alphabetic";
  }
}
