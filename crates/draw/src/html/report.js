"use strict";

// Tables: a click sorts by the column, a second one the other way. Numbers carry their value in data-key.
for (const button of document.querySelectorAll("th button")) {
  button.addEventListener("click", () => {
    const head = button.parentElement, body = head.closest("table").tBodies[0], column = head.cellIndex;
    const down = head.getAttribute("aria-sort") === "ascending";
    for (const other of head.parentElement.cells) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    const key = row => row.cells[column].dataset.key, text = row => row.cells[column].textContent;
    // Cells without a number come last either way.
    const order = (a, b) => {
      const x = key(a), y = key(b), sign = down ? -1 : 1;
      if (x !== undefined && y !== undefined) return sign * (x - y);
      if (x !== undefined || y !== undefined) return x !== undefined ? -1 : 1;
      return sign * text(a).localeCompare(text(b), "en", { numeric: true });
    };
    const rows = [...body.rows].sort(order);
    for (const row of rows) row.classList.remove("group");
    body.append(...rows);
  });
}

// Folded details are part of the print.
addEventListener("beforeprint", () => {
  for (const details of document.querySelectorAll("details:not([open])")) { details.open = true; details.dataset.print = ""; }
});
addEventListener("afterprint", () => {
  for (const details of document.querySelectorAll("details[data-print]")) { details.open = false; delete details.dataset.print; }
});

function bytes(figure, name) {
  const source = figure.querySelector(`script[data-name=${name}]`);
  if (!source) return new ArrayBuffer(0);
  const text = atob(source.textContent), out = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) out[i] = text.charCodeAt(i);
  source.remove();
  return out.buffer;
}

// Painters of all canvases, to be run at once when the page is there.
const painters = [];

// A canvas that can be moved and zoomed; `paint` draws it, given the view and the page's colours.
function stage(canvas, paint) {
  const draw = canvas.getContext("2d"), wide = +canvas.dataset.width, high = +canvas.dataset.height;
  const view = { zoom: 1, left: 0, top: 0, scale: 1, width: 0, height: 0, moved: () => `${Math.round(view.left - home)} ${Math.round(view.top)}` };
  let fit = 1, home = 0, waiting = false;

  function now() {
    waiting = false;
    const colours = getComputedStyle(document.documentElement), colour = name => colours.getPropertyValue(name).trim();
    view.scale = fit * view.zoom;
    draw.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    draw.clearRect(0, 0, view.width, view.height);
    draw.lineCap = "round";
    paint(draw, view, colour);
  }

  function soon() {
    if (!waiting) { waiting = true; requestAnimationFrame(now); }
  }

  function reset() {
    view.width = canvas.clientWidth;
    fit = Math.min(view.width / wide, 760 / high);
    view.height = Math.max(60, fit * high);
    canvas.style.height = `${view.height}px`;
    canvas.width = Math.round(view.width * devicePixelRatio);
    canvas.height = Math.round(view.height * devicePixelRatio);
    view.zoom = 1;
    home = view.left = (view.width - fit * wide) / 2;
    view.top = 0;
    soon();
  }

  function zoomBy(factor, x, y) {
    const next = Math.min(1e5, Math.max(0.5, view.zoom * factor)), by = next / view.zoom;
    view.left = x - (x - view.left) * by;
    view.top = y - (y - view.top) * by;
    view.zoom = next;
    soon();
  }

  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    zoomBy(Math.pow(2, -event.deltaY / 300), event.offsetX, event.offsetY);
  }, { passive: false });
  // One finger or the mouse moves; two fingers zoom around their middle.
  const held = new Map();
  canvas.addEventListener("pointerdown", event => {
    // A pointer that is not really there, as a test's, cannot be captured.
    try { canvas.setPointerCapture(event.pointerId); } catch (error) { if (event.isTrusted) throw error; }
    held.set(event.pointerId, [event.offsetX, event.offsetY]);
  });
  canvas.addEventListener("pointermove", event => {
    const before = held.get(event.pointerId);
    if (!before) return;
    const now = [event.offsetX, event.offsetY], others = [...held].filter(([id]) => id !== event.pointerId);
    if (others.length) {
      const [, other] = others[0], far = p => Math.hypot(p[0] - other[0], p[1] - other[1]) || 1;
      zoomBy(far(now) / far(before), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
    } else {
      view.left += now[0] - before[0];
      view.top += now[1] - before[1];
      soon();
    }
    held.set(event.pointerId, now);
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, event => held.delete(event.pointerId));
  canvas.addEventListener("dblclick", reset);
  canvas.addEventListener("keydown", event => {
    const moves = { ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] }, move = moves[event.key];
    if (move) { view.left += move[0]; view.top += move[1]; soon(); }
    else if (event.key === "+" || event.key === "=") zoomBy(1.5, view.width / 2, view.height / 2);
    else if (event.key === "-") zoomBy(1 / 1.5, view.width / 2, view.height / 2);
    else if (event.key === "0") reset();
    else return;
    event.preventDefault();
  });
  addEventListener("resize", () => { if (canvas.clientWidth !== view.width) reset(); });
  canvas.closest("details")?.addEventListener("toggle", () => { if (canvas.clientWidth !== view.width) reset(); });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", soon);
  reset();
  painters.push(now);
  return { soon };
}

function mesh(canvas) {
  const figure = canvas.closest("figure");
  const points = new Float32Array(bytes(figure, "points"));
  const layer = name => new Uint32Array(bytes(figure, name));
  const edges = layer("edges"), segments = layer("segments"), highlights = layer("highlights"), fills = layer("fills");
  const wide = +canvas.dataset.width, high = +canvas.dataset.height;

  // Edges wholly beyond one side of the window are skipped; long paths are stroked in pieces, which browsers draw faster.
  function lines(draw, view, list, scale, x0, y0) {
    const { width, height } = view;
    let pending = 0;
    draw.beginPath();
    for (let i = 0; i < list.length; i += 2) {
      const a = 2 * list[i], b = 2 * list[i + 1];
      const ax = points[a] * scale + x0, ay = points[a + 1] * scale + y0;
      const bx = points[b] * scale + x0, by = points[b + 1] * scale + y0;
      if ((ax < 0 && bx < 0) || (ay < 0 && by < 0) || (ax > width && bx > width) || (ay > height && by > height)) continue;
      draw.moveTo(ax, ay);
      draw.lineTo(bx, by);
      if (++pending === 4000) { draw.stroke(); draw.beginPath(); pending = 0; }
    }
    draw.stroke();
  }

  function areas(draw, scale, x0, y0, colour) {
    for (let turn = 0; turn < 8; turn++) {
      draw.beginPath();
      for (let i = 0; i < fills.length; i += 4) {
        if (fills[i] !== turn) continue;
        for (let k = 1; k <= 3; k++) {
          const v = 2 * fills[i + k], x = points[v] * scale + x0, y = points[v + 1] * scale + y0;
          if (k === 1) draw.moveTo(x, y); else draw.lineTo(x, y);
        }
        draw.closePath();
      }
      draw.fillStyle = colour(`--fill${turn}`);
      draw.fill();
    }
  }

  stage(canvas, (draw, view, colour) => {
    const { scale, width, height } = view, x0 = view.left, y0 = view.top;
    if (fills.length) areas(draw, scale, x0, y0, colour);
    // About as far apart as vertices are on the screen: thin lines where they are dense, dots where there is room.
    const room = scale * Math.sqrt(wide * high / Math.max(1, points.length / 2));
    draw.strokeStyle = colour("--edge");
    draw.lineWidth = Math.min(1, Math.max(0.15, room / 16));
    lines(draw, view, edges, scale, x0, y0);
    draw.strokeStyle = colour("--segment");
    draw.lineWidth = Math.min(2.4, Math.max(0.8, room / 6));
    lines(draw, view, segments, scale, x0, y0);
    draw.strokeStyle = colour("--highlight");
    draw.lineWidth = 3;
    lines(draw, view, highlights, scale, x0, y0);
    if (room > 14 || !edges.length && !segments.length) {
      const r = Math.min(3, Math.max(0.6, room / 8));
      draw.fillStyle = colour("--site");
      for (let i = 0; i < points.length; i += 2) {
        const x = points[i] * scale + x0, y = points[i + 1] * scale + y0;
        if (x < -r || y < -r || x > width + r || y > height + r) continue;
        draw.beginPath();
        draw.arc(x, y, r, 0, 7);
        draw.fill();
      }
    }
  });
}

for (const canvas of document.querySelectorAll("canvas.mesh")) mesh(canvas);
