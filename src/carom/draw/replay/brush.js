// Plays recorded calls of a painter on a canvas. Every number has a part in units of the world and a part in pixels,
// so that places grow when the reader zooms in, while dots, arrows and lines keep their size.

const FONT = "system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif";
const QUARTERS = [0, 0.5 * Math.PI, Math.PI, 1.5 * Math.PI];

/** The angle from 0 to a whole turn that is `angle` but for whole turns. */
function turned(angle) {
  return angle - 2 * Math.PI * Math.floor(angle / (2 * Math.PI));
}

/** How what does not move has moved: not at all. */
const STILL = { turn: 0, cos: 1, sin: 0, fromX: 0, fromY: 0, toX: 0, toY: 0 };

/** Where a stamp, which was drawn at (0, 0) and along +x, is set: at a place of the world, turned by an angle. */
function poseAt(x, y, turn) {
  return { turn, cos: Math.cos(turn), sin: Math.sin(turn), fromX: 0, fromY: 0, toX: x, toY: y };
}

class Brush {
  constructor(context, view, styles) {
    this.context = context;
    this.view = view;
    this.styles = styles;
    this.inks = {};
  }

  /** Plays calls; `pose` says how what they show has moved since the beginning, `opacity` fades it. */
  play(calls, pose = STILL, opacity = 1) {
    for (const call of calls) {
      const style = this.styles[call[1]];
      if (call[0] === "text") this.write(call, style, pose);
      else this.mark(call, style, pose, opacity);
    }
  }

  /** Draws lines along those of calls, as a glow. */
  glow(calls, pose, width, opacity) {
    for (const call of calls) {
      if (call[0] === "text") continue;
      this.trace(call, pose);
      this.stroke("glow", width, opacity);
    }
  }

  mark(call, style, pose, opacity) {
    this.trace(call, pose);
    const { context } = this;
    if (style.fill !== null) {
      context.globalAlpha = opacity * style.opacity * style.fill_opacity;
      context.fillStyle = this.inks[style.fill];
      context.fill();
    }
    if (style.stroke !== null) {
      context.setLineDash(style.dash.map((length) => length * this.view.marks));
      this.stroke(style.stroke, style.width, opacity * style.opacity);
      context.setLineDash([]);
    }
    context.globalAlpha = 1;
  }

  stroke(ink, width, opacity) {
    const { context } = this;
    context.globalAlpha = opacity;
    context.strokeStyle = this.inks[ink];
    context.lineWidth = width * this.view.marks;
    context.stroke();
    context.globalAlpha = 1;
  }

  /** Makes the path of a call. */
  trace(call, pose) {
    const { context } = this;
    const [kind, , places] = call;
    context.beginPath();
    if (kind === "segment" || kind === "polyline") {
      for (let index = 0; index < places.length; index += 2) {
        const [x, y] = this.place(call, index, pose);
        if (index === 0) context.moveTo(x, y);
        else context.lineTo(x, y);
      }
      if (kind === "polyline" && this.styles[call[1]].fill !== null) context.closePath();
      return;
    }
    const [x, y] = this.place(call, 0, pose);
    const radius = Math.max(0, this.number(call, 2) * this.view.scale);
    if (kind === "circle") {
      context.arc(x, y, radius, 0, 2 * Math.PI);
    } else {
      // The world's angles run counterclockwise with y up, those of a canvas clockwise with y down.
      const from = this.number(call, 3) + pose.turn;
      context.arc(x, y, radius, -from, -(this.number(call, 4) + pose.turn), true);
    }
  }

  /** The box around a line or a circle, in pixels. */
  box(call, pose) {
    const [kind, , numbers] = call;
    const xs = [];
    const ys = [];
    const add = (x, y) => {
      xs.push(x);
      ys.push(y);
    };
    if (kind === "segment" || kind === "polyline") {
      for (let index = 0; index < numbers.length; index += 2) add(...this.place(call, index, pose));
    } else {
      const [x, y] = this.place(call, 0, pose);
      // In units of the world's own: a point has a box without extent, however large its dot.
      const radius = numbers[2] * this.view.scale;
      for (const angle of kind === "circle" ? QUARTERS : this.extremes(call, pose)) {
        add(x + radius * Math.cos(angle), y - radius * Math.sin(angle));
      }
    }
    return { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) };
  }

  /** The angles of an arc's ends, and those at which it reaches farthest left, right, up or down. */
  extremes(call, pose) {
    const start = call[2][3] + pose.turn;
    const sweep = turned(call[2][4] - call[2][3]);
    return [start, start + sweep, ...QUARTERS.filter((angle) => turned(angle - start) < sweep)];
  }

  write(call, lettering, pose) {
    const { context } = this;
    const [x, y] = this.place(call, 0, pose);
    context.font = `${lettering.bold ? "600 " : ""}${lettering.size * Math.max(0.8, this.view.marks)}px ${FONT}`;
    context.textAlign = { start: "left", middle: "center", end: "right" }[lettering.anchor];
    context.fillStyle = this.inks[lettering.ink];
    context.fillText(call[4], x, y);
  }

  /** The number at `index` of a call, in units of the world. */
  number(call, index) {
    const pixels = call[3];
    return call[2][index] + (pixels ? (pixels[index] * this.view.marks) / this.view.scale : 0);
  }

  /** The pixel of the place at `index` of a call. */
  place(call, index, pose) {
    return this.pixel(this.number(call, index), this.number(call, index + 1), pose);
  }

  /** The pixel of a place that moves with a pose. */
  pixel(worldX, worldY, pose) {
    const x = worldX - pose.fromX;
    const y = worldY - pose.fromY;
    return [
      this.view.pixelX(pose.toX + pose.cos * x - pose.sin * y),
      this.view.pixelY(pose.toY + pose.sin * x + pose.cos * y),
    ];
  }
}
