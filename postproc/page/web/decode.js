/* SPDX-License-Identifier: GPL-2.0-or-later */
'use strict';

// Packings as the page carries them (postproc/page/packing_data.h says how), and as they are used
// here: SI units, angles in degrees, one entry per particle or sphere.

/** Whole numbers, little endian, of `bits` each, from base64. */
function wholeNumbers(base64, bits) {
  const text = atob(base64);
  const bytes = bits / 8;
  const numbers = new Uint32Array(text.length / bytes);
  for (let i = 0; i < numbers.length; ++i)
    for (let k = 0; k < bytes; ++k) numbers[i] += text.charCodeAt(i * bytes + k) * 2 ** (8 * k);
  return numbers;
}

/** A column of 16 bits over its range. */
function column(base64, [lowest, highest]) {
  return Float64Array.from(wholeNumbers(base64, 16), q => lowest + (highest - lowest) * q / 65535);
}

/** Contacts by particle: for each a list of { particle, wall, force }, strongest first; `particle`
 *  is null at a wall and `wall` its name. */
function contactsByParticle(data) {
  if (!data.contacts) return null;
  const { walls, lowest_N, highest_N } = data.contacts;
  const bits = data.index_bits;
  const i = wholeNumbers(data.contacts.i, bits);
  const j = wholeNumbers(data.contacts.j, bits);
  const q = wholeNumbers(data.contacts.force, 16);
  const lists = Array.from({ length: data.particles }, () => []);
  for (let k = 0; k < q.length; ++k) {
    const force = q[k] === 0 ? 0 : lowest_N * (highest_N / lowest_N) ** ((q[k] - 1) / 65534);
    if (j[k] >= data.particles) {
      lists[i[k]].push({ particle: null, wall: walls[j[k] - data.particles], force });
    } else {
      lists[i[k]].push({ particle: j[k], wall: '', force });
      lists[j[k]].push({ particle: i[k], wall: '', force });
    }
  }
  for (const list of lists) list.sort((a, b) => b.force - a.force);
  return lists;
}

/** Places of the primary spheres, m; those of particle p are first[p] ... first[p + 1] - 1. */
function placeSpheres(packing, shapes) {
  const { count, shape, angle, x, y, radius } = packing;
  const first = new Uint32Array(count + 1);
  for (let p = 0; p < count; ++p) first[p + 1] = first[p] + shapes[shape[p]].centres.length;
  const spheres = { x: new Float64Array(first[count]), y: new Float64Array(first[count]),
                    radius: new Float64Array(first[count]) };
  const lastOfParticle = new Uint8Array(first[count]);
  for (let p = 0; p < count; ++p) lastOfParticle[first[p + 1] - 1] = 1;
  for (let p = 0; p < count; ++p) {
    const { centres, half_length_m } = shapes[shape[p]];
    const unit = centres.length > 1 ? 2 * (half_length_m - radius[p]) : 1;
    const c = unit * Math.cos(angle[p] * Math.PI / 180);
    const s = unit * Math.sin(angle[p] * Math.PI / 180);
    centres.forEach(([u, v], k) => {
      spheres.x[first[p] + k] = x[p] + c * u - s * v;
      spheres.y[first[p] + k] = y[p] + s * u + c * v;
      spheres.radius[first[p] + k] = radius[p];
    });
  }
  return { first, spheres, lastOfParticle };
}

/** A packing from the data of the page. */
function decodePacking(data) {
  const packing = {
    count: data.particles,
    bed: data.bed,
    scale: data.scale,
    x: column(data.x, data.x_range),
    y: column(data.y, data.y_range),
    radius: column(data.radius, data.radius_range),
    angle: Float64Array.from(wholeNumbers(data.angle, 16), q => 360 * q / 65536),
    shape: wholeNumbers(data.shape, 8),
    shade: wholeNumbers(data.shade, 8),
    contacts: contactsByParticle(data),
    contactsMissing: data.contacts_missing || '',
  };
  packing.id = 'ids' in data ? wholeNumbers(data.ids, 32)
                             : Uint32Array.from(packing.x, (_, p) => data.first_id + p);
  const range = data.shapes.map(shape => shape.gamma_range_deg);
  // null: a sphere has no axis
  packing.gamma = Array.from(packing.angle, (angle, p) =>
    range[packing.shape[p]] ? angle % range[packing.shape[p]] : null);
  return Object.assign(packing, placeSpheres(packing, data.shapes));
}
