// The names of shapes and balls: each beside what it names, over no other name, and over no ball while there is room
// elsewhere. As `carom.draw.parts.labels` places those of pictures.

class Names {
  constructor(stage) {
    this.stage = stage;
    this.widths = new Map();
    this.leftOut = 0;
  }

  draw() {
    const { run, view, context, motion, time } = this.stage;
    this.label = run.marks.label;
    this.size = this.label.size * Math.max(0.85, view.marks);
    context.font = `${this.size}px ${FONT}`;
    this.labels = [];
    this.leftOut = 0;
    this.findBalls();
    for (const { words, mover, places } of run.names) {
      const pose = mover < 0 ? STILL : motion.poseOf(mover, time);
      this.place(words, places.map((place) => [...this.stage.brush.pixel(...place, pose), this.label.clear]));
    }
    const named = new Set(run.named);
    this.stage.eachBall((ball, x, y, radius) => {
      if (named.has(ball)) this.place(run.ball_names[ball], [[x, y, radius]]);
    });
    this.labels.forEach((label) => this.lead(label));
    this.labels.forEach((label) => this.write(label));
  }

  /** Notes the boxes of the balls: middle, width and height; none where there are many. */
  findBalls() {
    this.balls = [];
    if (this.stage.run.balls.count > this.label.most_balls) return;
    this.stage.eachBall((ball, x, y, radius) => this.balls.push({ x, y, width: 2 * radius, height: 2 * radius }));
  }

  /** Notes the label at the first candidate that is in the window and over nothing, else over balls alone. */
  place(words, places) {
    const width = this.widthOf(words) + 4 * this.label.around;
    const height = this.size + 2 * this.label.around;
    const { view } = this.stage;
    let overBalls = null;
    for (const label of this.candidates(words, places, width, height)) {
      const inside = label.x >= width / 2 && label.y >= height / 2
        && label.x + width / 2 <= view.width && label.y + height / 2 <= view.height;
      if (!inside || this.labels.some((other) => overlap(label, other))) continue;
      if (!this.balls.some((ball) => overlap(label, ball))) {
        this.labels.push(label);
        return;
      }
      overBalls ??= label;
    }
    if (overBalls) this.labels.push(overBalls);
    else this.leftOut += 1;
  }

  /** The labels that words may become: at each side of each place, then farther off, with a line that leads there. */
  *candidates(words, places, width, height) {
    const { gap, farther, sides, slant } = this.label;
    for (const more of farther) {
      for (const [x, y, clearance] of places) {
        for (const [right, below] of sides) {
          const off = (clearance + gap + more) * (right && below ? slant : 1);
          const middle = { x: x + right * (off + width / 2), y: y + below * (off + height / 2) };
          yield { words, width, height, ...middle, from: more ? [x, y] : null };
        }
      }
    }
  }

  widthOf(words) {
    const key = `${this.size} ${words}`;
    if (!this.widths.has(key)) this.widths.set(key, this.stage.context.measureText(words).width);
    return this.widths.get(key);
  }

  /** Draws the line from what is named to a label that stands off. */
  lead({ x, y, width, height, from }) {
    if (!from) return;
    const { context, brush } = this.stage;
    const within = (value, middle, half) => Math.min(Math.max(value, middle - half), middle + half);
    context.beginPath();
    context.moveTo(...from);
    context.lineTo(within(from[0], x, width / 2), within(from[1], y, height / 2));
    brush.stroke(this.label.leader, this.label.leader_width, 1);
  }

  write({ words, x, y, width, height }) {
    const { context, brush } = this.stage;
    context.globalAlpha = this.label.opacity;
    context.fillStyle = brush.inks[this.label.ground];
    context.fillRect(x - width / 2, y - height / 2, width, height);
    context.globalAlpha = 1;
    context.fillStyle = brush.inks[this.label.ink];
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(words, x, y);
    context.textBaseline = "alphabetic";
  }
}

/** Whether two boxes, known by their middles, have more than an edge in common. */
function overlap(one, other) {
  return 2 * Math.abs(one.x - other.x) < one.width + other.width
    && 2 * Math.abs(one.y - other.y) < one.height + other.height;
}
