// The part of the world that is shown: fitted to the window, then zoomed and moved by the reader.

const CLOSEST = 400;
const FARTHEST = 0.2;
const AROUND = 22; // pixels around the stage when all of it is shown

class View {
  constructor([left, bottom, right, top], usualSize) {
    this.stage = { left, bottom, right, top };
    this.usualSize = usualSize;
    this.zoom = 1;
    this.resize(1, 1);
    this.fit();
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
    const { left, bottom, right, top } = this.stage;
    const across = Math.max(1, width - 2 * AROUND) / (right - left);
    const along = Math.max(1, height - 2 * AROUND) / (top - bottom);
    this.fitted = Math.min(across, along);
    // Lines, dots and names are meant for stages of the usual size; on smaller ones they are finer, on larger ones larger.
    const longer = this.fitted * Math.max(right - left, top - bottom);
    this.marks = Math.min(2, Math.max(0.55, longer / this.usualSize));
  }

  /** Shows all of the stage. */
  fit() {
    const { left, bottom, right, top } = this.stage;
    this.zoom = 1;
    this.x = 0.5 * (left + right);
    this.y = 0.5 * (bottom + top);
  }

  /** Pixels per unit of length. */
  get scale() {
    return this.fitted * this.zoom;
  }

  pixelX(x) {
    return 0.5 * this.width + (x - this.x) * this.scale;
  }

  pixelY(y) {
    return 0.5 * this.height - (y - this.y) * this.scale;
  }

  worldX(pixel) {
    return this.x + (pixel - 0.5 * this.width) / this.scale;
  }

  worldY(pixel) {
    return this.y - (pixel - 0.5 * this.height) / this.scale;
  }

  /** Zooms so that what lies at a pixel stays there. */
  zoomAt(pixelX, pixelY, factor) {
    const x = this.worldX(pixelX);
    const y = this.worldY(pixelY);
    this.zoom = Math.min(CLOSEST, Math.max(FARTHEST, this.zoom * factor));
    this.x += x - this.worldX(pixelX);
    this.y += y - this.worldY(pixelY);
    this.keepNear();
  }

  /** Moves what is shown by some pixels. */
  moveBy(pixelsX, pixelsY) {
    this.x -= pixelsX / this.scale;
    this.y += pixelsY / this.scale;
    this.keepNear();
  }

  /** Keeps the middle of the window on the stage, so that no one gets lost. */
  keepNear() {
    const { left, bottom, right, top } = this.stage;
    this.x = Math.min(right, Math.max(left, this.x));
    this.y = Math.min(top, Math.max(bottom, this.y));
  }

  /** Whether a point is in the window. */
  shows(x, y) {
    const pixelX = this.pixelX(x);
    const pixelY = this.pixelY(y);
    return pixelX >= 0 && pixelX <= this.width && pixelY >= 0 && pixelY <= this.height;
  }

  /** Brings a point into the window, if it is not there. */
  showPoint(x, y) {
    if (this.shows(x, y)) return;
    this.x = x;
    this.y = y;
  }
}
