// node open_in_tinyusdz.mjs NODE_MODULES FILE.usda...: checks that TinyUSDZ, a reader that checks the grammar and the types of
// all attributes, reads every file and finds as many meshes as the file defines. Otherwise prints the problem and exits with 1.
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [modules, ...files] = process.argv.slice(2);
const folder = path.join(path.resolve(modules), "tinyusdz");
// TinyUSDZ is built only for browsers: it checks that a window exists and that this is not node.
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
