// Runs the module of .ci/bits and prints its line, as the program does.
//
//     node same-bits.mjs MODULE [scenes] ROUNDS

import { readFileSync } from "node:fs";

const [path, ...words] = process.argv.slice(2);
const rounds = Number(words.at(-1));
const ofScenes = Number(words[0] === "scenes");
const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(path)));
const hash = BigInt.asUintN(64, exports.same_bits(rounds, ofScenes));
console.log(...words, String(exports.same_bits_numbers(rounds, ofScenes)), hash.toString(16).padStart(16, "0"));
