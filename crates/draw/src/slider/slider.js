"use strict";
const plate = document.getElementById("plate"), cut = document.getElementById("cut");
const said = document.getElementById("said"), play = document.getElementById("play");
const pen = plate.getContext("2d");
const there = (ids) => ids.slice(0, -1).every((v) => points[v]);
function path(ids) {
  pen.beginPath();
  ids.forEach((v, i) => (i ? pen.lineTo(...points[v]) : pen.moveTo(...points[v])));
}
function draw() {
  const ranks = Number(cut.value);
  pen.fillStyle = "#ffffff";
  pen.fillRect(0, 0, plate.width, plate.height);
  pen.fillStyle = "#9ecae9";
  for (const t of triangles) if (t[3] < ranks && there(t)) { path(t.slice(0, 3)); pen.fill(); }
  pen.strokeStyle = "#1f4e79";
  pen.lineWidth = 0.7;
  for (const e of edges) if (e[2] < ranks && there(e)) { path(e.slice(0, 2)); pen.stroke(); }
  pen.fillStyle = "#222222";
  for (const p of points) if (p) pen.fillRect(p[0] - 0.8, p[1] - 0.8, 1.6, 1.6);
  const radius = ranks ? "radius " + values[ranks - 1] : "empty";
  said.textContent = radius + "; Betti numbers " + numbers[ranks] + "; " + ranks + " of " + values.length + " values";
}
let timer = null;
play.addEventListener("click", () => {
  if (timer) { clearInterval(timer); timer = null; play.textContent = "play"; return; }
  if (cut.value === cut.max) cut.value = 0;
  play.textContent = "stop";
  const step = Math.max(1, Math.floor(values.length / 240));
  timer = setInterval(() => {
    cut.value = Math.min(values.length, Number(cut.value) + step);
    draw();
    if (cut.value === cut.max) play.click();
  }, 40);
});
cut.addEventListener("input", draw);
draw();
