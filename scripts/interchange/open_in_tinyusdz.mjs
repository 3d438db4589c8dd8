// node open_in_tinyusdz.mjs NODE_MODULES FILE.usda...: every file is USD to TinyUSDZ, a reader that checks the grammar and the
// types of all attributes, and has as many meshes there as are written in it. Exit code 1, and what is wrong, otherwise.
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [modules, ...files] = process.argv.slice(2);
const folder = path.join(path.resolve(modules), "tinyusdz");
// It is built for browsers alone: what it looks for there is a window, and that this is not node.
process.type = "renderer";
globalThis.window = globalThis;
const { default: load } = await import(pathToFileURL(path.join(folder, "tinyusdz.js")));
const reader = await load({ wasmBinary: fs.readFileSync(path.join(folder, "tinyusdz.wasm")) });

for (const file of files) {
  const text = fs.readFileSync(file);
  const written = text.toString().match(/^ *def Mesh "/gm).length;
  const usd = new reader.TinyUSDZLoaderNative();
  if (!usd.loadFromBinary(new Uint8Array(text), path.basename(file))) {
    console.log(`  ${path.basename(file)}: ${usd.error()}`);
    process.exit(1);
  }
  if (usd.numMeshes() !== written) {
    console.log(`  ${path.basename(file)}: ${written} meshes are in the file, and ${usd.numMeshes()} were loaded`);
    process.exit(1);
  }
  console.log(`TinyUSDZ, ${path.basename(file)}: ${written} meshes`);
}
