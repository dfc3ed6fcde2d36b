// Where everything is at any time: between two frames, balls go straight from bounce to bounce.

const ABSENT = 0;
const BOUNCE = 0;

/** The number of entries of `sorted` (from `low` up to `high`) that are at most `value`. */
function countUpTo(sorted, value, low = 0, high = sorted.length) {
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] <= value) low = middle + 1;
    else high = middle;
  }
  return low;
}

class Motion {
  constructor(run) {
    this.run = run;
    this.frames = run.times.length;
    this.start = run.times[0];
    this.end = run.times[this.frames - 1];
    this.bounces = Array.from({ length: run.balls.count }, () => ({ times: [], x: [], y: [] }));
    this.noteBounces();
  }

  /** Notes for every ball when it bounced, and where its centre was then. */
  noteBounces() {
    const { hits, shapes, balls } = this.run;
    for (let hit = 0; hit < hits.count; hit++) {
      if (hits.kind[hit] !== BOUNCE) continue;
      const other = hits.thing[hit] - shapes.length;
      // The normal points from the thing that was hit, which may be a ball too, to the ball.
      this.noteBounce(hits.ball[hit], hit, 1);
      if (other >= 0 && other < balls.count) this.noteBounce(other, hit, -1);
    }
  }

  noteBounce(ball, hit, side) {
    const { hits, balls } = this.run;
    if (ball >= balls.count) return;
    const bounces = this.bounces[ball];
    const distance = side * balls.radii[ball];
    bounces.times.push(hits.time[hit]);
    bounces.x.push(hits.x[hit] + distance * Math.cos(hits.normal[hit]));
    bounces.y.push(hits.y[hit] + distance * Math.sin(hits.normal[hit]));
  }

  /** The last frame that is not after `time`. */
  frameAt(time) {
    return Math.max(0, countUpTo(this.run.times, time) - 1);
  }

  /** The ball's way around `time`, as `[time, x, y]` before and after it; null where the ball is not there. */
  stretch(ball, time, frame) {
    const { times, balls } = this.run;
    const here = ball * this.frames + frame;
    if (balls.states[here] === ABSENT) return null;
    const before = [times[frame], balls.x[here], balls.y[here]];
    if (frame + 1 >= this.frames || balls.states[here + 1] === ABSENT) return [before, before];
    const after = [times[frame + 1], balls.x[here + 1], balls.y[here + 1]];
    const bounces = this.bounces[ball];
    const next = countUpTo(bounces.times, time);
    if (next > 0 && bounces.times[next - 1] > before[0]) this.bounceAt(bounces, next - 1, before);
    if (next < bounces.times.length && bounces.times[next] < after[0]) this.bounceAt(bounces, next, after);
    return [before, after];
  }

  bounceAt(bounces, index, knot) {
    knot[0] = bounces.times[index];
    knot[1] = bounces.x[index];
    knot[2] = bounces.y[index];
  }

  /** Where ball number `ball` is and how fast it goes, `{x, y, vx, vy, asleep}`; null where it is not there. */
  ballAt(ball, time, frame = this.frameAt(time)) {
    const stretch = this.stretch(ball, time, frame);
    if (!stretch) return null;
    const [[t0, x0, y0], [t1, x1, y1]] = stretch;
    const asleep = this.run.balls.states[ball * this.frames + frame] === 2;
    if (!(t1 > t0)) return { x: x0, y: y0, vx: 0, vy: 0, asleep };
    const share = (time - t0) / (t1 - t0);
    return {
      x: x0 + share * (x1 - x0),
      y: y0 + share * (y1 - y0),
      vx: (x1 - x0) / (t1 - t0),
      vy: (y1 - y0) / (t1 - t0),
      asleep,
    };
  }

  /** The points of a ball's way from `from` to `to`, `[time, x, y]` each, in unbroken stretches. */
  ways(ball, from, to) {
    const { times, balls } = this.run;
    const first = this.frameAt(from);
    const last = this.frameAt(to);
    const bounces = this.bounces[ball];
    let next = countUpTo(bounces.times, Math.max(from, times[first]));
    const found = [];
    let way = [];
    for (let frame = first; frame <= last; frame++) {
      const here = ball * this.frames + frame;
      if (balls.states[here] === ABSENT) {
        if (way.length) found.push(way);
        way = [];
        continue;
      }
      for (; next < bounces.times.length && bounces.times[next] < times[frame]; next++) {
        if (way.length) way.push([bounces.times[next], bounces.x[next], bounces.y[next]]);
      }
      if (times[frame] >= from || frame === first) way.push([times[frame], balls.x[here], balls.y[here]]);
    }
    for (; next < bounces.times.length && bounces.times[next] <= to; next++) {
      if (way.length) way.push([bounces.times[next], bounces.x[next], bounces.y[next]]);
    }
    const end = this.ballAt(ball, to, last);
    if (end && way.length) way.push([to, end.x, end.y]);
    if (way.length > 1) found.push(way);
    return found;
  }

  /** How the moving shape number `mover` stands: its turn since the beginning, and where its pivot was and is. */
  poseOf(mover, time) {
    const { times, moving } = this.run;
    const frame = this.frameAt(time);
    const start = mover * this.frames;
    const here = start + frame;
    const there = frame + 1 < this.frames ? here + 1 : here;
    const share = there > here ? (time - times[frame]) / (times[frame + 1] - times[frame]) : 0;
    // The shorter way round: angles may be a whole turn apart.
    const ahead = wrapped(moving.turns[there] - moving.turns[here]);
    const turn = moving.turns[here] + share * ahead - moving.turns[start];
    return {
      turn,
      cos: Math.cos(turn),
      sin: Math.sin(turn),
      fromX: moving.x[start],
      fromY: moving.y[start],
      toX: moving.x[here] + share * (moving.x[there] - moving.x[here]),
      toY: moving.y[here] + share * (moving.y[there] - moving.y[here]),
    };
  }

  /** Whether the shape number `index` collides at `time`: targets drop and rise. */
  collidesAt(shape, frame) {
    return shape.switched < 0 || this.run.switches[shape.switched * this.frames + frame] === 1;
  }
}

/** The angle between -π and π that is `angle` but for whole turns. */
function wrapped(angle) {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}
