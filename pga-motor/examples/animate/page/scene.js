// What is seen: poses, the camera and the drawing. Lengths are in the page's unit, in which the figure is about 1 in size.

const data = JSON.parse(document.getElementById("data").textContent);
const COMPARED = ["nlerp", "screw", "split"];
// Where the ways agree, all three show: the later ones are drawn thinner, on top.
const WIDTHS = { nlerp: 0.028, screw: 0.017, split: 0.007 };
const DASHES = { nlerp: [], screw: [10, 5], split: [2, 5] };
const BONE = 0.02;
const NEAREST = 0.05;
const AWAY = 3.4;
const SHADES = 8;
// Seconds of a path before now and after.
const AROUND = 2;

const tracks = data.tracks.map(({ name, points }) => {
  const bytes = Uint8Array.from(atob(points), c => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return { name, numbers: Float32Array.from({ length: bytes.length / 4 }, (_, i) => view.getFloat32(4 * i, true)) };
});
const trackNamed = name => tracks.find(track => track.name === name);
const pointCount = data.names.length;

/** Where all points of a track are at a time in seconds. */
function poseAt(track, time) {
  const [start, end] = data.span;
  const last = data.pose_count - 1;
  const place = end > start ? Math.min(Math.max((time - start) / (end - start), 0), 1) * last : 0;
  const before = Math.min(Math.floor(place), Math.max(last - 1, 0));
  const after = Math.min(before + 1, last);
  // Between two poses straight, but a figure that steps does so.
  const part = track.name === "step" ? Math.floor(place - before + 1e-9) : place - before;
  const number = (pose, i) => track.numbers[pose * pointCount * 3 + i];
  const mix = i => number(before, i) + part * (number(after, i) - number(before, i));
  return Array.from({ length: pointCount }, (_, point) => [mix(3 * point), mix(3 * point + 1), mix(3 * point + 2)]);
}

/** Where one point is in the poses of a track around a time. */
function pathOf(track, point, time) {
  const [start, end] = data.span;
  const last = data.pose_count - 1;
  const poseOf = time => Math.round(end > start ? Math.min(Math.max((time - start) / (end - start), 0), 1) * last : 0);
  const [first, final] = [poseOf(time - AROUND), poseOf(time + AROUND)];
  return Array.from({ length: final - first + 1 }, (_, pose) => {
    const at = 3 * ((first + pose) * pointCount + point);
    return Array.from(track.numbers.subarray(at, at + 3));
  });
}

/** Half as high as the figure is when it begins. */
const halfHeight = Math.max(...poseAt(tracks[data.shown], data.span[0]).map(([, y]) => y)) / 2;

/** Looks at a target from a distance; turn and tilt in radians. */
class Camera {
  constructor() {
    Object.assign(this, { turn: data.turn, tilt: data.tilt, zoom: 1, target: [0, 0, 0] });
  }

  /** For a picture of this size in pixels. */
  frame(width, height) {
    this.center = [width / 2, height * 0.47];
    this.distance = AWAY / this.zoom;
    this.scale = Math.min(width, height) * 0.6;
  }

  /** Right, up, towards us. */
  see([x, y, z]) {
    const [tx, ty, tz] = this.target;
    const [dx, dy, dz] = [x - tx, y - ty, z - tz];
    const [c, s, ct, st] = [Math.cos(this.turn), Math.sin(this.turn), Math.cos(this.tilt), Math.sin(this.tilt)];
    const towards = c * dz - s * dx;
    return [c * dx + s * dz, ct * dy - st * towards, st * dy + ct * towards];
  }

  /** Pixels for one unit of length at a depth. */
  scaleAt(depth) {
    return this.scale * AWAY / (this.distance - depth);
  }

  place([right, up, depth]) {
    const scale = this.scaleAt(depth);
    return [this.center[0] + right * scale, this.center[1] - up * scale];
  }

  /** The ends of a line in pixels and how deep its middle is; nothing for what is behind us. */
  line(from, to) {
    let [a, b] = [this.see(from), this.see(to)];
    const limit = this.distance - NEAREST;
    if (a[2] > limit && b[2] > limit) return null;
    const cut = (near, far) => {
      const part = (limit - far[2]) / (near[2] - far[2]);
      return far.map((x, i) => x + part * (near[i] - x));
    };
    if (a[2] > limit) a = cut(a, b);
    if (b[2] > limit) b = cut(b, a);
    return { ends: [this.place(a), this.place(b)], depth: (a[2] + b[2]) / 2 };
  }
}

/** Draws on a canvas whose size follows the window. */
class Scene {
  constructor(canvas, camera) {
    Object.assign(this, { canvas, camera, pen: canvas.getContext("2d"), colors: {} });
  }

  color(name) {
    this.colors[name] ??= getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
    return this.colors[name];
  }

  /** state: time, shown, overlay, traced, follow. */
  draw(state) {
    const { canvas, pen, camera } = this;
    this.colors = {};
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.lineCap = pen.lineJoin = "round";
    const shown = trackNamed(state.shown);
    const figures = (state.overlay ? COMPARED.map(trackNamed) : [shown]).map(track => [track, poseAt(track, state.time)]);
    const [x, , z] = poseAt(shown, state.follow ? state.time : data.span[0])[0];
    camera.target = [x, halfHeight, z];
    camera.frame(width, height);
    this.drawGround();
    for (const [, pose] of figures) this.drawShadow(pose);
    if (state.overlay) {
      for (const [track] of figures) this.drawPath(track, state.traced, state.time);
      for (const [track, pose] of figures) this.drawOutline(track.name, pose);
      for (const [track, pose] of figures) this.drawDot(this.color(track.name), pose[state.traced], 5);
    } else {
      this.drawFigure(figures[0][1]);
    }
  }

  stroke(line, width, color) {
    this.strokeAll([line], width, color);
  }

  strokeAll(lines, width, color) {
    const { pen } = this;
    pen.lineWidth = width;
    pen.strokeStyle = color;
    pen.beginPath();
    for (const line of lines) {
      if (!line) continue;
      pen.moveTo(...line.ends[0]);
      pen.lineTo(...line.ends[1]);
    }
    pen.stroke();
  }

  /** Lines that stand still in the world, around the target and fading away from it. */
  drawGround() {
    const { spacing } = data;
    const [tx, , tz] = this.camera.target;
    const reach = Math.ceil(3 / spacing);
    const [cx, cz] = [Math.round(tx / spacing), Math.round(tz / spacing)];
    const at = (i, j) => [i * spacing, 0, j * spacing];
    // As few strokes as there are shades, for each of two colours.
    const shades = Array.from({ length: 2 * SHADES }, () => []);
    const add = (index, far, from, to) => {
      const fade = Math.ceil(Math.min(1, 1.6 * (1 - far)) * SHADES) - 1;
      if (fade >= 0) shades[2 * fade + (index % 5 === 0 ? 1 : 0)].push(this.camera.line(from, to));
    };
    for (let line = -reach; line <= reach; line++) {
      for (let cell = -reach; cell < reach; cell++) {
        const far = Math.hypot(line, cell + 0.5) / reach;
        add(cx + line, far, at(cx + line, cz + cell), at(cx + line, cz + cell + 1));
        add(cz + line, far, at(cx + cell, cz + line), at(cx + cell + 1, cz + line));
      }
    }
    shades.forEach((lines, shade) => {
      this.pen.globalAlpha = (Math.floor(shade / 2) + 1) / SHADES;
      this.strokeAll(lines, 1, this.color(shade % 2 ? "strong" : "grid"));
    });
    this.pen.globalAlpha = 1;
  }

  /** The figure laid flat on the ground by a sun straight above. */
  drawShadow(pose) {
    const flat = ([x, , z]) => [x, 0, z];
    const lines = data.bones.map(([from, to]) => this.camera.line(flat(pose[from]), flat(pose[to])));
    this.strokeAll(lines, BONE * this.camera.scaleAt(0), this.color("shadow"));
  }

  /** Bones in the colours of their sides, joints and heads, the far ones first. */
  drawFigure(pose) {
    const { camera, pen } = this;
    const shapes = [];
    // A dot lies on the bones that meet in it.
    const depths = pose.map(point => camera.see(point)[2]);
    for (const [from, to, side] of data.bones) {
      const line = camera.line(pose[from], pose[to]);
      for (const end of [from, to]) depths[end] = Math.max(depths[end], line?.depth ?? -Infinity);
      if (line) shapes.push([line.depth, () => this.stroke(line, BONE * camera.scaleAt(line.depth), this.color(side))]);
    }
    const [ink, paper] = [this.color("middle"), this.color("paper")];
    pose.slice(0, data.joint_count).forEach((point, joint) => {
      const seen = camera.see(point);
      if (seen[2] > camera.distance - NEAREST) return;
      shapes.push([depths[joint], () => this.drawCircle(camera.place(seen), BONE * 0.62 * camera.scaleAt(seen[2]), ink, paper, 1.5)]);
    });
    for (const head of data.heads) {
      const circle = this.headCircle(pose, head);
      if (circle) shapes.push([circle.depth, () => this.drawCircle(circle.middle, circle.radius, ink, paper, circle.width)]);
    }
    shapes.sort((a, b) => a[0] - b[0]).forEach(([, draw]) => draw());
    pen.globalAlpha = 1;
  }

  /** The whole figure in one colour. */
  drawOutline(name, pose) {
    const { camera } = this;
    const color = this.color(name);
    const width = line => Math.max(1, WIDTHS[name] * camera.scaleAt(line.depth));
    for (const [from, to] of data.bones) {
      const line = camera.line(pose[from], pose[to]);
      if (line) this.stroke(line, width(line), color);
    }
    for (const head of data.heads) {
      const circle = this.headCircle(pose, head);
      if (circle) this.drawCircle(circle.middle, circle.radius, color, null, width(circle));
    }
  }

  headCircle(pose, [bottom, top]) {
    const line = this.camera.line(pose[bottom], pose[top]);
    if (!line) return null;
    const [[x1, y1], [x2, y2]] = line.ends;
    const scale = this.camera.scaleAt(line.depth);
    const length = Math.hypot(...pose[top].map((x, i) => x - pose[bottom][i]));
    return { middle: [(x1 + x2) / 2, (y1 + y2) / 2], radius: length * 0.5 * scale, width: BONE * 0.8 * scale, depth: line.depth };
  }

  drawPath(track, point, time) {
    const { pen } = this;
    pen.strokeStyle = this.color(track.name);
    pen.lineWidth = 2;
    pen.setLineDash(DASHES[track.name]);
    pen.beginPath();
    const path = pathOf(track, point, time);
    for (let pose = 1; pose < path.length; pose++) {
      const line = this.camera.line(path[pose - 1], path[pose]);
      if (!line) continue;
      if (pose === 1) pen.moveTo(...line.ends[0]);
      pen.lineTo(...line.ends[1]);
    }
    pen.stroke();
    pen.setLineDash([]);
  }

  drawDot(color, point, radius) {
    const seen = this.camera.see(point);
    if (seen[2] < this.camera.distance - NEAREST) this.drawCircle(this.camera.place(seen), radius, this.color("paper"), color, 1.5);
  }

  drawCircle([x, y], radius, stroke, fill, width) {
    const { pen } = this;
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    if (fill) {
      pen.fillStyle = fill;
      pen.fill();
    }
    pen.lineWidth = width;
    pen.strokeStyle = stroke;
    pen.stroke();
  }
}
