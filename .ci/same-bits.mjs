// Runs the module of .ci/bits and prints its line, as the program does.
//
//     node same-bits.mjs MODULE ROUNDS

import { readFileSync } from "node:fs";

const [path, rounds] = process.argv.slice(2);
const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(path)));
const hash = BigInt.asUintN(64, exports.same_bits(Number(rounds)));
console.log(rounds, String(exports.same_bits_numbers(Number(rounds))), hash.toString(16).padStart(16, "0"));
