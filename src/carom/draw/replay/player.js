// The clock of the page: what time of the run is shown, and how it goes on.

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8];

class Player {
  constructor(motion, changed) {
    this.motion = motion;
    this.changed = changed;
    this.time = motion.start;
    this.speed = 1;
    this.playing = false;
  }

  play() {
    if (this.time >= this.motion.end) this.time = this.motion.start;
    this.playing = this.motion.end > this.motion.start;
    this.last = null;
    this.changed();
  }

  pause() {
    this.playing = false;
    this.changed();
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Shows another time; goes on playing from there if it was playing. */
  seek(time) {
    this.time = Math.min(this.motion.end, Math.max(this.motion.start, time));
    this.changed();
  }

  /** Shows the next frame that was recorded, or the one before. */
  step(direction) {
    this.playing = false;
    const { times } = this.motion.run;
    const frame = this.motion.frameAt(this.time);
    const between = times[frame] < this.time;
    const next = frame + (direction > 0 ? 1 : between ? 0 : -1);
    this.seek(times[Math.min(times.length - 1, Math.max(0, next))]);
  }

  /** Goes on to the moment `now` (milliseconds); a moment in which the page was not shown does not count. */
  advance(now) {
    if (!this.playing) return;
    const passed = this.last === null ? 0 : Math.min(250, now - this.last);
    this.last = now;
    this.time += (this.speed * passed) / 1000;
    if (this.time < this.motion.end) return;
    this.time = this.motion.end;
    this.playing = false;
    this.changed();
  }
}
