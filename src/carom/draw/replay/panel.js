// Words: names, numbers, and the panel beside the stage. All that comes from the scene is set as text, never as HTML.

function element(id) {
  return document.getElementById(id);
}

function make(tag, className = "", words = "") {
  const made = document.createElement(tag);
  made.className = className;
  made.textContent = words;
  return made;
}

function grouped(count) {
  return count.toLocaleString("en");
}

function plural(count, word) {
  return `${grouped(count)} ${word}${count === 1 ? "" : "s"}`;
}

/** A number with three digits that count. */
function short(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) return value.toExponential(1);
  return value.toFixed(Math.max(0, 2 - Math.floor(Math.log10(size))));
}

/** What to call shapes and balls. */
class Labels {
  constructor(run) {
    this.shapes = run.shapes.length;
    this.all = [...run.shapes.map((shape) => shape.label), ...run.ball_names, "something"];
  }

  ofHit(hit, hits, verb) {
    const ball = this.all[this.shapes + hits.ball[hit]];
    const thing = this.all[hits.thing[hit]];
    return verb ? `${ball} ${verb} ${thing}` : `${ball} · ${thing}`;
  }
}

/** A table of labels and values in `place`; the function that changes the values. */
function table(place, labels) {
  const list = place.appendChild(make("dl"));
  const cells = labels.map((label) => {
    list.append(make("dt", "", label));
    return list.appendChild(make("dd"));
  });
  return (values) => values.forEach((value, index) => {
    if (cells[index].textContent !== value) cells[index].textContent = value;
  });
}

class StatisticsPanel {
  constructor(run, motion, choose) {
    this.run = run;
    this.motion = motion;
    this.place = element("statistics");
    this.tellNow = table(this.place, ["hits so far", "balls there", "balls asleep", "kinetic energy"]);
    this.addChart();
    this.addRun();
    this.addShares(choose);
    this.drawn = table(this.place, ["drawn", "of which drawing"]);
    this.told = -Infinity;
  }

  addChart() {
    this.chart = this.place.appendChild(make("canvas", "chart"));
    this.chart.setAttribute("role", "img");
    this.chart.setAttribute("aria-label", "Kinetic energy over time");
  }

  /** The bars of touches by shape; a bar filters the list of hits. */
  addShares(choose) {
    if (!this.run.shares.length) return;
    this.place.append(make("h2", "", "Touches by shape"));
    for (const [label, count] of this.run.shares) {
      const row = this.place.appendChild(make(label ? "button" : "div", "share"));
      row.append(make("span", "label", label || "all others"), make("span", "count", grouped(count)));
      if (!label) continue;
      row.append(make("span", "bar"));
      row.title = "List these hits";
      row.style.setProperty("--share", count / this.run.shares[0][1]);
      row.addEventListener("click", () => choose(label));
    }
  }

  addRun() {
    this.place.append(make("h2", "", "The whole run"));
    const entries = Object.entries(this.run.facts);
    table(this.place, entries.map(([label]) => label))(entries.map(([, value]) => value));
  }

  /** Tells the state at `time`, a few times a second. */
  show(time, now, pace) {
    if (this.place.hidden || now - this.told < 120) return;
    this.told = now;
    const frame = this.motion.frameAt(time);
    const { balls, energy, hits } = this.run;
    let there = 0;
    let asleep = 0;
    for (let ball = 0; ball < balls.count; ball++) {
      const state = balls.states[ball * this.motion.frames + frame];
      if (state !== ABSENT) there++;
      if (state === 2) asleep++;
    }
    const before = grouped(countUpTo(hits.time, time));
    const kept = hits.count === hits.total ? before : `${before} of those kept`;
    this.tellNow([kept, grouped(there), grouped(asleep), short(energy[frame])]);
    this.drawn([`${pace.rate.toFixed(0)} frames a second`, `${pace.work.toFixed(1)} ms a frame`]);
    this.drawChart(frame);
  }

  drawChart(frame) {
    const { chart } = this;
    const { energy } = this.run;
    const [context, width, height] = sharp(chart);
    const style = getComputedStyle(document.documentElement);
    const most = energy.reduce((most, value) => Math.max(most, value), 0) || 1;
    const x = (index) => (width * index) / Math.max(1, energy.length - 1);
    const y = (value) => height - 2 - ((height - 4) * value) / most;
    context.clearRect(0, 0, width, height);
    context.strokeStyle = style.getPropertyValue("--moving");
    context.lineWidth = 1.5;
    context.beginPath();
    const stride = Math.max(1, Math.floor(energy.length / (2 * width)));
    for (let index = 0; index < energy.length; index += stride) context.lineTo(x(index), y(energy[index]));
    context.stroke();
    context.strokeStyle = style.getPropertyValue("--text");
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x(frame), 0);
    context.lineTo(x(frame), height);
    context.stroke();
  }
}

/** The context of a canvas that was fitted to its place in the page, and its size: `[context, width, height]`. */
function sharp(canvas) {
  const { clientWidth: width, clientHeight: height } = canvas;
  const ratio = window.devicePixelRatio || 1;
  const [columns, rows] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
  if (canvas.width !== columns || canvas.height !== rows) [canvas.width, canvas.height] = [columns, rows];
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return [context, width, height];
}

/** The switches of the layers, with samples of what they show. */
class LayersPanel {
  constructor(run, stage, changed) {
    this.stage = stage;
    this.changed = changed;
    this.samples = [];
    for (const layer of run.layers) this.addSwitch(layer, run.samples[layer.name] ?? []);
  }

  addSwitch(layer, samples) {
    const label = element("layers").appendChild(make("label", "switch"));
    const box = label.appendChild(document.createElement("input"));
    box.type = "checkbox";
    box.id = `layer-${layer.name}`;
    box.checked = layer.on;
    box.addEventListener("change", () => this.turn(layer.name, box.checked));
    label.append(make("span", "knob"), make("span", "label", layer.name));
    if (layer.name === "names") this.unnamed = label.appendChild(make("span", "quiet"));
    for (const sample of samples) this.addSample(label, sample);
  }

  /** A sample of the only thing that a layer shows stands beside its switch, those of several below it. */
  addSample(label, sample) {
    const row = sample.label ? element("layers").appendChild(make("div", "sample")) : label;
    this.samples.push([row.appendChild(make("canvas")), sample.calls]);
    if (sample.label) row.append(make("span", "", sample.label));
  }

  turn(name, on) {
    if (on) this.stage.shown.add(name);
    else this.stage.shown.delete(name);
    this.stage.stale = true;
    this.changed();
  }

  /** Says how many names have no room in the picture as it is, and would have some from nearer. */
  tellUnnamed() {
    const { shown, names } = this.stage;
    const words = shown.has("names") && names.leftOut ? `${plural(names.leftOut, "name")} without room` : "";
    if (this.unnamed.textContent !== words) this.unnamed.textContent = words;
  }

  /** Draws the samples in the colours of the theme. */
  drawSamples(inks) {
    for (const [canvas, calls] of this.samples) {
      const [context, width, height] = sharp(canvas);
      context.clearRect(0, 0, width, height);
      context.lineCap = context.lineJoin = "round";
      const view = { marks: 1, scale: 1, pixelX: (x) => 0.5 * width + x, pixelY: (y) => 0.5 * height - y };
      const brush = new Brush(context, view, this.stage.run.styles);
      brush.inks = inks;
      brush.play(calls);
    }
  }
}
