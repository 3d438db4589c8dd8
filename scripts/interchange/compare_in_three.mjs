// node compare_in_three.mjs NODE_MODULES FILE.usda TABLE.csv CAMERAS.json: loads FILE with three.js' USDLoader and compares it
// with carom's data of the same shot: the number of meshes, cameras and lights with the prims of the file, the pose of every
// object with TABLE (carom export TABLE.csv --rate N), frame by frame, and the cameras with CAMERAS (carom export
// CAMERAS.json). Prints differences and exits with 1 if there are any.
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [modules, file, table, cameraFile] = process.argv.slice(2);
const library = (name) => import(pathToFileURL(path.join(path.resolve(modules), "three", name)));
const THREE = await library("build/three.module.js");
const { USDLoader } = await library("examples/jsm/loaders/USDLoader.js");

// The linear keys are within 0.05 mm and 2 mrad of the motion (docs/export.md); the rest is for single precision.
const FARTHEST = 1e-4; // m
const MOST_TURNED = 3e-3; // rad

const usda = fs.readFileSync(file, "utf8");
const scene = new USDLoader().parse(usda);
const problems = [];

const prims = (types) => [...usda.matchAll(/^ *def (\w+) "/gm)].filter((found) => types.includes(found[1])).length;
const loaded = { meshes: 0, cameras: 0, lights: 0 };
const named = new Map();
scene.traverse((object) => {
  named.set(object.name, object);
  loaded.meshes += object.isMesh ? 1 : 0;
  loaded.cameras += object.isCamera ? 1 : 0;
  loaded.lights += object.isLight ? 1 : 0;
  if (object.isMesh) {
    const points = object.geometry.getAttribute("position");
    const normals = object.geometry.getAttribute("normal");
    if (!points || points.count === 0 || points.array.some(Number.isNaN)) {
      problems.push(`${object.name}: no points`);
    }
    if (!normals || normals.array.some(Number.isNaN)) {
      problems.push(`${object.name}: no normals`);
    }
  }
});
const written = {
  meshes: prims(["Mesh"]),
  cameras: prims(["Camera"]),
  lights: prims(["RectLight", "SphereLight", "DistantLight"]), // three.js has no DomeLight
};
for (const [kind, number] of Object.entries(written)) {
  if (loaded[kind] !== number) {
    problems.push(`${number} ${kind} are in the file, and ${loaded[kind]} were loaded`);
  }
}
if (written.meshes === 0) {
  problems.push("the file has no mesh");
}

const mixer = new THREE.AnimationMixer(scene);
const actions = scene.animations.map((clip) => mixer.clipAction(clip));
for (const action of actions) {
  action.setLoop(THREE.LoopOnce, 1);
  action.clampWhenFinished = true;
}
function goTo(time) {
  for (const action of actions) {
    action.reset().play(); // the animation may have ended before
  }
  mixer.setTime(time);
}

let farthest = 0;
let mostTurned = 0;
function compare(name, position, turn) {
  const object = named.get(name.replace(/\W/g, "_"));
  if (!object) {
    problems.push(`'${name}' was not loaded`);
    return;
  }
  for (const camera of object.children.filter((child) => child.isCamera)) {
    if (camera.position.length() > 0 || camera.quaternion.w !== 1) {
      problems.push(`the camera of '${name}' is not where its Xform is`);
    }
  }
  farthest = Math.max(farthest, object.position.distanceTo(new THREE.Vector3(...position)));
  const [w, x, y, z] = turn;
  mostTurned = Math.max(mostTurned, object.quaternion.angleTo(new THREE.Quaternion(x, y, z, w).normalize()));
}

const rows = fs.readFileSync(table, "utf8").trim().split("\n").slice(1).map((line) => line.split(","));
const times = [...new Set(rows.map((row) => row[1]))];
for (const time of times) {
  goTo(Number(time));
  for (const row of rows.filter((one) => one[1] === time)) {
    const numbers = row.slice(2).map(Number);
    compare(row[0], numbers.slice(0, 3), numbers.slice(3, 7));
  }
}

let cameraKeys = 0;
for (const camera of JSON.parse(fs.readFileSync(cameraFile, "utf8")).cameras) {
  // While scene time stops, the export keeps only the first camera position.
  const seen = new Set();
  for (const key of camera.keys) {
    if (!seen.has(key.scene_time)) {
      seen.add(key.scene_time);
      goTo(key.scene_time);
      compare(camera.name, key.position, key.orientation);
      cameraKeys += 1;
    }
  }
}

if (farthest > FARTHEST) {
  problems.push(`something is ${farthest} m off`);
}
if (mostTurned > MOST_TURNED) {
  problems.push(`something is turned by ${mostTurned} rad`);
}
for (const problem of [...new Set(problems)]) {
  console.log(`  ${path.basename(file)}: ${problem}`);
}
if (problems.length > 0) {
  process.exit(1);
}
console.log(
  `three.js ${THREE.REVISION}, ${path.basename(file)}: ${loaded.meshes} meshes, ${loaded.cameras} cameras, ` +
    `${loaded.lights} lights; ${times.length} frames and ${cameraKeys} places of cameras within ` +
    `${(1000 * farthest).toFixed(3)} mm and ${mostTurned.toFixed(5)} rad`,
);
