// Judges the glTF files that `endless` writes by Khronos's own validator.
//
//   npm install --prefix target/judge gltf-validator@2.0.0-dev.3.10
//   node scripts/judge_gltf.mjs [ENDLESS [NAME-FILTER]]
//
// Exports every asset of `endless assets list`, and one map, and prints what the validator finds. Exit code 1 if there is
// an error or a warning in any of them.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const modules = process.env.GLTF_VALIDATOR ?? "target/judge";
const { validateBytes } = createRequire(resolve(modules, "package.json"))("gltf-validator");

const endless = process.argv[2] ?? "target/release/endless";
const filter = process.argv[3] ?? "";
const folder = mkdtempSync(join(tmpdir(), "judge-gltf-"));
const file = join(folder, "it.glb");

const run = (...args) => execFileSync(endless, args, { encoding: "utf8", maxBuffer: 1 << 28 });
const names = run("assets", "list").split("\n").slice(1).map((line) => line.split(" ")[0]).filter((name) => name !== "" && name.includes(filter));

const totals = { files: 0, errors: 0, warnings: 0, infos: 0 };
const judge = async (name, args) => {
  run(...args);
  const { issues } = await validateBytes(new Uint8Array(readFileSync(file)), { maxIssues: 20 });
  totals.files += 1;
  totals.errors += issues.numErrors;
  totals.warnings += issues.numWarnings;
  totals.infos += issues.numInfos;
  for (const issue of issues.messages.filter((m) => m.severity < 2)) {
    console.log(`${name}: ${issue.code} ${issue.message} at ${issue.pointer}`);
  }
};

for (const name of names) {
  for (const variant of ["0", "3"]) {
    await judge(name, ["assets", "export", name, "--variant", variant, "--out", file]);
  }
}
if (filter === "") await judge("Town02", ["maps", "export", "Town02", "--gltf", file]);
rmSync(folder, { recursive: true });
console.log(`${totals.files} files: ${totals.errors} errors, ${totals.warnings} warnings, ${totals.infos} notes`);
process.exit(totals.errors + totals.warnings > 0 ? 1 : 0);
