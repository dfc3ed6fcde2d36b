// The list of hits. Only the rows in its window exist; a run may have a hundred thousand.

const ROW_HEIGHT = 30;
const KINDS = ["", "enters", "leaves"];

class HitList {
  constructor(run, labels, jump) {
    this.hits = run.hits;
    this.strong = run.strong.impulse;
    this.labels = labels;
    this.jump = jump;
    this.window = element("rows");
    this.spacer = element("spacer");
    this.listed = Uint32Array.from({ length: this.hits.count }, (_, hit) => hit);
    this.rows = [];
    this.current = -1;
    this.following = true;
    this.window.addEventListener("scroll", () => this.draw());
    for (const kind of ["wheel", "touchmove", "pointerdown"]) {
      this.window.addEventListener(kind, () => (this.following = false), { passive: true });
    }
    element("filter").addEventListener("input", (event) => this.filter(event.target.value));
    this.filter("");
  }

  /** Lists only the hits of balls and shapes whose names hold some words. */
  filter(words) {
    const wanted = words.trim().toLowerCase();
    const fits = this.labels.all.map((label) => label.toLowerCase().includes(wanted));
    const ofBall = (hit) => fits[this.labels.shapes + this.hits.ball[hit]];
    const found = [];
    for (let hit = 0; hit < this.hits.count; hit++) {
      if (fits[this.hits.thing[hit]] || ofBall(hit)) found.push(hit);
    }
    this.listed = Uint32Array.from(found);
    this.spacer.style.height = `${this.listed.length * ROW_HEIGHT}px`;
    this.tell(words);
    this.current = -1;
    this.draw();
  }

  /** Says how many hits there are, and what is left out. */
  tell(words) {
    const { count, total } = this.hits;
    const kept = count < total ? `the ${grouped(count)} strongest of ${grouped(total)} hits` : plural(total, "hit");
    element("hits-note").textContent = words.trim() ? `${grouped(this.listed.length)} of ${kept}` : kept;
  }

  /** Marks the last hit before `time`, and shows its row unless the reader looks elsewhere. */
  show(time) {
    const current = this.rowAt(time);
    if (current === this.current) return;
    this.current = current;
    if (this.following) this.reveal(current);
    this.draw();
  }

  /** The number of the last row whose hit is not after `time`; -1 if there is none. */
  rowAt(time) {
    let low = 0;
    let high = this.listed.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.hits.time[this.listed[middle]] <= time) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  reveal(row) {
    const top = Math.max(0, row) * ROW_HEIGHT;
    const { scrollTop, clientHeight } = this.window;
    if (top < scrollTop || top + ROW_HEIGHT > scrollTop + clientHeight) {
      this.window.scrollTop = top - 0.5 * clientHeight;
    }
  }

  draw() {
    const { scrollTop, clientHeight } = this.window;
    const first = Math.max(0, Math.floor(scrollTop / ROW_HEIGHT) - 2);
    const last = Math.min(this.listed.length, Math.ceil((scrollTop + clientHeight) / ROW_HEIGHT) + 2);
    while (this.rows.length < last - first) this.rows.push(this.newRow());
    this.rows.forEach((row, index) => this.fillRow(row, first + index < last ? first + index : -1));
  }

  newRow() {
    const row = make("button", "row");
    row.tabIndex = -1;
    row.parts = ["when", "dot", "what", "speed"].map((name) => row.appendChild(make("span", name)));
    row.addEventListener("click", () => this.choose(row.hit));
    this.spacer.append(row);
    return row;
  }

  fillRow(row, place) {
    row.hidden = place < 0;
    if (place < 0) return;
    const hit = this.listed[place];
    row.classList.toggle("now", place === this.current);
    row.style.top = `${place * ROW_HEIGHT}px`;
    if (row.hit === hit) return;
    row.hit = hit;
    const { time, kind, speed, impulse } = this.hits;
    const [when, dot, what, fast] = row.parts;
    when.textContent = time[hit].toFixed(2);
    dot.classList.toggle("sensor", kind[hit] !== BOUNCE);
    const size = kind[hit] === BOUNCE ? 4 + 8 * Math.sqrt(Math.min(1, impulse[hit] / this.strong)) : 8;
    dot.style.setProperty("--size", `${size}px`);
    what.textContent = this.labels.ofHit(hit, this.hits, KINDS[kind[hit]]);
    what.title = what.textContent;
    fast.textContent = kind[hit] === BOUNCE ? short(speed[hit]) : "";
  }

  choose(hit) {
    this.following = false;
    this.jump(hit);
  }

  /** The hit after or before `time` in the list; -1 if there is none. */
  neighbour(time, direction) {
    let row = this.rowAt(time);
    if (direction > 0) row += 1;
    else while (row >= 0 && this.hits.time[this.listed[row]] >= time) row -= 1;
    return row >= 0 && row < this.listed.length ? this.listed[row] : -1;
  }
}
