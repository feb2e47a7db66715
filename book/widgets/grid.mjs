// Asks built modules what the native program was asked, and requires the same answers, bit for bit.
//
//     node grid.mjs GRID FOLDER MODULE...

import { readFileSync } from "node:fs";
import path from "node:path";

const [grid, folder, ...names] = process.argv.slice(2);

const double = new DataView(new ArrayBuffer(8));
const number = (bits) => {
  if (bits === "nan") return NaN;
  double.setBigUint64(0, BigInt(`0x${bits}`));
  return double.getFloat64(0);
};
const bits = (number) => {
  if (Number.isNaN(number)) return "nan";
  double.setFloat64(0, number);
  return double.getBigUint64(0).toString(16).padStart(16, "0");
};

const modules = new Map();
let record = { bytes: new Uint8Array(), at: 0 };
for (const name of names) {
  const bytes = readFileSync(path.join(folder, `${name}.wasm`));
  const instance = new WebAssembly.Instance(new WebAssembly.Module(bytes), {
    page: {
      more(address, room) {
        const piece = record.bytes.subarray(record.at, record.at + room);
        new Uint8Array(instance.exports.memory.buffer).set(piece, address);
        record.at += piece.length;
        return piece.length;
      },
    },
  });
  modules.set(name, instance.exports);
}

const asked = new Map(names.map((name) => [name, 0]));
for (const line of readFileSync(grid, "utf8").trim().split("\n")) {
  const native = JSON.parse(line);
  const module = modules.get(native.module);
  if (!module) throw new Error(`the grid asks ${native.module}, which is not built`);
  if (native.file) record = { bytes: readFileSync(native.file), at: 0 };
  const row = () => new Float64Array(module.memory.buffer, module.numbers());
  native.asked.forEach((bits, place) => { row()[place] = number(bits); });
  const count = module.answer(native.what);
  const found = native.file ? count : Array.from(row().subarray(0, count), bits).join();
  const said = native.said === null ? null : new TextDecoder().decode(
    new Uint8Array(module.memory.buffer, module.text(), module.text_length()));
  if (found !== (native.file ? native.count : native.found.join()) || said !== native.said) {
    console.error(`${folder}/${native.module}.wasm answers otherwise than the library.\nnative: ${line}`);
    console.error(`module: ${found}\n        ${said}`);
    process.exit(1);
  }
  asked.set(native.module, asked.get(native.module) + 1);
}
for (const [name, count] of asked) {
  if (count === 0) throw new Error(`the grid asks ${name} nothing`);
}
console.log(`${path.basename(folder)}: ${[...asked].map(([name, n]) => `${name} ${n}`).join(", ")} answers, bit for bit the library's`);
