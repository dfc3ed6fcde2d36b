// Where the balls that are followed have been.

const TRACK_SECONDS = 2;
const TRACK_TOLERANCE = 0.1; // pixels by which a track may miss the way of a ball

class Tracks {
  constructor(stage) {
    this.stage = stage;
  }

  /** Draws where the balls that are followed have been, fading with age; those of one ink in one go. */
  draw() {
    const { context, run, view, brush, motion, time } = this.stage;
    const { bands, width } = run.marks.track;
    context.lineWidth = width * view.marks;
    // Round ends would make beads where the parts of a translucent line meet.
    context.lineCap = "butt";
    const start = time - TRACK_SECONDS;
    const inks = new Map();
    for (const ball of run.followed) {
      const ink = run.ball_inks[ball];
      if (!inks.has(ink)) inks.set(ink, bands.map(() => new Path2D()));
      for (const way of motion.ways(ball, start, time)) this.traceWay(this.thinned(way), start, inks.get(ink));
    }
    for (const [ink, paths] of inks) {
      context.strokeStyle = brush.inks[ink];
      paths.forEach((path, band) => {
        context.globalAlpha = bands[band];
        context.stroke(path);
      });
    }
    context.globalAlpha = 1;
    context.lineCap = "round";
  }

  /** The points of a way in pixels, without those between which it goes straight. */
  thinned(way) {
    const { view } = this.stage;
    const points = way.map(([time, x, y]) => [time, view.pixelX(x), view.pixelY(y)]);
    const kept = [points[0]];
    for (let index = 1; index + 1 < points.length; index++) {
      const [, fromX, fromY] = kept.at(-1);
      const [, x, y] = points[index];
      const [dx, dy] = [points[index + 1][1] - fromX, points[index + 1][2] - fromY];
      const beside = Math.abs(dx * (y - fromY) - dy * (x - fromX));
      const along = dx * (x - fromX) + dy * (y - fromY);
      const length = Math.hypot(dx, dy);
      if (along < 0 || along > length * length || beside > TRACK_TOLERANCE * length) kept.push(points[index]);
    }
    kept.push(points.at(-1));
    return kept;
  }

  /** Adds the parts of a way to the paths of the bands of age that they belong to. */
  traceWay(points, start, paths) {
    const bandSeconds = TRACK_SECONDS / paths.length;
    let band = -1;
    for (let index = 1; index < points.length; index++) {
      const [t0, x0, y0] = points[index - 1];
      const [t1, x1, y1] = points[index];
      const first = Math.max(0, Math.floor((t0 - start) / bandSeconds));
      const last = Math.min(paths.length - 1, Math.floor((t1 - start) / bandSeconds));
      for (let next = first; next <= last; next++) {
        const from = Math.max(0, (start + next * bandSeconds - t0) / (t1 - t0 || 1));
        const to = Math.min(1, (start + (next + 1) * bandSeconds - t0) / (t1 - t0 || 1));
        if (next !== band) paths[next].moveTo(x0 + from * (x1 - x0), y0 + from * (y1 - y0));
        paths[next].lineTo(x0 + to * (x1 - x0), y0 + to * (y1 - y0));
        band = next;
      }
    }
  }
}
