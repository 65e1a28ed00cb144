// Scenes: layers to switch, steps to go through. Things are quintuples or quadruples: corners, first step, first step without.
function scene(figure) {
  const canvas = figure.querySelector("canvas"), state = figure.querySelector(".state"), detail = figure.querySelector(".detail");
  const points = new Float32Array(bytes(figure, "points"));
  const things = name => new Uint32Array(bytes(figure, name));
  const triangles = things("triangles"), constraints = things("constraints"), ghosts = things("ghosts"), forced = things("forced"), wires = things("wires");
  const told = new TextDecoder().decode(bytes(figure, "steps"));
  const steps = told === "" ? [] : told.split("\x1e").map(line => {
    const [title, marked, more] = line.split("\x1f");
    return { title, marked: marked === "" ? [] : marked.split(" ").map(Number), more };
  });
  const slider = figure.querySelector("input[type=range]");
  const boxes = [...figure.querySelectorAll("input[data-layer]")], shows = name => boxes.some(box => box.dataset.layer === name && box.checked);
  const [long, tall] = canvas.dataset.lengths.split(" ").map(Number), box = canvas.dataset.box.split(" ").map(Number);
  let step = Math.max(0, steps.length - 1), pointer = null, playing = 0;

  // Calls `use` for each thing that is there, with its first word's place and whether it is new.
  function each(list, corners, use) {
    const width = corners + 2;
    for (let i = 0; i < list.length; i += width) {
      const from = list[i + corners], until = list[i + corners + 1];
      if (from <= step && step < until) use(i, from === step && step > 0);
    }
  }

  function count(list, corners) {
    let sum = 0;
    each(list, corners, () => sum++);
    return sum;
  }

  const stageOf = stage(canvas, (draw, view, colour) => {
    const x = v => points[2 * v] * view.scale + view.left, y = v => points[2 * v + 1] * view.scale + view.top;
    const line = (a, b) => { draw.moveTo(x(a), y(a)); draw.lineTo(x(b), y(b)); };
    const stroke = (paint, width, dash) => { draw.strokeStyle = colour(paint); draw.lineWidth = width; draw.setLineDash(dash || []); draw.stroke(); draw.setLineDash([]); };
    draw.beginPath();
    each(triangles, 3, (i, isNew) => {
      if (!isNew) return;
      line(triangles[i], triangles[i + 1]);
      draw.lineTo(x(triangles[i + 2]), y(triangles[i + 2]));
      draw.closePath();
    });
    draw.fillStyle = colour("--fill0");
    draw.fill();
    if (shows("edges")) {
      draw.beginPath();
      each(triangles, 3, i => { const [a, b, c] = triangles.subarray(i, i + 3); line(a, b); line(b, c); line(c, a); });
      each(wires, 2, i => line(wires[i], wires[i + 1]));
      stroke("--edge", 1);
      // What came: of wires, edges; of triangles, those that are filled.
      draw.beginPath();
      each(wires, 2, (i, isNew) => { if (isNew) line(wires[i], wires[i + 1]); });
      stroke("--segment", 1.6);
      // What went at this step.
      draw.beginPath();
      for (let i = 0; i < triangles.length; i += 5) {
        if (step === 0 || triangles[i + 4] !== step) continue;
        const [a, b, c] = triangles.subarray(i, i + 3);
        line(a, b); line(b, c); line(c, a);
      }
      for (let i = 0; i < wires.length; i += 4) if (step > 0 && wires[i + 3] === step) line(wires[i], wires[i + 1]);
      stroke("--warn", 1, [4, 4]);
    }
    if (shows("circles")) {
      draw.beginPath();
      each(triangles, 3, (i, isNew) => {
        if (steps.length && !isNew) return;
        const [a, b, c] = triangles.subarray(i, i + 3), ux = x(b) - x(a), uy = y(b) - y(a), vx = x(c) - x(a), vy = y(c) - y(a);
        const d = 2 * (ux * vy - uy * vx), u = ux * ux + uy * uy, v = vx * vx + vy * vy;
        const cx = (vy * u - uy * v) / d, cy = (ux * v - vx * u) / d, r = Math.hypot(cx, cy);
        if (!(r < 1e6)) return;
        draw.moveTo(x(a) + cx + r, y(a) + cy);
        draw.arc(x(a) + cx, y(a) + cy, r, 0, 7);
      });
      stroke("--region", 0.8);
    }
    if (shows("ghosts")) {
      draw.beginPath();
      each(ghosts, 2, i => {
        const a = ghosts[i], b = ghosts[i + 1], dx = x(b) - x(a), dy = y(b) - y(a), far = 28 / (Math.hypot(dx, dy) || 1);
        for (const t of [0.1, 0.5, 0.9]) {
          const px = x(a) + t * dx, py = y(a) + t * dy;
          draw.moveTo(px, py);
          draw.lineTo(px - far * dy, py + far * dx);
        }
      });
      stroke("--quiet", 1, [2, 3]);
    }
    if (shows("constraints")) {
      draw.beginPath();
      each(constraints, 2, i => line(constraints[i], constraints[i + 1]));
      stroke("--segment", 2.4);
    }
    if (shows("forced")) {
      draw.beginPath();
      each(forced, 2, i => line(forced[i], forced[i + 1]));
      stroke("--highlight", 2.4, [6, 3]);
    }
    if (shows("sites")) {
      draw.beginPath();
      for (let v = 0; 2 * v < points.length; v++) { draw.moveTo(x(v) + 2.5, y(v)); draw.arc(x(v), y(v), 2.5, 0, 7); }
      draw.fillStyle = colour("--site");
      draw.fill();
    }
    draw.beginPath();
    for (const v of steps.length ? steps[step].marked : []) { draw.moveTo(x(v) + 6, y(v)); draw.arc(x(v), y(v), 6, 0, 7); }
    stroke("--highlight", 2);
    say(view);
  });

  // The place of the pointer in the input's own coordinates.
  function place(view) {
    if (!pointer) return "";
    const u = ((pointer[0] - view.left) / view.scale - canvas.dataset.width / 2) / (long || 1) + 0.5;
    const v = 0.5 - ((pointer[1] - view.top) / view.scale - canvas.dataset.height / 2) / (tall || 1);
    const between = (t, low, high) => (low * (1 - t) + high * t).toPrecision(6);
    return `; at (${between(u, box[0], box[1])}, ${between(v, box[2], box[3])})`;
  }

  function say(view) {
    const at = steps.length ? `step ${step} of ${steps.length - 1}: ${steps[step].title}; ` : "";
    state.textContent = `${at}${points.length / 2} sites, ${count(triangles, 3)} triangles, ${wires.length ? count(wires, 2) + " loose edges, " : ""}${count(constraints, 2)} constraints, `
      + `${count(forced, 2)} not Delaunay, ${count(ghosts, 2)} ghosts; zoom ${view.zoom.toFixed(2)}, moved ${view.moved()}${place(view)}`;
    detail.textContent = steps.length ? steps[step].more : "";
    detail.hidden = detail.textContent === "";
  }

  function go(to) {
    step = Math.min(steps.length - 1, Math.max(0, to));
    slider.value = step;
    stageOf.soon();
  }

  const moves = { first: () => go(0), back: () => go(step - 1), next: () => go(step + 1), play: () => {
    clearInterval(playing);
    if (playing) { playing = 0; return; }
    if (step === steps.length - 1) go(0);
    playing = setInterval(() => { go(step + 1); if (step === steps.length - 1) { clearInterval(playing); playing = 0; } }, 400);
  } };
  for (const button of figure.querySelectorAll("button[data-go]")) button.addEventListener("click", moves[button.dataset.go]);
  slider?.addEventListener("input", () => go(+slider.value));
  for (const box of boxes) box.addEventListener("change", stageOf.soon);
  canvas.addEventListener("pointermove", event => { pointer = [event.offsetX, event.offsetY]; stageOf.soon(); });
  canvas.addEventListener("keydown", event => {
    if (steps.length && (event.key === "n" || event.key === "p")) go(step + (event.key === "n" ? 1 : -1));
  });
}

for (const figure of document.querySelectorAll("figure.scene")) scene(figure);

// The address may say what to do once the page is there, as a reader would with mouse and keys, so that tests can:
// #do=click;SELECTOR|drag;SELECTOR;DX;DY|wheel;SELECTOR;DY|key;SELECTOR;KEY|measure;SELECTOR
for (const act of decodeURIComponent(location.hash).startsWith("#do=") ? decodeURIComponent(location.hash).slice(4).split("|") : []) {
  const [what, selector, ...how] = act.split(";"), element = document.querySelector(selector);
  if (!element) continue;
  const box = element.getBoundingClientRect(), at = (dx, dy) => ({ clientX: box.left + box.width / 2 + dx, clientY: box.top + box.height / 2 + dy, pointerId: 1, bubbles: true });
  if (what === "click") element.click();
  if (what === "measure") element.dataset.beyond = element.scrollWidth - element.clientWidth;
  if (what === "wheel") element.dispatchEvent(new WheelEvent("wheel", { ...at(0, 0), deltaY: +how[0], cancelable: true }));
  if (what === "key") element.dispatchEvent(new KeyboardEvent("keydown", { key: how[0], bubbles: true, cancelable: true }));
  if (what === "drag") {
    element.dispatchEvent(new PointerEvent("pointerdown", at(0, 0)));
    element.dispatchEvent(new PointerEvent("pointermove", at(+how[0], +how[1])));
    element.dispatchEvent(new PointerEvent("pointerup", at(+how[0], +how[1])));
  }
}

for (const paint of painters) paint();
