/* SPDX-License-Identifier: GPL-2.0-or-later */
'use strict';

/** A number with three significant digits and a prefix that keeps it readable: "7.62 mN". */
function withPrefix(value, unit) {
  if (value === 0) return '0 ' + unit;
  const prefixes = [['', 1], ['m', 1e-3], ['µ', 1e-6], ['n', 1e-9]];
  const [name, size] = prefixes.find(([, s]) => Math.abs(value) >= s) || ['p', 1e-12];
  return Number((value / size).toPrecision(3)) + ' ' + name + unit;
}

/** An element with text, which is never read as HTML, and other elements in it. */
function element(name, ...content) {
  const result = document.createElement(name);
  result.append(...content);
  return result;
}

/** Finds the particle at a point, m, or within `reach` of it; null when there is none. */
function particleAt(packing, x, y, reach) {
  let found = null;
  let least = reach;
  for (let p = 0; p < packing.count; ++p)
    for (let k = packing.first[p]; k < packing.first[p + 1]; ++k) {
      const gap = Math.hypot(packing.spheres.x[k] - x, packing.spheres.y[k] - y) -
                  packing.spheres.radius[k];
      if (gap < least) [least, found] = [gap, p];
    }
  return found;
}

/** What is known of one particle, as pairs of a name and what to put beside it. */
function factsOf(packing, particle) {
  const d = packing.bed.diameter_m;
  const { x, y, gamma } = packing;
  const at = distance => [(distance * 1e3).toFixed(2) + ' mm = ' + (distance / d).toFixed(2) + ' ',
                          element('i', 'd'), element('sub', 'p')];
  const facts = [
    ['angle γ', gamma[particle] === null ? 'none: a sphere has no axis' : gamma[particle].toFixed(1) + '°'],
    ['from the left wall', at(x[particle] - packing.bed.left)],
    ['above the floor', at(y[particle] - packing.bed.floor)],
  ];
  if (!packing.contacts) return facts.concat([['contacts', 'not known: ' + packing.contactsMissing]]);
  const contacts = packing.contacts[particle];
  const sum = contacts.reduce((total, contact) => total + contact.force, 0);
  return facts.concat([
    ['sum of contact forces', withPrefix(sum, 'N')],
    ['touching neighbours', String(contacts.filter(contact => contact.particle !== null).length)],
  ]);
}

/** Shows what is known of one particle; `choose` is called with a neighbour that is clicked. */
function showDetails(panel, packing, particle, choose) {
  panel.replaceChildren();
  if (particle === null) {
    panel.append(element('p', 'No particle is chosen.'));
    return;
  }
  panel.append(element('h3', 'Particle ' + packing.id[particle]));
  const facts = element('dl');
  for (const [name, value] of factsOf(packing, particle))
    facts.append(element('dt', name), element('dd', ...[value].flat()));
  panel.append(facts);
  if (!packing.contacts || packing.contacts[particle].length === 0) return;
  const table = element('table', element('thead', element('tr', element('th', 'touches'), element('th', 'force'))));
  const body = element('tbody');
  for (const { particle: other, wall, force } of packing.contacts[particle]) {
    let name = wall;
    if (other !== null) {
      name = element('button', String(packing.id[other]));
      name.type = 'button';
      name.addEventListener('click', () => choose(other));
    }
    body.append(element('tr', element('td', name), element('td', withPrefix(force, 'N'))));
  }
  table.append(body);
  panel.append(table, element('p', 'Forces are magnitudes, summed over the sphere contacts of a pair as vectors.'));
}
