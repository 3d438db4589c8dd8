// node validate.js FILE.glb NAME: prints all messages of the validator and exits with 1 if there are any.
const fs = require("fs");
const validator = require("gltf-validator");

const [file, name] = process.argv.slice(2);
validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { maxIssues: 20 }).then((report) => {
  const issues = report.issues;
  const found = issues.numErrors + issues.numWarnings + issues.numInfos + issues.numHints;
  console.log(`${name}: ${report.info.totalTriangleCount} triangles, ${found} issues`);
  for (const message of issues.messages) {
    console.log(`  ${message.code} ${message.pointer}: ${message.message}`);
  }
  process.exit(found === 0 ? 0 : 1);
});
