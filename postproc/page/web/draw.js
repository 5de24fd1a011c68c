/* SPDX-License-Identifier: GPL-2.0-or-later */
'use strict';

const edgeColour = '#202020';
const chosenColour = '#D55E00';
const neighbourColour = '#0072B2';

/** Spheres that the view shows, as places among all. */
function visibleSpheres(packing, view) {
  const { x, y, radius } = packing.spheres;
  const [left, top] = view.toPacking(0, 0);
  const [right, bottom] = view.toPacking(view.width, view.height);
  const seen = [];
  for (let k = 0; k < x.length; ++k)
    if (x[k] + radius[k] > left && x[k] - radius[k] < right && y[k] + radius[k] > bottom &&
        y[k] - radius[k] < top) seen.push(k);
  return seen;
}

/** Whether a sphere hardly overlaps the next one of its particle: a small disc joins the two, in the
 *  groove that no other sphere can reach, so that one particle is not taken for two. */
function joinsNext(packing, k) {
  const { x, y, radius } = packing.spheres;
  if (packing.lastOfParticle[k]) return false;
  return Math.hypot(x[k + 1] - x[k], y[k + 1] - y[k]) > Math.sqrt(3) * radius[k];
}

/** Draws discs: all dark ones first, then the shaded ones a little smaller on top, so that each
 *  particle has one outline and its spheres have none between them. */
function drawSpheres(context, packing, view, spheres) {
  const { x, y, radius } = packing.spheres;
  const finer = window.devicePixelRatio;  // pixels of the canvas for one of the view
  const outline = Math.min(Math.max(0.06 * packing.bed.diameter_m * view.scale, 0.3), 3);
  const dark = pixelColour(edgeColour);
  const shades = packing.scale.colours.map(pixelColour);
  const pixels = new Pixels(context);
  const paint = (k, narrower, colour) => {
    const [px, py] = view.toScreen(x[k], y[k]);
    pixels.disc(px * finer, py * finer, (radius[k] * view.scale - narrower) * finer, colour);
  };
  const joints = spheres.filter(k => joinsNext(packing, k));
  const paintJoint = (k, narrower, colour) => {
    const [px, py] = view.toScreen((x[k] + x[k + 1]) / 2, (y[k] + y[k + 1]) / 2);
    pixels.disc(px * finer, py * finer, (radius[k] / 2 * view.scale - narrower) * finer, colour);
  };
  for (const k of spheres) paint(k, 0, dark);
  for (const k of joints) paintJoint(k, 0, dark);
  for (const k of joints) paintJoint(k, outline, shades[packing.shade[k]]);
  for (const k of spheres) paint(k, outline, shades[packing.shade[k]]);
  pixels.show();
}

function drawWalls(context, packing, view) {
  const { left, right, floor, top, sides, bottom } = packing.bed;
  context.strokeStyle = edgeColour;
  context.lineWidth = 2;
  context.beginPath();
  const [leftAt, floorAt] = view.toScreen(left, floor);
  const [rightAt, topAt] = view.toScreen(right, top);
  if (sides) {
    context.moveTo(leftAt - 1, topAt);
    context.lineTo(leftAt - 1, floorAt + 2);
    context.moveTo(rightAt + 1, topAt);
    context.lineTo(rightAt + 1, floorAt + 2);
  }
  if (bottom) {
    context.moveTo(leftAt - 2, floorAt + 1);
    context.lineTo(rightAt + 2, floorAt + 1);
  }
  context.stroke();
}

function spheresOf(packing, particle) {
  const spheres = [];
  for (let k = packing.first[particle]; k < packing.first[particle + 1]; ++k) spheres.push(k);
  return spheres;
}

/** A coloured rim around one particle. */
function drawRim(context, packing, view, particle, colour, width) {
  context.fillStyle = colour;
  for (const k of spheresOf(packing, particle)) {
    const [px, py] = view.toScreen(packing.spheres.x[k], packing.spheres.y[k]);
    context.beginPath();
    context.arc(px, py, packing.spheres.radius[k] * view.scale + width, 0, 2 * Math.PI);
    context.fill();
  }
}

/** Shows one particle with its neighbours above the faded others, and lines from centre to centre
 *  whose width goes with the force. */
function drawChosen(context, packing, view, particle) {
  context.fillStyle = 'rgba(255, 255, 255, 0.6)';
  context.fillRect(0, 0, view.width, view.height);
  drawWalls(context, packing, view);
  const touching = packing.contacts ? packing.contacts[particle] : [];
  const neighbours = touching.filter(contact => contact.particle !== null);
  const rim = Math.min(Math.max(0.06 * packing.bed.diameter_m * view.scale, 1.5), 4);
  for (const { particle: other } of neighbours) drawRim(context, packing, view, other, neighbourColour, rim);
  drawSpheres(context, packing, view, neighbours.flatMap(contact => spheresOf(packing, contact.particle)));
  drawRim(context, packing, view, particle, chosenColour, 1.5 * rim);
  drawSpheres(context, packing, view, spheresOf(packing, particle));
  const strongest = Math.max(...touching.map(contact => contact.force), 0);
  context.strokeStyle = chosenColour;
  context.lineCap = 'round';
  for (const { particle: other, force } of neighbours) {
    context.lineWidth = Math.max(1, strongest > 0 ? 2.5 * rim * force / strongest : 0);
    context.beginPath();
    context.moveTo(...view.toScreen(packing.x[particle], packing.y[particle]));
    context.lineTo(...view.toScreen(packing.x[other], packing.y[other]));
    context.stroke();
  }
}

/** Draws what the view shows; `chosen`: the particle that is asked, or null. */
function drawPacking(context, packing, view, chosen) {
  context.fillStyle = '#ffffff';
  context.fillRect(0, 0, view.width, view.height);
  drawSpheres(context, packing, view, visibleSpheres(packing, view));
  drawWalls(context, packing, view);
  if (chosen !== null) drawChosen(context, packing, view, chosen);
}
