/* SPDX-License-Identifier: GPL-2.0-or-later */
'use strict';

/** A picture of a packing that can be zoomed and asked. */
class Viewer {
  constructor(root) {
    this.canvas = root.querySelector('canvas');
    this.panel = root.querySelector('.viewer-details');
    this.bar = root.querySelector('.viewer-scale');
    this.input = root.querySelector('input');
    this.select = root.querySelector('select');
    this.pointers = new Map();  // fingers or mouse that are down, by their id
    root.querySelector('.viewer-case').hidden = this.select.options.length < 2;
    this.select.addEventListener('change', () => this.show(this.select.value));
    this.input.addEventListener('change', () => this.chooseById(Number(this.input.value)));
    for (const button of root.querySelectorAll('[data-do]'))
      button.addEventListener('click', () => this.act(button.dataset.do));
    this.listenToCanvas();
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    this.show(this.select.value);
  }

  /** Shows the packing of the data element with this id. */
  show(id) {
    this.packing = decodePacking(JSON.parse(document.getElementById(id).textContent));
    this.view = new View(this.packing.bed);
    this.chosen = null;
    this.input.value = '';
    const { left, right, floor, top } = this.packing.bed;
    // As high as the bed asks for, but not higher than it is wide.
    this.canvas.style.aspectRatio = String(Math.max((right - left) / (top - floor), 1));
    showScale(this.bar, this.packing.scale);
    showDetails(this.panel, this.packing, null, null);
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0) return;  // not laid out
    this.canvas.width = Math.round(width * window.devicePixelRatio);
    this.canvas.height = Math.round(height * window.devicePixelRatio);
    this.view.resize(width, height);
    this.drawNow();
  }

  /** Draws before the next frame of the screen; many calls draw once. What takes long to draw is
   *  shown as a stretched copy of the last picture first, and drawn when the motion rests. */
  draw() {
    // One finger scrolls the page while all is in sight, and moves the picture when it is zoomed.
    this.canvas.style.touchAction = this.view.isFitted() ? 'pan-y' : 'none';
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      clearTimeout(this.rest);
      if (!(this.milliseconds > 30)) return this.drawNow();
      this.drawCopy();
      this.rest = setTimeout(() => this.drawNow(), 150);
    });
  }

  context() {
    const context = this.canvas.getContext('2d', { willReadFrequently: true });
    context.setTransform(window.devicePixelRatio, 0, 0, window.devicePixelRatio, 0, 0);
    return context;
  }

  drawNow() {
    const begin = performance.now();
    drawPacking(this.context(), this.packing, this.view, this.chosen);
    this.milliseconds = performance.now() - begin;
    this.drawn = { copy: null, x: this.view.x, y: this.view.y, scale: this.view.scale };
  }

  /** Stretches and moves the last picture to where the view is now. */
  drawCopy() {
    const { width, height } = this.view;
    const { drawn } = this;
    if (!drawn.copy) {
      drawn.copy = document.createElement('canvas');
      drawn.copy.width = this.canvas.width;
      drawn.copy.height = this.canvas.height;
      drawn.copy.getContext('2d').drawImage(this.canvas, 0, 0);
    }
    const stretch = this.view.scale / drawn.scale;
    const [x, y] = this.view.toScreen(drawn.x, drawn.y);
    const context = this.context();
    context.fillStyle = '#ffffff';
    context.fillRect(0, 0, width, height);
    context.drawImage(drawn.copy, x - stretch * width / 2, y - stretch * height / 2, stretch * width, stretch * height);
  }

  choose(particle) {
    this.chosen = particle;
    this.input.value = particle === null ? '' : this.packing.id[particle];
    if (particle !== null) this.view.bringIntoSight(this.packing.x[particle], this.packing.y[particle]);
    showDetails(this.panel, this.packing, particle, other => this.choose(other));
    this.drawNow();
  }

  chooseById(id) {
    const place = this.packing.id.indexOf(id);
    this.choose(place < 0 ? null : place);
    if (place < 0) this.panel.replaceChildren(element('p', 'There is no particle ' + id + '.'));
  }

  act(what) {
    const [x, y] = [this.view.width / 2, this.view.height / 2];
    const step = 0.1 * this.view.width;
    const actions = {
      in: () => this.view.zoomAt(x, y, 1.5),
      out: () => this.view.zoomAt(x, y, 1 / 1.5),
      fit: () => this.view.fit(),
      left: () => this.view.pan(step, 0),
      right: () => this.view.pan(-step, 0),
      up: () => this.view.pan(0, step),
      down: () => this.view.pan(0, -step),
      none: () => this.choose(null),
    };
    actions[what]();
    this.draw();
  }

  listenToCanvas() {
    const { canvas } = this;
    const keys = { '+': 'in', '=': 'in', '-': 'out', '0': 'fit', ArrowLeft: 'left', ArrowRight: 'right',
                   ArrowUp: 'up', ArrowDown: 'down', Escape: 'none' };
    canvas.addEventListener('keydown', event => {
      if (!(event.key in keys) || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      this.act(keys[event.key]);
    });
    canvas.addEventListener('wheel', event => {
      const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1);
      // At the end of the zoom the page scrolls on.
      if (!this.view.zoomAt(event.offsetX, event.offsetY, Math.exp(-pixels / 400))) return;
      event.preventDefault();
      this.draw();
    }, { passive: false });
    canvas.addEventListener('pointerdown', event => this.pointerDown(event));
    canvas.addEventListener('pointermove', event => this.pointerMove(event));
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, event => this.pointerUp(event));
  }

  pointerDown(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    this.moved = this.pointers.size > 1 ? Infinity : 0;  // pixels since the press: a click has few
  }

  pointerMove(event) {
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return;
    const [dx, dy] = [event.offsetX - pointer.x, event.offsetY - pointer.y];
    this.moved += Math.hypot(dx, dy);
    const other = [...this.pointers.values()].find(each => each !== pointer);
    if (other) {
      const before = Math.hypot(pointer.x - other.x, pointer.y - other.y);
      const now = Math.hypot(event.offsetX - other.x, event.offsetY - other.y);
      this.view.pan(dx / 2, dy / 2);
      if (before > 0) this.view.zoomAt((event.offsetX + other.x) / 2, (event.offsetY + other.y) / 2, now / before);
    } else if (!this.view.isFitted() && this.moved > 4) {
      this.view.pan(dx, dy);
    }
    pointer.x = event.offsetX;
    pointer.y = event.offsetY;
    this.draw();
  }

  pointerUp(event) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (event.type === 'pointercancel' || this.moved > 4) return;
    const reach = (event.pointerType === 'mouse' ? 2 : 10) / this.view.scale;
    this.choose(particleAt(this.packing, ...this.view.toPacking(event.offsetX, event.offsetY), reach));
  }
}

/** The colour bar, with the values at its ends and between. */
function showScale(bar, scale) {
  const strip = element('span');
  strip.className = 'strip';
  strip.style.background = 'linear-gradient(to right, ' + scale.colours.join(', ') + ')';
  const values = element('span');
  values.className = 'values';
  for (let k = 0; k * scale.tick <= scale.highest * (1 + 1e-9); ++k) {
    const value = Number((k * scale.tick).toPrecision(6));
    const tick = element('span', String(value));
    tick.style.left = 100 * value / scale.highest + '%';
    values.append(tick);
  }
  const label = element('span', scale.label + (scale.open_top ? ', brightest from ' + scale.highest + ' on' : ''));
  bar.replaceChildren(element('span', strip, values), label);
}
