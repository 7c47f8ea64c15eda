// node plain.mjs PROGRAM.wasm PLAIN.js OUT SECONDS...: writes pictures, 320x180 in quality `film`, as browsers without
// relaxed SIMD draw them. Node 20 has no relaxed SIMD either.
import { readFileSync, writeFileSync } from 'node:fs'

const [program, script, out, ...seconds] = process.argv.slice(2)
const plain = new Function(readFileSync(script, 'utf8') + '; return plain')()
const module = new WebAssembly.Module(plain(readFileSync(program)))
const x = new WebAssembly.Instance(module, { env: { progress() {} } }).exports
x.load(320, 180, 0)
for (const t of seconds) {
  const rgba = new Uint8Array(x.memory.buffer, x.picture(+t, 0, 0, 0), 320 * 180 * 4)
  const rgb = rgba.filter((_, i) => i % 4 != 3)
  writeFileSync(`${out}/${t}.ppm`, Buffer.concat([Buffer.from('P6\n320 180\n255\n'), rgb]))
}
