/* SPDX-License-Identifier: GPL-2.0-or-later */
'use strict';

for (const root of document.querySelectorAll('.viewer')) root.viewer = new Viewer(root);

// What is folded on the screen is printed.
const folded = () => document.querySelectorAll('details:not([open])');
let opened = [];
window.addEventListener('beforeprint', () => {
  opened = [...folded()];
  for (const details of opened) details.open = true;
});
window.addEventListener('afterprint', () => {
  for (const details of opened) details.open = false;
});
