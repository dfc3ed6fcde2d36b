// The bar that scrubs through the run, over a picture of how many hits there were when.

const BAR_STEP = 4; // pixels from one bar of the picture to the next

class Timeline {
  constructor(run, motion, seek) {
    this.run = run;
    this.motion = motion;
    this.canvas = element("density");
    this.input = element("scrub");
    this.input.min = motion.start;
    this.input.max = motion.end;
    this.input.addEventListener("input", () => seek(Number(this.input.value)));
  }

  /** Counts the hits for each bar that there is room for. */
  resize() {
    const [, width] = sharp(this.canvas);
    const bars = Math.max(1, Math.floor(width / BAR_STEP));
    const span = this.motion.end - this.motion.start || 1;
    this.counts = new Float64Array(bars);
    for (const time of this.run.hits.time) {
      this.counts[Math.min(bars - 1, Math.floor((bars * (time - this.motion.start)) / span))]++;
    }
    this.most = this.counts.reduce((most, count) => Math.max(most, count), 1);
    this.drawn = -1;
  }

  show(time) {
    const share = (time - this.motion.start) / (this.motion.end - this.motion.start || 1);
    // In steps of a third of a pixel or so: each costs the browser a repaint.
    const played = share === 1 ? 1 : share.toFixed(4);
    if (played !== this.played) {
      this.played = played;
      this.input.value = time;
      this.input.style.setProperty("--played", played);
    }
    this.draw(Math.floor(share * this.counts.length));
  }

  draw(played) {
    if (played === this.drawn) return;
    this.drawn = played;
    const [context, , height] = sharp(this.canvas);
    context.clearRect(0, 0, this.canvas.width, height);
    context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--hit");
    this.counts.forEach((count, bar) => {
      const size = count ? 2 + (height - 2) * Math.sqrt(count / this.most) : 0;
      context.globalAlpha = bar < played ? 0.85 : 0.28;
      context.fillRect(bar * BAR_STEP, height - size, BAR_STEP - 1, size);
    });
  }
}
