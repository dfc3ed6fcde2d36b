// Puts the page together and keeps it going.

const LIST_PAUSE = 100; // milliseconds

/** Remembers how long the last frames took, as `rate` (a second) and `work` (milliseconds of drawing each). */
class Pace {
  constructor() {
    this.moments = [];
    this.works = [];
  }

  note(now, work) {
    this.moments.push(now);
    this.works.push(work);
    if (this.moments.length > 120) [this.moments, this.works] = [this.moments.slice(-60), this.works.slice(-60)];
  }

  /** Forgets the frames so far: there was a pause. */
  reset() {
    this.moments = [];
  }

  get rate() {
    const { moments } = this;
    return moments.length < 2 ? 0 : (1000 * (moments.length - 1)) / (moments.at(-1) - moments[0]);
  }

  get work() {
    return this.works.reduce((sum, work) => sum + work, 0) / Math.max(1, this.works.length);
  }
}

class Page {
  constructor(run) {
    this.run = run;
    this.motion = new Motion(run);
    this.view = new View(run.stage, run.size);
    this.stage = new Stage(element("canvas"), run, this.motion, this.view);
    this.player = new Player(this.motion, () => this.changed());
    this.pace = new Pace();
    this.listed = 0;
    this.labels = new Labels(run);
    this.list = new HitList(run, this.labels, (hit) => this.jump(hit));
    this.timeline = new Timeline(run, this.motion, (time) => this.seek(time));
    this.statistics = new StatisticsPanel(run, this.motion, (label) => this.listOnly(label));
    this.layers = new LayersPanel(run, this.stage, () => this.changed());
    this.fingers = new Fingers(this.stage.canvas, this.view, () => this.moved(), (place) => this.point(place));
    this.digits = this.motion.end < 0.1 ? 5 : this.motion.end < 10 ? 3 : 2;
    this.name();
    this.connect();
    this.useTheme(run.themes[run.theme] ? run.theme : this.preferred());
    new ResizeObserver(() => this.resize()).observe(this.stage.canvas);
    this.resize();
  }

  name() {
    element("name").textContent = this.run.name;
    element("about").textContent = this.run.about;
    element("duration").textContent = `/ ${this.motion.end.toFixed(this.digits)} s`;
    for (const speed of SPEEDS) element("speed").add(new Option(`${speed}×`, speed, speed === 1, speed === 1));
  }

  connect() {
    const press = {
      "start-pause": () => this.togglePlay(),
      "step-back": () => this.step(-1),
      "step-forth": () => this.step(1),
      "hit-back": () => this.jumpBy(-1),
      "hit-forth": () => this.jumpBy(1),
      "zoom-in": () => this.fingers.zoom(1.5),
      "zoom-out": () => this.fingers.zoom(1 / 1.5),
      fit: () => this.fingers.fit(),
      theme: () => this.useTheme(this.theme === "dark" ? "light" : "dark"),
      help: () => this.toggleKeys(),
    };
    for (const [id, action] of Object.entries(press)) element(id).addEventListener("click", action);
    for (const tab of document.querySelectorAll("[role=tab]")) {
      tab.addEventListener("click", () => this.openTab(tab.id.slice("tab-".length)));
    }
    element("keys").addEventListener("click", () => this.toggleKeys());
    element("speed").addEventListener("change", (event) => (this.player.speed = Number(event.target.value)));
    this.connectKeys(press);
  }

  connectKeys(press) {
    const by = (seconds) => this.seek(this.player.time + seconds);
    listenToKeys({
      " ": press["start-pause"],
      k: press["start-pause"],
      ArrowLeft: (event) => (event.shiftKey ? by(-1) : this.step(-1)),
      ArrowRight: (event) => (event.shiftKey ? by(1) : this.step(1)),
      Home: () => this.seek(this.motion.start),
      End: () => this.seek(this.motion.end),
      n: press["hit-forth"],
      p: press["hit-back"],
      "+": press["zoom-in"],
      "=": press["zoom-in"],
      "-": press["zoom-out"],
      0: press.fit,
      t: press.theme,
      "?": press.help,
      "[": () => this.changeSpeed(-1),
      "]": () => this.changeSpeed(1),
    });
  }

  /** Shows the list of keys, or hides it; Escape and a click hide it too. */
  toggleKeys() {
    const keys = element("keys");
    if (keys.open) keys.close();
    else keys.showModal();
  }

  // -- time -----------------------------------------------------------------------------------------------------------

  togglePlay() {
    this.stage.selected = -1;
    this.list.following = true;
    this.player.toggle();
  }

  step(direction) {
    this.stage.selected = -1;
    this.list.following = true;
    this.player.step(direction);
  }

  seek(time) {
    this.stage.selected = -1;
    this.list.following = true;
    this.player.seek(time);
  }

  /** Shows a hit: the time of it, and the place of it with a mark around. */
  jump(hit) {
    this.player.pause();
    this.player.seek(this.run.hits.time[hit]);
    const bounced = this.run.hits.kind[hit] === BOUNCE;
    this.stage.selected = bounced ? hit : -1;
    if (bounced) this.view.showPoint(this.run.hits.x[hit], this.run.hits.y[hit]);
    this.moved();
  }

  jumpBy(direction) {
    const hit = this.list.neighbour(this.player.time, direction);
    if (hit < 0) return;
    this.list.following = true;
    this.jump(hit);
  }

  changeSpeed(direction) {
    const place = SPEEDS.indexOf(this.player.speed) + direction;
    if (!(place in SPEEDS)) return;
    this.player.speed = SPEEDS[place];
    element("speed").value = SPEEDS[place];
  }

  // -- looks ----------------------------------------------------------------------------------------------------------

  preferred() {
    return window.matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  }

  useTheme(name) {
    this.theme = name;
    const inks = this.run.themes[name];
    const { style } = document.documentElement;
    style.colorScheme = name;
    for (const [ink, colour] of Object.entries(inks)) style.setProperty(`--${ink}`, colour);
    this.stage.useInks(inks);
    this.layers.drawSamples(inks);
    this.timeline.drawn = -1;
    this.changed();
  }

  resize() {
    this.stage.resize();
    this.timeline.resize();
    this.list.draw();
    this.draw(performance.now());
  }

  openTab(name) {
    chooseTab(name);
    this.layers.drawSamples(this.run.themes[this.theme]);
    this.statistics.told = -Infinity;
    this.list.current = -1;
    this.changed();
  }

  /** Lists the hits of one shape only. */
  listOnly(label) {
    element("filter").value = label;
    this.list.filter(label);
    this.openTab("hits");
  }

  /** Tells what the reader points at. */
  point(place) {
    const output = element("pointed");
    const words = place && this.wordsAt(...place);
    output.hidden = !words;
    if (!words) return;
    output.textContent = words;
    output.style.transform = `translate(${place[0] + 14}px, ${place[1] + 16}px)`;
  }

  wordsAt(x, y) {
    let words = "";
    this.stage.eachBall((ball, ballX, ballY, radius, { vx, vy }) => {
      if (Math.hypot(x - ballX, y - ballY) > Math.max(4, radius)) return;
      words = `${this.run.ball_names[ball]} · speed ${short(Math.hypot(vx, vy))}`;
    });
    return words;
  }

  // -- frames ---------------------------------------------------------------------------------------------------------

  /** The view was moved. */
  moved() {
    this.stage.stale = true;
    this.point(null);
    this.changed();
  }

  /** Something is to be drawn anew: once, before the browser shows its next frame. */
  changed() {
    this.waiting ??= requestAnimationFrame((now) => this.tick(now));
  }

  tick(now) {
    this.waiting = null;
    this.player?.advance(now);
    this.draw(now);
    if (this.player.playing) this.changed();
    else this.pace.reset();
  }

  draw(now) {
    const began = performance.now();
    const { time, playing } = this.player;
    this.stage.draw(time);
    this.layers.tellUnnamed();
    this.timeline.show(time);
    this.showHits(time, playing ? now : Infinity);
    element("time").textContent = time.toFixed(this.digits);
    this.showPlaying(playing, time >= this.motion.end);
    this.pace.note(now, performance.now() - began);
    this.statistics.show(time, playing ? now : Infinity, this.pace);
  }

  /** Brings the list of hits up to a time: a few times a second while it goes on, for no one reads faster. */
  showHits(time, now) {
    if (element("hits").hidden || now - this.listed < LIST_PAUSE) return;
    this.listed = now === Infinity ? 0 : now;
    this.list.show(time);
  }

  showPlaying(playing, ended) {
    const state = playing ? "pause" : ended ? "again" : "play";
    if (this.state === state) return;
    this.state = state;
    element("start-pause").querySelector("use").setAttribute("href", `#i-${state}`);
    const words = { pause: "Pause", again: "Play again", play: "Play" }[state];
    element("start-pause").title = `${words} (space)`;
    element("start-pause").setAttribute("aria-label", words);
  }
}

try {
  const run = await readRun(JSON.parse(element("run").textContent));
  // For those who look inside: the page's whole state, from the console.
  window.replay = new Page(run);
  const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
  // No element may have that id: browsers scroll to it, and the page around a frame with it.
  if (location.hash === "#play" && !still) window.replay.player.play();
  document.documentElement.dataset.ready = "yes";
} catch (error) {
  const trouble = element("trouble");
  trouble.hidden = false;
  trouble.textContent = "This run cannot be shown. The browser may be too old, or the file damaged.";
  throw error;
}
