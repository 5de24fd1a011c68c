/* SPDX-License-Identifier: GPL-2.0-or-later */
'use strict';

/** Which part of a packing a picture shows: lengths in m with y up, pixels with y down. */
class View {
  /** `bed`: left, right, floor and top of what there is to see, m. */
  constructor(bed) {
    this.bed = bed;
    this.width = 1;
    this.height = 1;
    this.fit();
  }

  /** Tells the size of the picture in pixels; what is in its middle stays there. */
  resize(width, height) {
    const fitted = this.isFitted();
    this.width = width;
    this.height = height;
    if (fitted) this.fit();
  }

  fitScale() {
    const { left, right, floor, top } = this.bed;
    return 0.98 * Math.min(this.width / (right - left), this.height / (top - floor));
  }

  /** Shows all. */
  fit() {
    const { left, right, floor, top } = this.bed;
    this.x = (left + right) / 2;
    this.y = (floor + top) / 2;
    this.scale = this.fitScale();  // pixels per m
  }

  isFitted() { return this.scale <= this.fitScale() * 1.0001; }

  toScreen(x, y) {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  toPacking(px, py) {
    return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale];
  }

  /** Zooms so that what is at this pixel stays there. Returns whether anything changed. */
  zoomAt(px, py, factor) {
    const before = this.scale;
    const [x, y] = this.toPacking(px, py);
    const lowest = this.fitScale();
    this.scale = Math.min(Math.max(this.scale * factor, lowest), 400 * lowest);
    if (this.scale === lowest) {
      this.fit();
    } else {
      this.x = x - (px - this.width / 2) / this.scale;
      this.y = y + (py - this.height / 2) / this.scale;
      this.keepInside();
    }
    return this.scale !== before;
  }

  /** Moves the picture by so many pixels. */
  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    this.keepInside();
  }

  /** Brings a point into the picture's middle, if it is not in sight. */
  bringIntoSight(x, y) {
    const [px, py] = this.toScreen(x, y);
    if (px > 0 && py > 0 && px < this.width && py < this.height) return;
    this.x = x;
    this.y = y;
  }

  keepInside() {
    const { left, right, floor, top } = this.bed;
    this.x = Math.min(Math.max(this.x, left), right);
    this.y = Math.min(Math.max(this.y, floor), top);
  }
}
