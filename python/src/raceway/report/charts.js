// SPDX-License-Identifier: GPL-2.0-or-later
// Draws the charts of a report as SVG in plain JavaScript, so the page loads nothing. A chart is
//   {title, x: {label, values}, y: label, lines: [{label, values, points}]}
// or, for a sweep, {table: {name: values}, x: name, y: name}, whose axes the reader selects.
// Dragging zooms, a double click shows everything, and values are shown at the mouse position.
"use strict";
(function () {
  const W = 960, H = 340, LEFT = 80, RIGHT = 20, TOP = 14, BOTTOM = 46;
  const COLOURS = ["#0072B2", "#E69F00", "#009E73", "#CC79A7", "#56B4E9", "#D55E00",
    "#000000", "#999999"];
  const SVG = "http://www.w3.org/2000/svg";

  function make(name, attributes, parent, text) {
    const element = name === "div" || name === "select" || name === "option" || name === "label"
      ? document.createElement(name) : document.createElementNS(SVG, name);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    if (text !== undefined) element.textContent = text;
    if (parent) parent.appendChild(element);
    return element;
  }

  const known = (value) => typeof value === "number" && isFinite(value);

  function range(rows) {
    let least = Infinity, most = -Infinity;
    for (const row of rows)
      for (const value of row)
        if (known(value)) { least = Math.min(least, value); most = Math.max(most, value); }
    if (!(least <= most)) return [0, 1];
    const room = most > least ? 0.05 * (most - least) : Math.abs(most) * 0.1 || 1;
    return [least - room, most + room];
  }

  function ticks(least, most) {
    const rough = (most - least) / 6, ten = Math.pow(10, Math.floor(Math.log10(rough)));
    const step = [1, 2, 5, 10].map((k) => k * ten).find((one) => one >= rough);
    const list = [];
    for (let k = Math.ceil(least / step); k * step <= most; ++k) list.push(k * step);
    return list;
  }

  const shown = (value) => known(value) ? String(Number(value.toPrecision(5))) : "–";

  function draw(box, chart) {
    box.querySelectorAll("svg, .legend, .read").forEach((old) => old.remove());
    const svg = make("svg", { viewBox: `0 0 ${W} ${H}`, class: "chart" }, box);
    const read = make("div", { class: "read" }, box, "\u00a0");
    const whole = { x: range([chart.x.values]), y: range(chart.lines.map((line) => line.values)) };
    let view = whole;

    function place(x, y) {
      return [LEFT + (x - view.x[0]) / (view.x[1] - view.x[0]) * (W - LEFT - RIGHT),
        H - BOTTOM - (y - view.y[0]) / (view.y[1] - view.y[0]) * (H - TOP - BOTTOM)];
    }
    function value(px, py) {
      return [view.x[0] + (px - LEFT) / (W - LEFT - RIGHT) * (view.x[1] - view.x[0]),
        view.y[0] + (H - BOTTOM - py) / (H - TOP - BOTTOM) * (view.y[1] - view.y[0])];
    }
    function mouse(event) {
      const at = svg.getBoundingClientRect();
      return [(event.clientX - at.left) * W / at.width, (event.clientY - at.top) * H / at.height];
    }

    const id = "clip" + Math.random().toString(36).slice(2);
    make("rect", { x: LEFT, y: TOP, width: W - LEFT - RIGHT, height: H - TOP - BOTTOM },
      make("clipPath", { id: id }, svg));
    const axes = make("g", {}, svg);
    const lines = make("g", { "clip-path": `url(#${id})` }, svg);
    const cursor = make("line", { y1: TOP, y2: H - BOTTOM, class: "cursor" }, svg);
    const frame = make("rect", { class: "zoom", width: 0, height: 0 }, svg);

    function redraw() {
      axes.replaceChildren();
      lines.replaceChildren();
      for (const x of ticks(...view.x)) {
        const [px] = place(x, view.y[0]);
        make("line", { x1: px, x2: px, y1: TOP, y2: H - BOTTOM, class: "grid" }, axes);
        make("text", { x: px, y: H - BOTTOM + 16, "text-anchor": "middle" }, axes, shown(x));
      }
      for (const y of ticks(...view.y)) {
        const [, py] = place(view.x[0], y);
        make("line", { x1: LEFT, x2: W - RIGHT, y1: py, y2: py, class: "grid" }, axes);
        make("text", { x: LEFT - 6, y: py + 4, "text-anchor": "end" }, axes, shown(y));
      }
      make("text", { x: (LEFT + W - RIGHT) / 2, y: H - 8, "text-anchor": "middle" }, axes,
        chart.x.label);
      make("text", { x: 14, y: (TOP + H - BOTTOM) / 2, "text-anchor": "middle",
        transform: `rotate(-90 14 ${(TOP + H - BOTTOM) / 2})` }, axes, chart.y);
      chart.lines.forEach((line, k) => {
        const colour = COLOURS[k % COLOURS.length];
        let path = "", pen = false;
        line.values.forEach((y, i) => {
          const x = chart.x.values[i];
          if (!known(x) || !known(y)) { pen = false; return; }
          const [px, py] = place(x, y);
          if (line.points) {
            make("circle", { cx: px, cy: py, r: 4, fill: colour }, lines);
          } else {
            path += (pen ? "L" : "M") + px.toFixed(1) + " " + py.toFixed(1);
            pen = true;
          }
        });
        if (path) make("path", { d: path, stroke: colour, fill: "none" }, lines);
      });
    }

    let start = null;
    svg.addEventListener("mousedown", (event) => { start = mouse(event); event.preventDefault(); });
    svg.addEventListener("mousemove", (event) => {
      const at = mouse(event), [x] = value(...at);
      let best = -1;
      chart.x.values.forEach((one, i) => {
        if (known(one) && (best < 0 || Math.abs(one - x) < Math.abs(chart.x.values[best] - x)))
          best = i;
      });
      if (best >= 0) {
        const [px] = place(chart.x.values[best], view.y[0]);
        cursor.setAttribute("x1", px);
        cursor.setAttribute("x2", px);
        read.textContent = `${chart.x.label}: ${shown(chart.x.values[best])}   ` + chart.lines
          .map((line) => `${line.label}: ${shown(line.values[best])}`).join("   ") +
          (chart.names ? "   " + chart.names[best] : "");
      }
      if (start) {
        frame.setAttribute("x", Math.min(start[0], at[0]));
        frame.setAttribute("y", Math.min(start[1], at[1]));
        frame.setAttribute("width", Math.abs(at[0] - start[0]));
        frame.setAttribute("height", Math.abs(at[1] - start[1]));
      }
    });
    window.addEventListener("mouseup", (event) => {
      if (!start) return;
      const end = mouse(event), a = value(...start), b = value(...end);
      if (Math.abs(end[0] - start[0]) > 5 && Math.abs(end[1] - start[1]) > 5) {
        view = { x: [Math.min(a[0], b[0]), Math.max(a[0], b[0])],
          y: [Math.min(a[1], b[1]), Math.max(a[1], b[1])] };
        redraw();
      }
      start = null;
      frame.setAttribute("width", 0);
    });
    svg.addEventListener("dblclick", () => { view = whole; redraw(); });
    redraw();
    if (chart.lines.length > 1) {
      const legend = make("div", { class: "legend" }, box);
      chart.lines.forEach((line, k) => {
        make("label", { style: `color: ${COLOURS[k % COLOURS.length]}` }, legend, line.label);
      });
    }
  }

  // draws a chart whose axes the reader selects
  function pick(box, chart) {
    const names = Object.keys(chart.table);
    const menus = {};
    for (const axis of ["x", "y"]) {
      const menu = make("select", {}, make("label", {}, box, axis + " "));
      for (const name of names) make("option", { value: name }, menu, name);
      menu.value = chart[axis];
      menus[axis] = menu;
      menu.addEventListener("change", again);
    }
    function again() {
      const x = menus.x.value, y = menus.y.value;
      draw(box, { x: { label: x, values: chart.table[x] }, y: y, names: chart.names,
        lines: [{ label: y, values: chart.table[y], points: true }] });
    }
    again();
  }

  for (const box of document.querySelectorAll("[data-chart]")) {
    const chart = JSON.parse(document.getElementById(box.dataset.chart).textContent);
    (chart.table ? pick : draw)(box, chart);
  }
})();
