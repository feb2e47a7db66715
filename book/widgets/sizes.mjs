// Prints what the built modules weigh, and fails if they weigh too much. Before compression; what a page takes is packed.
//
//     node sizes.mjs FOLDER MODULE...

import { readFileSync, statSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";

const MOST = { "two-arrows": 5_000, judge: 482_000 };
// Without the judge, which reads files of any kind and size. Each has the words of all errors, and what steps has all kinds of torques.
const MOST_TOGETHER = 246_000;
const [folder, ...names] = process.argv.slice(2);

let together = 0;
console.log("| module | bytes | compressed |\n|---|---:|---:|");
for (const name of names) {
  const file = path.join(folder, `${name}.wasm`);
  const { size } = statSync(file);
  console.log(`| ${name} | ${size} | ${gzipSync(readFileSync(file)).length} |`);
  if (name !== "judge") together += size;
  if (size > (MOST[name] ?? Infinity)) {
    console.error(`${file}: ${size} bytes are more than ${MOST[name]}`);
    process.exitCode = 1;
  }
}
console.log(`| all but the judge | ${together} | |`);
if (together > MOST_TOGETHER) {
  console.error(`${together} bytes are more than ${MOST_TOGETHER}`);
  process.exitCode = 1;
}
