/* SPDX-License-Identifier: GPL-2.0-or-later */
'use strict';

/** The pixels of a canvas, to paint a hundred thousand small discs in: many times as quick as the
 *  canvas's own circles. */
class Pixels {
  constructor(context) {
    this.context = context;
    this.image = context.getImageData(0, 0, context.canvas.width, context.canvas.height);
    this.bytes = this.image.data;
    this.words = new Uint32Array(this.bytes.buffer);  // a pixel each
  }

  /** Puts what was painted onto the canvas. */
  show() { this.context.putImageData(this.image, 0, 0); }

  /** Paints a disc with smooth edges; `colour`: from pixelColour(). All lengths in pixels. */
  disc(x, y, radius, colour) {
    const { width, height } = this.image;
    const inside = Math.max(radius - 0.5, 0) ** 2;
    const outside = (radius + 0.5) ** 2;
    const first = Math.max(Math.floor(x - radius - 0.5), 0);
    const last = Math.min(Math.ceil(x + radius + 0.5), width);
    const bottom = Math.min(Math.ceil(y + radius + 0.5), height);
    for (let row = Math.max(Math.floor(y - radius - 0.5), 0); row < bottom; ++row) {
      const dy = (row + 0.5 - y) ** 2;
      for (let column = first; column < last; ++column) {
        const squared = (column + 0.5 - x) ** 2 + dy;
        if (squared >= outside) continue;
        const at = row * width + column;
        if (squared <= inside) this.words[at] = colour.word;
        else this.blend(4 * at, Math.min(radius + 0.5 - Math.sqrt(squared), 1), colour);
      }
    }
  }

  blend(at, share, { red, green, blue }) {
    const { bytes } = this;
    bytes[at] += share * (red - bytes[at]);
    bytes[at + 1] += share * (green - bytes[at + 1]);
    bytes[at + 2] += share * (blue - bytes[at + 2]);
  }
}

/** "#rrggbb" as Pixels takes it. */
function pixelColour(text) {
  const [red, green, blue] = [1, 3, 5].map(at => parseInt(text.slice(at, at + 2), 16));
  const word = new Uint32Array(new Uint8Array([red, green, blue, 255]).buffer)[0];
  return { red, green, blue, word };
}
