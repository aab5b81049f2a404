// What is done: time goes on, and people push buttons, drag the picture or come with a link to a moment:
// #time=0.4&overlay&shown=screw&joint=LeftHand&turn=30&tilt=10&zoom=1.5&speed=0.25, angles in degrees, all of them optional.

const $ = id => document.getElementById(id);
const camera = new Camera();
const scene = new Scene($("scene"), camera);
const [start, end] = data.span;
const calm = window.matchMedia("(prefers-reduced-motion: reduce)");
const state = {
  time: start,
  playing: end > start && !calm.matches,
  speed: 1,
  shown: data.tracks[data.shown].name,
  overlay: false,
  traced: data.traced,
  follow: true,
};

/** Takes what a link says. */
function readLink() {
  const link = new URLSearchParams(location.hash.slice(1));
  const number = name => (link.has(name) && link.get(name) !== "" && isFinite(link.get(name)) ? Number(link.get(name)) : null);
  const degrees = name => (number(name) === null ? null : number(name) * Math.PI / 180);
  const time = number("time");
  if (time !== null) {
    state.time = Math.min(Math.max(time, start), end);
    state.playing = false;
  }
  state.overlay = link.has("overlay");
  if (trackNamed(link.get("shown"))) state.shown = link.get("shown");
  const joint = data.names.indexOf(link.get("joint"));
  if (joint >= 0) state.traced = joint;
  camera.turn = degrees("turn") ?? camera.turn;
  camera.tilt = clampTilt(degrees("tilt") ?? camera.tilt);
  camera.zoom = clampZoom(number("zoom") ?? camera.zoom);
  if (number("speed") > 0) state.speed = number("speed");
}

/** A link to what is seen, in the address bar while nothing moves. */
function writeLink() {
  if (state.playing) return;
  const degrees = angle => (angle * 180 / Math.PI).toFixed(1);
  const parts = [`time=${state.time.toFixed(3)}`];
  if (state.overlay) parts.push("overlay", `joint=${encodeURIComponent(data.names[state.traced])}`);
  parts.push(`shown=${state.shown}`, `turn=${degrees(camera.turn)}`, `tilt=${degrees(camera.tilt)}`);
  parts.push(`zoom=${camera.zoom.toFixed(2)}`);
  try {
    history.replaceState(null, "", `#${parts.join("&")}`);
  } catch {
    // Some browsers have no history for files; a link is not worth an error.
  }
}

const clampTilt = tilt => Math.min(Math.max(tilt, -0.2), Math.PI / 2);
const clampZoom = zoom => Math.min(Math.max(zoom, 0.1), 20);

/** Puts the controls and the picture where the state is. */
function show() {
  $("time").value = state.time;
  $("clock").value = `${state.time.toFixed(2)} of ${end.toFixed(2)} s`;
  $("play").textContent = state.playing ? "Pause" : "Play";
  $("overlay").checked = state.overlay;
  $("follow").checked = state.follow;
  $("shown").value = state.shown;
  $("shown").disabled = state.overlay;
  $("traced").value = state.traced;
  $("speed").value = state.speed;
  for (const id of ["legend", "tracing", "apart"]) $(id).hidden = !state.overlay;
  if (state.overlay) showDistances();
  scene.draw(state);
}

/** How far apart the three ways are now, in the file's unit. */
function showDistances() {
  const poses = COMPARED.map(name => poseAt(trackNamed(name), state.time));
  let farthest = [0, 0];
  for (const [a, b] of [[0, 1], [1, 2], [2, 0]]) {
    poses[a].forEach((point, i) => {
      const distance = Math.hypot(...point.map((x, axis) => x - poses[b][i][axis]));
      if (distance > farthest[0]) farthest = [distance, i];
    });
  }
  const [distance, point] = farthest;
  const length = distance * data.size;
  $("apart").textContent = distance > 1e-6 ? `Now ${length.toPrecision(2)} apart at most, at ${data.names[point]}` : "Now at the same place";
}

function drawMarks() {
  const canvas = $("marks");
  const ratio = window.devicePixelRatio || 1;
  canvas.width = canvas.clientWidth * ratio;
  canvas.height = canvas.clientHeight * ratio;
  const pen = canvas.getContext("2d");
  pen.fillStyle = scene.color("faint");
  // The middle of the slider's thumb stays this far away from the ends.
  const inset = 8 * ratio;
  if (data.keys.length * 3 > canvas.clientWidth) return;
  for (const key of data.keys) {
    const place = end > start ? (key - start) / (end - start) : 0;
    pen.fillRect(inset + place * (canvas.width - 2 * inset) - ratio / 2, 0, ratio, canvas.height);
  }
}

/** Fills what depends on the data alone. */
function build() {
  $("title").textContent = data.title;
  $("summary").textContent = data.summary;
  Object.assign($("time"), { min: start, max: end, disabled: end === start });
  $("play").disabled = end === start;
  tracks.forEach(({ name }) => $("shown").add(new Option(name)));
  data.names.forEach((name, index) => $("traced").add(new Option(name, index)));
  for (const name of COMPARED) {
    const item = document.createElement("li");
    const line = document.createElement("i");
    line.style.cssText = `background: var(--${name}); height: ${WIDTHS[name] * 320}px`;
    item.append(line, name);
    $("legend").append(item);
  }
  if (![...$("speed").options].some(option => Number(option.value) === state.speed)) $("speed").add(new Option(state.speed));
}

let last = null;
function tick(now) {
  if (state.playing) {
    const passed = last === null ? 0 : Math.min(now - last, 100) / 1000 * state.speed;
    state.time += passed;
    if (state.time > end) state.time = start + (state.time - end) % Math.max(end - start, 1e-9);
    show();
    last = now;
    requestAnimationFrame(tick);
  } else {
    last = null;
  }
}

function play(playing) {
  const idle = !state.playing;
  state.playing = playing;
  if (playing && idle) requestAnimationFrame(tick);
  change();
}

/** Shows what has changed. */
function change(what) {
  Object.assign(state, what);
  show();
  writeLink();
}

function listen() {
  $("play").onclick = () => play(!state.playing);
  $("time").oninput = () => {
    state.time = Number($("time").value);
    play(false);
  };
  $("speed").onchange = () => change({ speed: Number($("speed").value) });
  $("shown").onchange = () => change({ shown: $("shown").value });
  $("traced").onchange = () => change({ traced: Number($("traced").value) });
  $("overlay").onchange = () => change({ overlay: $("overlay").checked });
  $("follow").onchange = () => change({ follow: $("follow").checked });
  $("scene").onpointerdown = event => $("scene").setPointerCapture(event.pointerId);
  $("scene").onpointermove = event => {
    if (!$("scene").hasPointerCapture(event.pointerId)) return;
    camera.turn += event.movementX * 0.008;
    camera.tilt = clampTilt(camera.tilt + event.movementY * 0.008);
    change();
  };
  $("scene").addEventListener("wheel", event => {
    event.preventDefault();
    camera.zoom = clampZoom(camera.zoom * Math.exp(-event.deltaY * 0.0012));
    change();
  }, { passive: false });
  window.onkeydown = event => {
    if (event.key !== " " || ["BUTTON", "SELECT", "INPUT"].includes(event.target.tagName)) return;
    event.preventDefault();
    play(!state.playing);
  };
  window.onresize = () => {
    drawMarks();
    show();
  };
  window.onhashchange = () => {
    readLink();
    show();
  };
  window.matchMedia("(prefers-color-scheme: dark)").onchange = window.onresize;
}

readLink();
build();
listen();
drawMarks();
show();
if (state.playing) requestAnimationFrame(tick);
